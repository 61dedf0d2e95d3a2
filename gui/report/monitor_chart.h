// What the monitor showed over a trial with an intubation, for the report and the result page.
#pragma once

#include <QImage>

#include "curricula/score/score.h"

namespace vallecula::gui {

/// Saturation as displayed and as it really was, heart rate, and the fraction of the glottis in sight, with attempts,
/// breaths, the cords passed, the oesophagus, and the detector's change of colour. As draw_force_chart otherwise. Needs
/// score.intubation and a log with an intubation; throws std::logic_error without.
QImage draw_monitor_chart(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                          const curricula::Score& score, int width = 1600, int height = 900);

}  // namespace vallecula::gui
