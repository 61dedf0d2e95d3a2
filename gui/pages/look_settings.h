// How a person wants the window to look, kept in the user's settings; what of it is the theme's is applied here.
#pragma once

#include <QString>

#include "gui/views/theme.h"

namespace vallecula::gui {

struct LookSettings {
  QString ground = "dark";      ///< "dark", "light", "system"
  double text_scale = 1.0;      ///< kLeastTextScale to kMostTextScale of the theme
  QString trachea = "natural";  ///< "natural", "blue" (as in the paper)
  QString quality = "auto";     ///< "auto", "high", "low"
};

/// As kept in [look]; what is no such setting is the default's.
LookSettings look_settings();
void keep_look(const LookSettings& look);
/// Palette, font and style sheet of the whole application; whatever is open follows at once.
void apply_look(const LookSettings& look);
/// To be called once, before the first look is applied: what "system" means is the desktop's own palette.
void note_system_palette();

}  // namespace vallecula::gui
