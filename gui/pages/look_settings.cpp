#include "gui/pages/look_settings.h"

#include <QApplication>
#include <QPalette>
#include <QStringList>
#include <algorithm>

#include "gui/session/user_settings.h"
#include "gui/views/gl_view.h"
#include "gui/views/mouth_stage.h"

namespace vallecula::gui {
namespace {

bool system_is_dark = true;

QString one_of(const QString& value, const QStringList& known) { return known.contains(value) ? value : known.front(); }

}  // namespace

LookSettings look_settings() {
  LookSettings look;
  const auto kept = user_settings();
  kept->beginGroup("look");
  look.ground = one_of(kept->value("ground").toString(), {"dark", "light", "system"});
  bool number = false;
  const double scale = kept->value("text_scale").toDouble(&number);
  if (number) look.text_scale = std::clamp(scale, theme::kLeastTextScale, theme::kMostTextScale);
  look.trachea = one_of(kept->value("trachea").toString(), {"natural", "blue"});
  look.quality = one_of(kept->value("quality").toString(), {"auto", "high", "low"});
  return look;
}

void keep_look(const LookSettings& look) {
  const auto kept = user_settings();
  kept->beginGroup("look");
  kept->setValue("ground", look.ground);
  kept->setValue("text_scale", look.text_scale);
  kept->setValue("trachea", look.trachea);
  kept->setValue("quality", look.quality);
}

void apply_look(const LookSettings& look) {
  const bool dark = look.ground == "system" ? system_is_dark : look.ground == "dark";
  theme::apply(*qApp, {dark ? theme::Ground::dark : theme::Ground::light, look.text_scale});
  MouthStage::set_blue_everywhere(look.trachea == "blue");
  GlView::governor().set_mode(QualityGovernor::mode_of(look.quality));
}

void note_system_palette() { system_is_dark = QApplication::palette().color(QPalette::Window).lightness() < 128; }

}  // namespace vallecula::gui
