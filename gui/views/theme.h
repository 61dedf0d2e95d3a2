// The window's colours and type, in one place. Okabe and Ito's set where a colour carries meaning: told apart by
// colour-blind eyes.
#pragma once

#include <QColor>

class QApplication;

namespace vallecula::gui::theme {

const QColor kGround(22, 26, 31);
const QColor kPanel(31, 36, 43);
const QColor kTrack(52, 58, 67);
const QColor kText(232, 236, 240);
const QColor kFaint(150, 158, 168);
const QColor kWithin(0, 158, 115);   ///< bluish green
const QColor kOver(230, 159, 0);     ///< orange: over a training target
const QColor kTarget(240, 228, 66);  ///< yellow
const QColor kDevice(86, 180, 233);  ///< sky blue: whatever is the device's and not the patient's
const QColor kBad(213, 94, 0);       ///< vermillion
const QColor kAccent(58, 130, 200);

/// Palette, font and style sheet of the whole application.
void apply(QApplication& application);

}  // namespace vallecula::gui::theme
