// What the monitor showed over a trial with an intubation, for the report and the result page.
#pragma once

#include <QImage>

#include "curricula/score/score.h"
#include "gui/report/chart_panel.h"

namespace vallecula::gui {

/// Saturation as displayed and as it really was, heart rate, and the fraction of the glottis in sight, with attempts,
/// breaths, the cords passed, the oesophagus, and the detector's change of colour. As paint_force_chart otherwise.
/// Needs score.intubation and a log with an intubation; throws std::logic_error without.
std::vector<ChartLabel> paint_monitor_chart(QPainter& painter, const ChartForm& form, const curricula::TrialLog& log,
                                            const curricula::Scenario& scenario, const curricula::Score& score);
Chart make_monitor_chart(const ChartForm& form, const curricula::TrialLog& log, const curricula::Scenario& scenario,
                         const curricula::Score& score);
/// em: of one with and without its title.
constexpr double kLeastMonitorChart = 26.0, kLeastUntitledMonitorChart = 23.0;

/// As draw_force_chart.
QImage draw_monitor_chart(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                          const curricula::Score& score, int width = 1600, int height = 900);

}  // namespace vallecula::gui
