// Force over time, for the result page and the report.
#pragma once

#include <QImage>
#include <filesystem>
#include <utility>
#include <vector>

#include "curricula/score/score.h"
#include "gui/report/chart_panel.h"

namespace vallecula::gui {

/// From when to when in the trial the blade was in the mouth, attempt by attempt, pauses included.
std::vector<std::pair<double, double>> attempt_spans(const curricula::Score& score);

/// What the legend calls the force that the device was told: a mouse was told it too, and showed none.
QString displayed_words(const curricula::LogHeader& header);

/// Tongue and gum force as the tissue has them, the force the device was told, and what they are judged by: device
/// limit, the scenario's targets and pass limits (as the bars beside the view have them: judged_lines.h), peak, first
/// sight; below it the fraction of the glottis in sight. Needs a
/// QGuiApplication (fonts), no display. Colours: Okabe and Ito (2008), told apart by colour-blind eyes and, where lines
/// meet, by their dashes too. Readable from kLeastForceChart em in height and about 40 em in width up.
std::vector<ChartLabel> paint_force_chart(QPainter& painter, const ChartForm& form, const curricula::TrialLog& log,
                                          const curricula::Scenario& scenario, const curricula::Score& score);
Chart make_force_chart(const ChartForm& form, const curricula::TrialLog& log, const curricula::Scenario& scenario,
                       const curricula::Score& score);
/// em: of one with and without its title.
constexpr double kLeastForceChart = 22.0, kLeastUntitledForceChart = 18.0;

/// As a picture of a size in pixels, from about 640 x 400 up.
QImage draw_force_chart(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                        const curricula::Score& score, int width = 1600, int height = 900);

/// The same as a PNG, written whole. Throws std::runtime_error naming the file.
void write_force_chart(const std::filesystem::path& png, const curricula::TrialLog& log,
                       const curricula::Scenario& scenario, const curricula::Score& score);

}  // namespace vallecula::gui
