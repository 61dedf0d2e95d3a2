// The figures beside the views: clock, how much of the glottis is seen, what the device does, whether the loop keeps
// time.
#pragma once

#include <QWidget>
#include <optional>

#include "curricula/scenario.h"
#include "curricula/score/mouth.h"
#include "engine/snapshot.h"
#include "gui/session/keeps_up.h"

class QLabel;
class QProgressBar;

namespace vallecula::gui {

/// Plain words for a state of the hand's bond with the scene. `banner` is empty while everything is as it should be; a
/// device limit is told as the device's, never as tissue giving way.
struct StateWords {
  QString name, banner;
};
StateWords words_for(engine::HapticState state, bool device_invalid);
/// What the banner says of a pause (empty: none), else of a snapshot's state, and of the attempt's first fault (empty:
/// none); a fault hides no limit.
QString banner_for(const engine::Snapshot& snapshot, const QString& fault, const QString& pause = {});

/// Where the tip of what the second hand holds is, in words: its mark at the lips once it is in the mouth; before, how
/// far it still is from the gums, for to one eye a tube before the mouth looks like one in it.
/// `rule_m`: beside a tube's mark what the rule by weight says it is at the lips; none: not told.
QString tube_words(const engine::IntubationRecord& now, const std::optional<curricula::Mouth>& mouth,
                   const std::optional<double>& rule_m = {});

class TrialReadings : public QWidget {
  Q_OBJECT
 public:
  explicit TrialReadings(QWidget* parent = nullptr);
  /// `mouth`: where an attempt begins (as the score takes it); without one the clock counts from the start, and
  /// says so.
  void set_scenario(const curricula::Scenario& scenario, const std::optional<curricula::Mouth>& mouth);
  /// To be called for every frame: the attempt's clock starts with the first snapshot whose tip is in the mouth,
  /// stands in a pause and while the tip is out, and with a tube begins anew when it comes in again, as the score
  /// counts. `paused_s`: of the attempt until now.
  void show_snapshot(const engine::Snapshot& snapshot, double paused_s = 0.0);
  /// An expert's sight and tube, until show_snapshot(); one's own clock stands meanwhile, greyed out, and its caption
  /// says whose it is. What the device and the computer do is nobody's then.
  void show_expert(const engine::Snapshot& snapshot);
  /// The blade is being led to the vallecula: no hand's attempt has begun.
  void set_led(bool led) { led_ = led; }
  /// The same attempt, which the other has shown from its beginning: its clock and its best view.
  void go_on_from(const TrialReadings& other);
  /// A row for the tube, in a scene that has one.
  void show_tube(bool shown);
  /// How hard the tube pushes back; not told where forces are not to be seen.
  void show_force(bool shown) { force_shown_ = shown; }
  /// How the picture is drawn: frames a second, and what was left out to keep them (empty: nothing).
  void show_drawing(double frames_per_second, const QString& reduced);
  void clear();

 private:
  void set_of_expert(bool of_expert);
  void show_clock();
  void show_tube_of(const engine::Snapshot& snapshot);
  std::optional<curricula::Mouth> mouth_;
  std::optional<double> lips_rule_m_;
  double attempt_start_s_ = -1.0, attempt_s_ = 0.0, last_in_s_ = 0.0;
  bool led_ = false;
  QLabel *clock_caption_, *clock_, *limit_, *seen_caption_, *seen_, *state_, *computer_, *drawing_, *tube_,
      *tube_caption_;
  Pace pace_;
  class SightBar* sight_;
  double sight_percent_ = 25.0, best_percent_ = 0.0, attempt_limit_s_ = 30.0;
  bool force_shown_ = true, of_expert_ = false;
};

}  // namespace vallecula::gui
