// How whole pages are wished to be seen when their pictures are looked at, where a test offers it:
// VALLECULA_LANGUAGE=de, VALLECULA_SIZE=1024x700 (pixels), VALLECULA_TEXT=1.35 (of 10 points). As usual without them.
#pragma once

#include <QApplication>
#include <QString>
#include <QStringList>
#include <QWidget>

#include "gui/pages/look_settings.h"
#include "gui/session/languages.h"

namespace vallecula::gui::window_test {

/// Before the window is made; its look is `look` but for the text.
inline void wish_words(LookSettings look) {
  if (const QString code = qEnvironmentVariable("VALLECULA_LANGUAGE"); !code.isEmpty()) install_language(*qApp, code);
  if (const double text = qEnvironmentVariable("VALLECULA_TEXT").toDouble(); text > 0.0) look.text_scale = text;
  keep_look(look);
  apply_look(look);
}
/// After it was made; a window that needs more room takes it.
inline void wish_size(QWidget& window) {
  const QStringList size = qEnvironmentVariable("VALLECULA_SIZE").split('x');
  if (size.size() == 2) window.resize(size[0].toInt(), size[1].toInt());
}

}  // namespace vallecula::gui::window_test
