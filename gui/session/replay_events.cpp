#include "gui/session/replay_events.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "curricula/score/attempts.h"
#include "gui/report/force_chart.h"

namespace vallecula::gui {

namespace {

using Kind = ReplayEvent::Kind;

constexpr double kSameStay_s = 0.25;  // at the limit or over the target, let go for less than this: one stay
constexpr double kClearly_s = 0.3;    // before: pressing the key twice while it plays goes back two
constexpr double kSevere = 0.80;      // displayed saturation (CLINICAL)

double length(const std::array<double, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

std::string words(const char* format, double value) {
  char text[120];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Runs of ticks in which something holds, as events that last.
class Stays {
 public:
  Stays(Kind kind, std::string text, std::vector<ReplayEvent>& events)
      : kind_(kind), text_(std::move(text)), events_(events) {}
  void look(bool holds, double at_s) {
    if (!holds) return;
    if (last_ < 0.0 || at_s - last_ > kSameStay_s) {
      index_ = events_.size();
      events_.push_back({at_s, at_s, kind_, text_});
    }
    events_[index_].to_s = last_ = at_s;
  }

 private:
  Kind kind_;
  std::string text_;
  std::vector<ReplayEvent>& events_;
  std::size_t index_ = 0;
  double last_ = -1.0;
};

/// A condition that comes true.
struct Onset {
  bool now = false;
  bool operator()(bool holds) {
    const bool begins = holds && !now;
    now = holds;
    return begins;
  }
};

void add_of_ticks(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                  std::vector<ReplayEvent>& events) {
  Stays limited(Kind::device_limit, "at the device's limit", events);
  Stays over(Kind::over_target,
             words("tongue force over its training target of %.1f N", scenario.targets.tongue_force_n), events);
  Onset cords, oesophagus, yellow, desaturated, slow;
  int breaths = 0;
  for (const curricula::LogTick& tick : log.ticks) {
    if (!curricula::paused(tick)) {
      limited.look(tick.state == curricula::LoggedState::limited || tick.state == curricula::LoggedState::lost,
                   tick.time_s);
      over.look(scenario.targets.tongue_force_n > 0.0 &&
                    length(tick.loads[curricula::kTongue].force_n) > scenario.targets.tongue_force_n,
                tick.time_s);
    }
    if (!tick.has_intubation) continue;
    const curricula::LogIntubation& tube = tick.intubation;
    const auto add = [&](Kind kind, std::string text) {
      events.push_back({tick.time_s, tick.time_s, kind, std::move(text)});
    };
    if (cords(curricula::tube_past_cords(tick))) add(Kind::cords_passed, "tube's tip past the cords");
    if (oesophagus(curricula::tube_in_oesophagus(tick))) add(Kind::oesophagus, "tube's tip in the oesophagus");
    if (yellow(tube.detector_yellow)) add(Kind::co2, "CO2 detector yellow");
    if (desaturated(tube.spo2 < kSevere)) add(Kind::alarm, "SpO2 below 80 %");
    if (slow(tube.heart_per_min < curricula::kBradycardia)) add(Kind::alarm, "heart below 100 a minute");
    if (tube.breaths_given > breaths) add(Kind::breath, "a breath given");
    breaths = tube.breaths_given;
  }
}

std::string distraction_words(const curricula::LogEvent& event, const curricula::Scenario& scenario) {
  const auto index = static_cast<std::size_t>(event.distraction) - 1;
  using Asked = curricula::Distraction::Kind;
  const bool known = event.distraction >= 1 && index < scenario.distractions.size();
  const Asked kind = known ? scenario.distractions[index].kind : Asked::talk;
  const std::string what = kind == Asked::question ? "question" : kind == Asked::alarm ? "alarm" : "talk";
  switch (event.kind) {
    case curricula::LogEvent::Kind::shown:
      return what + " begins";
    case curricula::LogEvent::Kind::silenced:
      return what + " silenced";
    case curricula::LogEvent::Kind::answered:
      return what + (known && event.answer == scenario.distractions[index].right_answer ? " answered rightly"
                                                                                        : " answered wrongly");
  }
  return what;
}

}  // namespace

std::vector<ReplayEvent> replay_events(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                                       const curricula::Score& score) {
  std::vector<ReplayEvent> events;
  const auto add = [&events](double at_s, Kind kind, std::string text) {
    if (at_s >= 0.0) events.push_back({at_s, at_s, kind, std::move(text)});
  };
  const auto spans = attempt_spans(score);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const std::string which = spans.size() > 1 ? "attempt " + std::to_string(i + 1) : std::string("attempt");
    events.push_back({spans[i].first, spans[i].second, Kind::attempt_begins, which + " begins: blade into the mouth"});
    add(spans[i].second, Kind::attempt_ends, which + " ends: blade out");
  }
  if (score.intubation) {
    for (const curricula::Attempt& attempt : score.intubation->attempts)
      if (attempt.view_at_s) add(*attempt.view_at_s, Kind::first_sight, "glottis in sight");
    if (score.intubation->tip_load_n.value > 0.5)
      add(score.intubation->tip_load_n.at_s, Kind::peak,
          words("peak force along the tube, %.1f N", score.intubation->tip_load_n.value));
  } else {
    add(score.time_of_first_sight_s, Kind::first_sight, "glottis in sight");
  }
  if (score.peak_tongue_force_n > 0.0)
    add(score.time_of_peak_tongue_force_s, Kind::peak,
        words("peak force on the tongue, %.1f N", score.peak_tongue_force_n));
  if (score.peak_gum_force_n > 0.0)
    add(score.time_of_peak_gum_force_s, Kind::peak, words("peak force on the gum, %.1f N", score.peak_gum_force_n));
  for (const curricula::Pause& pause : score.pauses) {
    std::string fault = pause.fault;
    std::replace(fault.begin(), fault.end(), '_', ' ');
    events.push_back(
        {pause.at_s, pause.at_s + pause.for_s, Kind::pause, fault.empty() ? std::string("pause") : "pause: " + fault});
  }
  for (const curricula::LogEvent& event : log.events)
    add(static_cast<double>(event.tick) * log.header.servo_period_s, Kind::distraction,
        distraction_words(event, scenario));
  add_of_ticks(log, scenario, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const ReplayEvent& a, const ReplayEvent& b) { return a.at_s < b.at_s; });
  return events;
}

const ReplayEvent* next_event(const std::vector<ReplayEvent>& events, double at_s) {
  for (const ReplayEvent& event : events)
    if (!minor(event) && event.at_s > at_s + 1e-3) return &event;
  return nullptr;
}

const ReplayEvent* previous_event(const std::vector<ReplayEvent>& events, double at_s) {
  const ReplayEvent* found = nullptr;
  for (const ReplayEvent& event : events)
    if (!minor(event) && event.at_s < at_s - kClearly_s) found = &event;
  return found;
}

}  // namespace vallecula::gui
