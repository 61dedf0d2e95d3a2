// The window's colours and type, in one place. Okabe and Ito's set where a colour carries meaning: told apart by
// colour-blind eyes, on a dark and on a light ground.
#pragma once

#include <QColor>
#include <QImage>

class QApplication;
class QString;
class QWidget;

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
/// A colour of the style sheet by its name there ("line", "focus"); black where there is none of it.
QColor shade(const char* name);
/// A size in points as the look's text scale has it.
double points(double at_scale_one);

/// Gives a widget a style sheet of its own that follows the look: "@over@" and "@15pt@" in it are as in the window's.
void dress(QWidget& widget, const QString& sheet);
/// Fixes a widget's width or height to so many pixels of a text scale of one; it follows the text's size.
void keep_wide(QWidget& widget, int pixels);
void keep_high(QWidget& widget, int pixels);
/// What a colour of the other ground is on this one (for what keeps its colour, as a list's rows do); else itself.
QColor of_this_ground(const QColor& colour);
/// A chart drawn for white paper as it is on this ground: on a dark one light and dark change places and the hues stay.
QImage of_this_ground(const QImage& on_paper);

/// Palette, font and style sheet of the whole application; whatever is open follows at once.
void apply(QApplication& application, const Look& look = {});
const Look& look();

}  // namespace vallecula::gui::theme
