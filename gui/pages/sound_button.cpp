#include "gui/pages/sound_button.h"

#include <QMenu>
#include <QSettings>
#include <QSlider>
#include <QWidgetAction>
#include <algorithm>
#include <cmath>

#include "gui/session/user_settings.h"
#include "gui/views/monitor_panel.h"

namespace vallecula::gui {
namespace {

constexpr const char* kOn = "sound/monitor";
constexpr const char* kVolume = "sound/volume";
constexpr double kUsualVolume = 0.5;
constexpr int kSteps = 100;

}  // namespace

SoundButton::SoundButton(QWidget* parent) : QToolButton(parent) {
  setCheckable(true);
  setFocusPolicy(Qt::NoFocus);
  setPopupMode(QToolButton::MenuButtonPopup);
  setAccessibleName(tr("Sound of the monitor"));
  auto* menu = new QMenu(this);
  volume_ = new QSlider(Qt::Horizontal, menu);
  volume_->setRange(0, kSteps);
  volume_->setMinimumWidth(160);
  volume_->setAccessibleName(tr("Volume, per cent"));
  volume_->setToolTip(tr("Volume of the monitor's sound, per cent"));
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(volume_);
  menu->addAction(action);
  setMenu(menu);
  connect(this, &QToolButton::toggled, this, &SoundButton::keep);
  connect(volume_, &QSlider::valueChanged, this, &SoundButton::keep);
  connect(&output_, &SoundOutput::answered, this, &SoundButton::show_state);
  show_state();
}

void SoundButton::open(bool with_monitor) {
  setVisible(with_monitor);
  const auto kept = user_settings();
  const double volume = std::clamp(kept->value(kVolume, kUsualVolume).toDouble(), 0.0, 1.0);
  {
    const QSignalBlocker quiet(this), still(volume_);
    setChecked(kept->value(kOn, true).toBool());
    volume_->setValue(static_cast<int>(std::lround(kSteps * volume)));
  }
  if (with_monitor) output_.open();
  show_state();
}

void SoundButton::keep() {
  const auto kept = user_settings();
  kept->setValue(kOn, isChecked());
  kept->setValue(kVolume, volume_->value() / static_cast<double>(kSteps));
  show_state();
}

void SoundButton::show_state() {
  output_.set_volume(isChecked() ? volume_->value() / static_cast<double>(kSteps) : 0.0);
  setText(isChecked() ? tr("Sound on") : tr("Sound off"));
  setToolTip(output_.remark().isEmpty()
                 ? tr("A tone at each heart beat, lower as the saturation falls, and the monitor's alarms (M)")
                 : output_.remark());
}

void SoundButton::hear(const engine::Snapshot& snapshot, bool standing) {
  if (!snapshot.has_intubation || standing) return output_.hear({});
  const engine::IntubationRecord& infant = snapshot.intubation;
  output_.hear({infant.spo2, infant.heart_per_min, alarm_sound_of(infant)});
}

}  // namespace vallecula::gui
