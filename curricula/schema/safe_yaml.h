// Loads YAML that nobody vouches for (private to the library).
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>

namespace vallecula::curricula {

constexpr std::size_t kLargestYaml = 1u << 20;  ///< bytes

/// The file's bytes. Throws CurriculumError when it cannot be read, is a folder, is larger than kLargestYaml.
std::string read_yaml_file(const std::filesystem::path& file);

/// One document as a tree. Throws CurriculumError, starting with `name` and the line, for broken YAML, more than one
/// document, nesting deeper than a curriculum can need, bytes that are not UTF-8, and for anchors and aliases: they are
/// not needed, and nested ones grow a few lines into gigabytes.
YAML::Node parse_safely(const std::string& text, const std::string& name);

}  // namespace vallecula::curricula
