// The lines that a force is judged by: one look in the charts and in the bars beside the view.
#pragma once

#include <QColor>

namespace vallecula::gui {

/// A colour on paper, as the window's look has it on its light ground (theme::of_this_ground finds the dark one's), and
/// a dash of its own, so that they are told apart without colour.
struct JudgedLine {
  QColor on_paper;
  Qt::PenStyle style;
};

const JudgedLine kTargetLine{QColor(122, 104, 0), Qt::DashDotLine};  // yellow
const JudgedLine kPassLine{QColor(176, 66, 0), Qt::SolidLine};       // red
const JudgedLine kDeviceLine{QColor(0, 104, 158), Qt::DashLine};     // blue

}  // namespace vallecula::gui
