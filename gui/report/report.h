// The report of one trial as a page that any browser opens.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "curricula/score/score.h"
#include "gui/report/figure_row.h"

namespace vallecula::gui {

/// How often a trial was paused and for what, "2 times (unplugged, motor warm)". Only of a score with pauses.
std::string pauses_in_words(const curricula::Score& score);

/// One sentence for a person: passed or not, and the figures that matter most.
std::string summary_sentence(const curricula::Score& score, const curricula::Scenario& scenario);

/// The report's figures with what was demanded of them.
std::vector<Row> report_rows(const curricula::Score& score, const curricula::TrialLog& log,
                             const curricula::Scenario& scenario);

/// Writes FOLDER/report.html whole: summary, reasons, figures with their limits, FOLDER/force.png inside the page, and
/// the screenshots operator-*.png and sagittal-*.png that lie in the folder by then (call again after adding some).
/// Throws std::runtime_error naming the file.
void write_report(const std::filesystem::path& folder, const curricula::TrialLog& log,
                  const curricula::Scenario& scenario, const curricula::Score& score);

}  // namespace vallecula::gui
