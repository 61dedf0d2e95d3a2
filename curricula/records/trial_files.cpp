#include "curricula/records/trial_files.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <system_error>

#include "curricula/trial_log.h"

namespace vallecula::curricula {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> pictures_in(const fs::path& folder, std::initializer_list<const char*> beginnings) {
  std::vector<fs::path> pictures;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool ours = std::any_of(beginnings.begin(), beginnings.end(),
                                  [&name](const char* beginning) { return name.rfind(beginning, 0) == 0; });
    if (ours && entry.path().extension() == ".png" && entry.is_regular_file(error)) pictures.push_back(entry.path());
  }
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

}  // namespace

std::vector<fs::path> screenshots_in(const fs::path& folder) { return pictures_in(folder, {"operator-", "sagittal-"}); }

std::vector<fs::path> files_of_trial(const fs::path& log) {
  const fs::path folder = log.parent_path();
  std::vector<fs::path> candidates{fs::path(log).replace_extension(".tool.ply"),
                                   fs::path(log).replace_extension(".fault.csv")};
  if (log.filename() == "trial.vtrial") {
    candidates = pictures_in(folder, {"operator-", "sagittal-", "replay-"});
    for (const char* name : {"score.json", "report.html", "force.png", "fault.csv", "tool.ply"})
      candidates.push_back(folder / name);
  }
  candidates.push_back(log.string() + ".damaged");
  if (!is_being_written(log)) candidates.push_back(log.string() + ".part");
  candidates.push_back(log);
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::path& file : candidates) {
    if (fs::exists(fs::symlink_status(file, error))) files.push_back(file);
  }
  return files;
}

}  // namespace vallecula::curricula
