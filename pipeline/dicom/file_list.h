// The files at a place, and what they are called before a person.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vallecula::pipeline {

/// What lies at the place that a person gave. Throws SeriesError, without its name, when there is nothing.
std::filesystem::file_status status_of_place(const std::filesystem::path& place);

/// A file's own name often holds a patient's name, number or a UID. So a file is told by its place in the order of
/// names ("file 12 of 90"); its name follows only when it is made of the usual words and small numbers (IM-0001-0012).
class FileList {
 public:
  /// One file, or all files of a folder down to kFolderDepth subfolders, in the order of their relative paths; hidden
  /// ones and DICOMDIR left out. Throws SeriesError.
  explicit FileList(const std::filesystem::path& place);

  int count() const { return static_cast<int>(files_.size()); }
  bool is_folder() const { return is_folder_; }
  const std::filesystem::path& path(int file) const { return files_[static_cast<std::size_t>(file)]; }
  std::string name(int file) const;

 private:
  std::vector<std::filesystem::path> files_;
  bool is_folder_ = false;
};

/// Is this file name free of what could identify a person?
bool is_neutral_file_name(const std::string& name);
/// What a single file is called in messages: its name when it is neutral, else "(name withheld)"; never its folders.
std::string told_name(const std::filesystem::path& file);

}  // namespace vallecula::pipeline
