// One learning curve of one trainee, scenario and device kind, for the PDF report.
#pragma once

#include <QImage>
#include <vector>

#include "gui/records_pages/curve_reading.h"

namespace vallecula::gui {

/// Left the peak force on the tongue of each whole trial, passed or not told by shape and colour; right the cumulative
/// sum of those that count with its two lines, as `reading` of the same trials has them. `trials` in the order they were
/// recorded; at least one is whole. Needs a QGuiApplication.
QImage draw_curve_chart(const std::vector<curricula::RecordRow>& trials, const CurveReading& reading, int width = 1600,
                        int height = 520);

}  // namespace vallecula::gui
