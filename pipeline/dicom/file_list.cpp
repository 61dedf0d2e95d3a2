#include "pipeline/dicom/file_list.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/series_error.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

bool is_hidden(const fs::path& file) { return file.filename().string().front() == '.'; }

}  // namespace

bool is_neutral_file_name(const std::string& name) {
  static const std::set<std::string> kUsual = {
      "i",      "im",   "img",    "image", "ct",    "slice",  "sl",        "s",   "se",   "ser",
      "series", "file", "frame",  "dicom", "dcm",   "ima",    "nii",       "gz",  "nrrd", "nhdr",
      "mha",    "mhd",  "volume", "seg",   "label", "labels", "landmarks", "mrk", "json"};
  std::size_t at = 0;
  while (at < name.size()) {
    const auto run = [&](int (*is)(int)) {
      const auto begin = at;
      while (at < name.size() && is(static_cast<unsigned char>(name[at])) != 0) ++at;
      return name.substr(begin, at - begin);
    };
    if (std::isdigit(static_cast<unsigned char>(name[at])) != 0) {
      const auto digits = run(std::isdigit);
      const auto first = std::min(digits.find_first_not_of('0'), digits.size());
      if (digits.size() > 8 || digits.size() - first > 4) return false;  // a number of that length may be a person's
    } else if (std::isalpha(static_cast<unsigned char>(name[at])) != 0) {
      auto word = run(std::isalpha);
      for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      if (kUsual.count(word) == 0) return false;
    } else if (name[at] == '-' || name[at] == '_' || name[at] == '.') {
      ++at;
    } else {
      return false;
    }
  }
  return true;
}

std::string told_name(const fs::path& file) {
  const auto name = file.filename().string();
  return is_neutral_file_name(name) ? name : "(name withheld)";
}

fs::file_status status_of_place(const fs::path& place) {
  std::error_code error;
  const auto status = fs::status(place, error);
  if (error || !fs::exists(status))
    throw SeriesError("series: the folder or file given does not exist; check the name");
  return status;
}

FileList::FileList(const fs::path& place) {
  const auto status = status_of_place(place);
  if (fs::is_regular_file(status)) {
    files_.push_back(place);
    return;
  }
  if (!fs::is_directory(status)) throw SeriesError("series: is neither a folder nor a file; name the series' folder");
  is_folder_ = true;
  std::error_code error;
  fs::recursive_directory_iterator entry(place, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (is_hidden(entry->path())) {
      entry.disable_recursion_pending();
    } else if (entry->is_directory(ignored)) {
      if (entry.depth() + 1 > kFolderDepth) entry.disable_recursion_pending();
    } else if (entry->is_regular_file(ignored) && entry->path().filename() != "DICOMDIR") {
      files_.push_back(entry->path());
      if (count() > kMostFiles) {
        throw SeriesError("series: more than " + std::to_string(kMostFiles) +
                          " files lie in this folder; name the folder of the series itself");
      }
    }
  }
  if (error) throw SeriesError("series: the folder cannot be listed (" + error.message() + "); check the permissions");
  if (files_.empty()) throw SeriesError("series: the folder is empty; name a folder with a CT series");
  std::sort(files_.begin(), files_.end());
}

std::string FileList::name(int file) const {
  const auto own = path(file).filename().string();
  const auto place =
      is_folder_ ? "file " + std::to_string(file + 1) + " of " + std::to_string(count()) : std::string("the file");
  return is_neutral_file_name(own) ? place + " (" + own + ")" : place;
}

}  // namespace vallecula::pipeline
