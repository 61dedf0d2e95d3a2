// Which files a trial leaves behind.
#pragma once

#include <filesystem>
#include <vector>

namespace vallecula::curricula {

/// Of those that are there, what belongs to the log NAME.vtrial: NAME.tool.ply, NAME.fault.csv, and, of the log named
/// trial.vtrial, what else its results folder holds (tool.ply, score.json, report.html, force.png, fault.csv, the
/// pictures operator-*.png, sagittal-*.png and replay-*.png); then NAME.vtrial.damaged, NAME.vtrial.part, unless a writer holds it
/// (is_being_written), and NAME.vtrial itself. The log is last: while it is there, the rest is known to be a trial's.
std::vector<std::filesystem::path> files_of_trial(const std::filesystem::path& log);

/// operator-*.png and sagittal-*.png of a results folder, by name.
std::vector<std::filesystem::path> screenshots_in(const std::filesystem::path& folder);

}  // namespace vallecula::curricula
