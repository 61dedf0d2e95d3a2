// What happened in a trial and when: the marks on a replay's timeline.
#pragma once

#include <string>
#include <vector>

#include "curricula/score/score.h"

namespace vallecula::gui {

struct ReplayEvent {
  enum class Kind {
    attempt_begins,
    attempt_ends,
    first_sight,
    peak,
    cords_passed,
    oesophagus,
    breath,
    co2,
    distraction,
    pause,
    device_limit,
    over_target,
    alarm
  };
  double at_s = 0.0;  ///< trial time
  double to_s = 0.0;  ///< of what lasts: its end; else at_s
  Kind kind = Kind::peak;
  std::string text;  ///< for a person, without the time
};

/// By growing time. From the log, with the score's own definitions of attempts, sight and peaks.
std::vector<ReplayEvent> replay_events(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                                       const curricula::Score& score);

/// One of many, not worth a jump: a breath.
inline bool minor(const ReplayEvent& event) { return event.kind == ReplayEvent::Kind::breath; }

/// The next one after, or the last one clearly before, this second, of those that are not minor; null: there is none.
const ReplayEvent* next_event(const std::vector<ReplayEvent>& events, double at_s);
const ReplayEvent* previous_event(const std::vector<ReplayEvent>& events, double at_s);

}  // namespace vallecula::gui
