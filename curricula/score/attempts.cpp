#include "curricula/score/attempts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curricula/score/stays.h"

namespace vallecula::curricula {
namespace {

constexpr double kSevereDesaturation = 20.0;  ///< percentage points (NEAR4NEOS)
constexpr double kBradycardia = 100.0;        ///< per minute (NEAR4NEOS)

/// What the hand did within the attempt: view and passing, in working ticks from its start.
void measure_hand(const TrialLog& log, const Scenario& scenario, const Stay& stay, Attempt& attempt) {
  const double period_s = log.header.servo_period_s;
  long long worked = 0, viewed = 0;
  bool in = stay.first > 0 && tube_past_cords(log.ticks[stay.first - 1]);
  for (std::size_t i = stay.first; i <= stay.last; ++i) {
    const LogTick& tick = log.ticks[i];
    if (paused(tick)) continue;
    if (!attempt.time_to_view_s && tick.has_sight && 100.0 * tick.glottis_visible >= scenario.sight_percent) {
      attempt.time_to_view_s = static_cast<double>(worked) * period_s;
      attempt.view_at_s = tick.time_s;
      viewed = worked;
    }
    const bool was_in = in;
    in = tube_past_cords(tick);
    if (in && !was_in) {
      attempt.passed_cords_s = tick.time_s;
      attempt.time_to_pass_s = static_cast<double>(worked - viewed) * period_s;
    }
    ++worked;
  }
}

/// What the infant did before and from then on: ticks `from` to `begin`, and `begin` to `end` (exclusive).
void measure_infant(const TrialLog& log, std::size_t from, std::size_t begin, std::size_t end, Attempt& attempt) {
  double before = -1.0, lowest = std::numeric_limits<double>::infinity(), heart = lowest;
  for (std::size_t i = from; i < end; ++i) {
    const LogIntubation& infant = log.ticks[i].intubation;
    if (paused(log.ticks[i])) continue;
    if (i <= begin && std::isfinite(infant.spo2)) before = std::max(before, infant.spo2);
    if (i < begin) continue;
    if (std::isfinite(infant.spo2)) lowest = std::min(lowest, infant.spo2);
    if (std::isfinite(infant.heart_per_min)) heart = std::min(heart, infant.heart_per_min);
  }
  attempt.highest_spo2_before_percent = 100.0 * before;
  attempt.lowest_spo2_percent = 100.0 * lowest;
  attempt.lowest_heart_per_min = heart;
  // Whole percents are told, of which a sum of fractions may be a hair off.
  attempt.desaturated = std::round(100.0 * before) - std::round(100.0 * lowest) >= kSevereDesaturation;
  attempt.bradycardia = heart < kBradycardia;
}

}  // namespace

bool tube_past_cords(const LogTick& tick) noexcept {
  const LogIntubation& i = tick.intubation;
  if (i.in_hand == LoggedInHand::catheter) return false;
  return i.place == LoggedPlace::trachea || i.place == LoggedPlace::main_bronchus ||
         (i.place == LoggedPlace::larynx && i.past_cords_m > 0.0);
}

std::vector<Attempt> measure_attempts(const TrialLog& log, const Scenario& scenario) {
  const std::vector<Stay> stays = stays_in_mouth(log);
  const double period_s = log.header.servo_period_s;
  std::vector<Attempt> attempts;
  for (std::size_t i = 0; i < stays.size(); ++i) {
    const Stay& stay = stays[i];
    const std::size_t from = i == 0 ? 0 : stays[i - 1].last;
    const std::size_t next = i + 1 < stays.size() ? stays[i + 1].first : log.ticks.size();
    Attempt attempt;
    attempt.start_s = stay.first_s;
    attempt.end_s = stay.last_s + period_s;
    attempt.paused_s = static_cast<double>(stay.paused_at_last - stay.paused_at_first) * period_s;
    attempt.time_s = attempt.end_s - attempt.start_s - attempt.paused_s;
    const auto breaths = [&](std::size_t tick) { return log.ticks[tick].intubation.breaths_given; };
    attempt.breaths_before = breaths(stay.first) - (i == 0 ? 0 : breaths(from));
    measure_hand(log, scenario, stay, attempt);
    measure_infant(log, from, stay.first, next, attempt);
    attempts.push_back(attempt);
  }
  return attempts;
}

}  // namespace vallecula::curricula
