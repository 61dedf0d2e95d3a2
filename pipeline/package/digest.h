// SHA-256 of files and texts, as lower-case hex.
#pragma once

#include <filesystem>
#include <string>

namespace vallecula::pipeline {

/// Throws std::runtime_error when the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);
std::string sha256_of_text(const std::string& text);

}  // namespace vallecula::pipeline
