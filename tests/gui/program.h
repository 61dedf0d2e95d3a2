// Runs the built program as a person would, and keeps what it said.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vallecula::gui::test {

struct Outcome {
  int exit_code = -1;  ///< -1: killed by a signal
  std::string out, err;
  /// Lines of stderr that begin with "vallecula: ".
  std::vector<std::string> messages() const;
};

/// A folder of its own for one test, gone afterwards; the program keeps its user's data in it too (VALLECULA_HOME).
class Sandbox {
 public:
  Sandbox();
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path home() const { return folder_ / "home"; }

  /// `vallecula ARGUMENTS...`, without a display. `environment`: further NAME=VALUE.
  Outcome run(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {}) const;
  /// The same, not waited for: its process id, for wait().
  pid_t start(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {},
              unsigned long file_size_limit = 0) const;
  Outcome wait(pid_t process) const;
  /// The same on a disk that is full after `bytes` of any one file (RLIMIT_FSIZE).
  Outcome run_on_full_disk(const std::vector<std::string>& arguments, unsigned long bytes) const;
  /// Names in FOLDER of the sandbox, sorted.
  std::vector<std::string> names(const std::string& folder) const;

 private:
  std::filesystem::path folder_;
};

std::string text_of(const std::filesystem::path& file);

}  // namespace vallecula::gui::test
