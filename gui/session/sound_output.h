// Plays the monitor's tones through the computer's loudspeaker. Opening one may take its time or never come back: it is
// done, and fed, on a thread of its own.
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "gui/session/monitor_sound.h"

class QThread;

namespace vallecula::gui {

class SoundOutput : public QObject {
  Q_OBJECT
 public:
  explicit SoundOutput(QObject* parent = nullptr);
  ~SoundOutput() override;
  /// Begins to look for a loudspeaker, the first time; answered() follows.
  void open();
  /// What the monitor says now. Not said for a second (the window is busy, the trial is over): silence.
  void hear(const MonitorState& state);
  void set_volume(double volume);  ///< 0 (silence) to 1
  /// Why nothing can be heard, for a person; empty: it can, or it is not known yet.
  QString remark() const { return remark_; }

 signals:
  /// It is known whether there is a loudspeaker: remark().
  void answered();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  QThread* thread_ = nullptr;
  QString remark_;
};

}  // namespace vallecula::gui
