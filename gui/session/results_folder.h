// The folder a trial leaves its results in, and what it may replace there.
#pragma once

#include <filesystem>
#include <vector>

#include "gui/session/placed_tool.h"

namespace vallecula::gui {

class ResultsFolder {
 public:
  /// Creates the folder where it is missing and tries whether it can be written. A folder with an older trial is
  /// accepted (its known files will be replaced); files of the same names without a trial log beside them are somebody
  /// else's: refused. Throws std::runtime_error with one message.
  explicit ResultsFolder(const std::filesystem::path& folder);
  /// Takes away again the folders it created, where nothing was put into them.
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

  /// Removes the known files of an older trial; everything else in the folder stays.
  void remove_older_trial() const;

  std::filesystem::path log() const { return folder_ / "trial.vtrial"; }
  std::filesystem::path unfinished_log() const { return folder_ / "trial.vtrial.part"; }
  std::filesystem::path tool() const { return folder_ / kToolFile; }
  std::filesystem::path score_json() const { return folder_ / "score.json"; }
  std::filesystem::path report() const { return folder_ / "report.html"; }
  std::filesystem::path force_plot() const { return folder_ / "force.png"; }
  std::filesystem::path fault_csv() const { return folder_ / "fault.csv"; }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> created_;  ///< innermost first
};

}  // namespace vallecula::gui
