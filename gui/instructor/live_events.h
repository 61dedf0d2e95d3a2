// What happens in a trial, told as it comes, for somebody who watches it.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/score/mouth.h"
#include "engine/snapshot.h"
#include "gui/session/dual_task.h"

namespace vallecula::gui {

struct LiveEvent {
  double at_s = 0.0;  ///< of the trial's clock, which stands in pauses
  QString text;
};

/// Told from the pictures, as many a second as are drawn: what is shorter than that may be missed here. The result page
/// and the replay have every tick.
class LiveEvents {
  Q_DECLARE_TR_FUNCTIONS(vallecula::gui::LiveEvents)
 public:
  /// A new attempt. `mouth`: where an attempt begins, as the score takes it.
  void begin(const curricula::Scenario& scenario, const std::optional<curricula::Mouth>& mouth);
  /// What is new since the last snapshot. `pause`: why it is paused, empty while it is not; `paused_s`: so far.
  std::vector<LiveEvent> watch(const engine::Snapshot& snapshot, const QString& pause, double paused_s, DualTask* task);
  /// The trial's clock as its log, the result and the replay have it, pauses included, s.
  double log_s() const { return log_s_; }
  /// The same, but in a pause when that began.
  double now_s() const { return pause_.isEmpty() ? log_s_ : pause_began_s_; }

 private:
  void tell(const QString& text) { told_.push_back({log_s_, text}); }
  void watch_blade(const engine::Snapshot& snapshot);
  void watch_force(const QString& what, double force_n, double target_n, bool& over);
  void watch_tube(const engine::IntubationRecord& now);
  void watch_beside(DualTask& task);

  std::optional<curricula::Mouth> mouth_;
  double sight_percent_ = 25.0, tongue_target_n_ = 0.0, gum_target_n_ = 0.0;
  std::vector<LiveEvent> told_;
  double log_s_ = 0.0, pause_began_s_ = 0.0;
  double now_s_ = 0.0, last_in_s_ = 0.0;  ///< without pauses
  bool in_ = false, seen_ = false, over_tongue_ = false, over_gum_ = false;
  bool yellow_ = false, spasm_ = false;
  engine::TipPlace place_ = engine::TipPlace::outside;
  QString pause_;
  QStringList alarms_;
  std::vector<int> open_;
};

}  // namespace vallecula::gui
