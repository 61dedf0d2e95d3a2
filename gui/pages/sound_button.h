// The monitor's sound, on or off (M), and how loud: remembered in [sound] of the settings.
#pragma once

#include <QToolButton>

#include "engine/snapshot.h"
#include "gui/session/sound_output.h"

class QSlider;

namespace vallecula::gui {

class SoundButton : public QToolButton {
  Q_OBJECT
 public:
  explicit SoundButton(QWidget* parent = nullptr);
  /// A trial begins: what the settings say; `with_monitor`: there is one to be heard.
  void open(bool with_monitor);
  /// To be called for every frame of a running trial; its silence is the sound's. `standing`: the trial's clock stands.
  void hear(const engine::Snapshot& snapshot, bool standing);

 private:
  void keep();
  void show_state();
  SoundOutput output_;
  QSlider* volume_;
};

}  // namespace vallecula::gui
