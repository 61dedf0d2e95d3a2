// What happens beside the hands while a trial runs: each distraction at its time, its answer, and both in the log.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/trial_log.h"

namespace vallecula::gui {

/// A talking team is shown for so long (assumed: the time to read a sentence aloud).
constexpr double kTalkShownS = 6.0;

/// When a script answers: rightly, and within the time allowed (assumed: an expert's reaction).
struct ScriptedAnswers {
  double question_s = 3.0, alarm_s = 2.0;
};

/// The recorder's thread says how far the trial is and writes down what comes of it; the window's thread looks and
/// answers. Neither is the servo's: this takes locks. Whatever is asked for is one of the scenario's distractions,
/// counted from 1.
class DualTask {
 public:
  explicit DualTask(std::vector<curricula::Distraction> distractions) : distractions_(std::move(distractions)) {
    begin(false);
  }

  const std::vector<curricula::Distraction>& distractions() const { return distractions_; }

  // --- any thread ----------------------------------------------------------------------------------------------------
  struct Open {
    int distraction = 0;
    double left_s = 0.0, of_s = 0.0;  ///< trial time until it closes by itself, of how much in all
  };
  std::vector<Open> open() const;  ///< the longest open first
  /// What is over, or cannot be answered or silenced so, is let pass. 0: nothing of the kind was open; that is logged, as
  /// of the distraction shown last (none yet: let pass), and counts as false.
  void answer(int distraction, int answer);
  void silence(int distraction);

  // --- the recorder's thread -----------------------------------------------------------------------------------------
  /// A new attempt: nothing shown yet. `scripted`: no person is there, and the script answers itself.
  void begin(bool scripted);
  /// Tick `tick` was recorded, at `trial_s` of the trial's clock (it stands in pauses): what happened until then.
  std::vector<curricula::LogEvent> advance(std::int64_t tick, double trial_s);

 private:
  enum class State { to_come, open, over };
  const curricula::Distraction& at(int distraction) const {
    return distractions_[static_cast<std::size_t>(distraction - 1)];
  }
  double open_for_s(int distraction) const;
  void ask(const curricula::LogEvent& event);
  void ask_of_nothing(curricula::LogEvent event);

  const std::vector<curricula::Distraction> distractions_;
  mutable std::mutex mutex_;
  std::vector<State> states_;
  std::vector<double> shown_s_;  ///< trial time
  std::vector<curricula::LogEvent> asked_for_;
  int last_shown_ = 0;  ///< 0: none yet
  double now_s_ = 0.0;
  bool scripted_ = false;
};

}  // namespace vallecula::gui
