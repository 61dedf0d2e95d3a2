#include "curricula/records/trial_files.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace vallecula::curricula {

namespace fs = std::filesystem;

std::vector<fs::path> screenshots_in(const fs::path& folder) {
  std::vector<fs::path> pictures;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool ours = name.rfind("operator-", 0) == 0 || name.rfind("sagittal-", 0) == 0;
    if (ours && entry.path().extension() == ".png" && entry.is_regular_file(error)) pictures.push_back(entry.path());
  }
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

std::vector<fs::path> files_of_trial(const fs::path& log) {
  const fs::path folder = log.parent_path();
  std::vector<fs::path> candidates{fs::path(log).replace_extension(".tool.ply"),
                                   fs::path(log).replace_extension(".fault.csv")};
  if (log.filename() == "trial.vtrial") {
    candidates = screenshots_in(folder);
    for (const char* name : {"score.json", "report.html", "force.png", "fault.csv", "tool.ply"})
      candidates.push_back(folder / name);
  }
  candidates.push_back(log.string() + ".part");
  candidates.push_back(log);
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::path& file : candidates) {
    if (fs::exists(fs::symlink_status(file, error))) files.push_back(file);
  }
  return files;
}

}  // namespace vallecula::curricula
