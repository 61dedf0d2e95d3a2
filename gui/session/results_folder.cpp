#include "gui/session/results_folder.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "curricula/records/trial_files.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

ResultsFolder::ResultsFolder(const fs::path& folder) : folder_(fs::absolute(folder).lexically_normal()) {
  if (folder.empty()) throw std::runtime_error("no folder for the results was given");
  if (!folder_.has_filename()) folder_ = folder_.parent_path();  // a trailing slash
  const std::string name = folder_.string();
  if (fs::exists(folder_) && !fs::is_directory(folder_)) {
    throw std::runtime_error(name + ": is a file, not a folder; choose another folder for the results");
  }
  for (fs::path missing = folder_; !missing.empty() && !fs::exists(missing); missing = missing.parent_path()) {
    created_.push_back(missing);
  }
  try {
    for (auto missing = created_.rbegin(); missing != created_.rend(); ++missing) fs::create_directory(*missing);
  } catch (const fs::filesystem_error& error) {
    for (const fs::path& made : created_) ::rmdir(made.c_str());
    throw std::runtime_error(name + ": the folder for the results cannot be created (" + error.code().message() +
                             "); choose one you may write to");
  }
  const bool holds_trial = fs::exists(log()) || fs::exists(unfinished_log());
  const std::vector<fs::path> present = curricula::files_of_trial(log());
  if (!holds_trial && !present.empty()) {
    throw std::runtime_error(name + ": holds a " + present.front().filename().string() +
                             " that is no earlier trial's and would be overwritten; choose another folder");
  }
  // Asked by doing: permission bits say nothing about a read-only disk.
  std::string probe = (folder_ / ".vallecula-XXXXXX").string();
  const int file = ::mkstemp(probe.data());
  if (file < 0) {
    const std::string cause = std::strerror(errno);
    for (const fs::path& made : created_) ::rmdir(made.c_str());
    throw std::runtime_error(name + ": cannot be written to (" + cause + "); choose a folder you may write to");
  }
  ::close(file);
  ::unlink(probe.c_str());
}

ResultsFolder::~ResultsFolder() {
  for (const fs::path& made : created_) {
    if (::rmdir(made.c_str()) != 0) break;  // it holds something now: that is what it was made for
  }
}

void ResultsFolder::remove_older_trial() const {
  for (const fs::path& file : curricula::files_of_trial(log())) {
    std::error_code error;
    fs::remove(file, error);
    if (error) {
      throw std::runtime_error(file.string() + ": the earlier trial's file cannot be replaced (" + error.message() +
                               "); choose another folder");
    }
  }
}

}  // namespace vallecula::gui
