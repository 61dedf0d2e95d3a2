// The window's colours and type, in one place. Okabe and Ito's set where a colour carries meaning: told apart by
// colour-blind eyes, on a dark and on a light ground.
#pragma once

#include <QColor>

class QApplication;

namespace vallecula::gui::theme {

enum class Ground { dark, light };

/// How the whole application looks. `text_scale`: 1 is 10 points.
struct Look {
  Ground ground = Ground::dark;
  double text_scale = 1.0;
};
constexpr double kLeastTextScale = 0.8, kMostTextScale = 1.6;

/// Of the look that was applied last; ask anew each time something is painted.
const QColor& ground();
const QColor& panel();
const QColor& track();
const QColor& text();
const QColor& faint();
const QColor& within();  ///< bluish green
const QColor& over();    ///< orange: over a training target
const QColor& target();  ///< yellow on dark, its darker neighbour on light
const QColor& device();  ///< sky blue: whatever is the device's and not the patient's
const QColor& bad();     ///< vermillion
const QColor& accent();
const QColor& new_line();   ///< behind text: what a comparison found added
const QColor& gone_line();  ///< and removed
/// A size in points as the look's text scale has it.
double points(double at_scale_one);

/// Palette, font and style sheet of the whole application; whatever is open follows at once.
void apply(QApplication& application, const Look& look = {});
const Look& look();

}  // namespace vallecula::gui::theme
