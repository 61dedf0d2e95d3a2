// What lies beside a trial's log for people and other programs to read.
#pragma once

#include <filesystem>

#include "curricula/score/score.h"

namespace vallecula::gui {

/// FOLDER/score.json, force.png and report.html of the trial in FOLDER, each written whole. Needs a QGuiApplication
/// (fonts). Throws std::runtime_error naming the file.
void write_results(const std::filesystem::path& folder, const curricula::TrialLog& log,
                   const curricula::Scenario& scenario, const curricula::Score& score);

}  // namespace vallecula::gui
