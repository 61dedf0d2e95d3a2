// Files written whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace vallecula::gui {

/// Writes aside (PATH.part), syncs, renames. Throws std::runtime_error naming the file and the cause (disk full, no
/// permission); then neither PATH.part nor a new PATH is left.
void write_file_whole(const std::filesystem::path& path, const std::string& bytes);
/// The file's bytes. Throws std::runtime_error naming it.
std::string read_file(const std::filesystem::path& path);
/// Lower-case hex.
std::string sha256_of_bytes(const std::string& bytes);
std::string sha256_of_file(const std::filesystem::path& path);
/// Of the running program's own file: tells two builds apart.
std::string sha256_of_program();

}  // namespace vallecula::gui
