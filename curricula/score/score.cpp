// The figures of a trial, measured on its log.
#include "curricula/score/score.h"

#include <algorithm>
#include <cmath>

#include "curricula/score/helps.h"
#include "curricula/score/intubation.h"
#include "curricula/score/mouth.h"
#include "curricula/score/rubric.h"
#include "curricula/score/stays.h"
#include "curricula/score/vectors.h"

namespace vallecula::curricula {
namespace {

void measure_attempt(const TrialLog& log, Score& score) {
  score.mouth_unknown = !mouth_from_landmarks(log.header.landmarks_m);
  const std::vector<Stay> stays = stays_in_mouth(log);
  if (stays.empty()) return;
  const double period_s = log.header.servo_period_s;
  const Stay &first = stays.front(), &last = stays.back();
  score.attempt_begun = true;
  score.attempt_start_s = first.first_s;
  score.mouth_entries = static_cast<int>(stays.size());
  score.attempt_paused_s = static_cast<double>(last.paused_at_last - first.paused_at_first) * period_s;
  score.attempt_time_s = last.last_s + period_s - score.attempt_start_s - score.attempt_paused_s;
  const auto worked = std::find_if_not(log.ticks.rbegin(), log.ticks.rend(), paused);
  score.blade_out = last.last_s < worked->time_s;  // where a pause ends the trial: before it
}

void measure_sight(const TrialLog& log, const Scenario& scenario, Score& score) {
  double attempt_paused_s = 0.0;
  for (const LogTick& tick : log.ticks) {
    const bool in_attempt = score.attempt_begun && tick.time_s >= score.attempt_start_s;
    if (paused(tick)) {
      if (in_attempt) attempt_paused_s += log.header.servo_period_s;
      continue;
    }
    if (!tick.has_sight || !std::isfinite(tick.glottis_visible)) continue;
    const double percent = 100.0 * tick.glottis_visible;
    if (percent > score.glottis_visible_max_percent) {
      score.glottis_visible_max_percent = percent;
      score.time_of_glottis_max_s = tick.time_s;
    }
    if (in_attempt && percent >= scenario.sight_percent && score.time_to_trachea_visible_s < 0.0) {
      score.time_to_trachea_visible_s = tick.time_s - score.attempt_start_s - attempt_paused_s;
      score.time_of_first_sight_s = tick.time_s;
    }
  }
}

/// Returns what the rubric needs beyond the score's own fields.
Moments measure_forces(const TrialLog& log, const Scenario& scenario, Score& score) {
  Moments moments;
  long long over_target = 0, over_device_limit = 0;  // counted in ticks: sums of 0.001 would drift past a limit
  long long stay = 0, longest_stay = 0;
  long long paused_ticks = 0;
  bool after_pause = false;  ///< the device has not taken hold again yet
  double stay_began_s = 0.0;
  for (const LogTick& tick : log.ticks) {
    for (int structure = 0; structure < kStructures; ++structure) {
      const double force_n = magnitude(tick.loads[static_cast<std::size_t>(structure)].force_n);
      if (!std::isfinite(force_n)) {
        if (moments.not_finite_s < 0.0) moments.not_finite_s = tick.time_s;
        continue;
      }
      if (paused(tick)) continue;
      if (force_n > score.peak_force_n[static_cast<std::size_t>(structure)]) {
        score.peak_force_n[static_cast<std::size_t>(structure)] = force_n;
        score.time_of_peak_s[static_cast<std::size_t>(structure)] = tick.time_s;
      }
      if (structure == kTongue && force_n > scenario.targets.tongue_force_n) {
        ++over_target;
        if (moments.over_target_s < 0.0) moments.over_target_s = tick.time_s;
      }
    }
    const double displayed_n = magnitude(tick.displayed_force_n);
    if (std::isfinite(displayed_n)) {  // zero in a pause
      score.peak_displayed_force_n = std::fmax(score.peak_displayed_force_n, displayed_n);
    } else if (moments.not_finite_s < 0.0) {
      moments.not_finite_s = tick.time_s;
    }
    paused_ticks += paused(tick);
    after_pause =
        paused(tick) || (after_pause && (tick.state == LoggedState::lost || tick.state == LoggedState::recovering));
    if (tick.state != LoggedState::tracking && !after_pause) {
      ++over_device_limit;
      if (stay++ == 0) stay_began_s = tick.time_s;
      if (stay > longest_stay) {
        longest_stay = stay;
        moments.longest_off_tracking_s = stay_began_s;
      }
    } else {
      stay = 0;
    }
  }
  score.paused_s = static_cast<double>(paused_ticks) * log.header.servo_period_s;
  score.time_over_target_s = static_cast<double>(over_target) * log.header.servo_period_s;
  score.time_over_force_limit_s = static_cast<double>(over_device_limit) * log.header.servo_period_s;
  score.peak_tongue_force_n = score.peak_force_n[kTongue];
  score.time_of_peak_tongue_force_s = score.time_of_peak_s[kTongue];
  score.peak_gum_force_n = score.peak_force_n[kGum];
  score.time_of_peak_gum_force_s = score.time_of_peak_s[kGum];
  return moments;
}

std::vector<Pause> pauses_in(const TrialLog& log) {
  const std::vector<std::string>& faults = log.footer.pause_faults;
  std::vector<Pause> pauses;
  long long ticks = 0;
  for (const LogTick& tick : log.ticks) {
    if (!paused(tick)) {
      ticks = 0;
      continue;
    }
    if (ticks++ == 0)
      pauses.push_back({tick.time_s, 0.0, pauses.size() < faults.size() ? faults[pauses.size()] : std::string()});
    pauses.back().for_s = static_cast<double>(ticks) * log.header.servo_period_s;
  }
  return pauses;
}

/// With an intubation there may be several attempts: what the score says of "the attempt" is settled anew.
void settle_attempts(Score& score) {
  score.time_to_trachea_visible_s = score.time_of_first_sight_s = -1.0;
  const std::vector<Attempt>& attempts = score.intubation->attempts;
  const auto seen = std::find_if(attempts.begin(), attempts.end(),
                                 [](const Attempt& attempt) { return attempt.time_to_view_s.has_value(); });
  if (seen != attempts.end()) {
    score.time_to_trachea_visible_s = *seen->time_to_view_s;
    score.time_of_first_sight_s = *seen->view_at_s;
  }
  if (const Attempt* longest = score.intubation->longest()) {
    score.attempt_start_s = longest->start_s;
    score.attempt_time_s = longest->time_s;
    score.attempt_paused_s = longest->paused_s;
  }
}

Score score_of(const TrialLog& log, const Scenario& scenario, bool led_in) {
  Score score;
  score.ticks = static_cast<long long>(log.ticks.size());
  score.loop_rate_hz = log.footer.loop_rate_hz;
  score.deadline_misses = log.footer.deadline_misses;
  score.overruns = log.footer.overruns;
  score.real_time_setup = log.footer.real_time_setup;
  score.complete = log.footer.complete;
  measure_attempt(log, score);
  measure_sight(log, scenario, score);
  Moments moments = measure_forces(log, scenario, score);
  if (log.header.has_intubation && scenario.intubation) {
    score.intubation = measure_intubation(log, scenario, moments.not_finite_s);
    settle_attempts(score);
  }
  const std::vector<Stay> attempts = attempts_in(log);
  score.force = measure_forces_beyond_peaks(log, scenario);
  score.view = measure_view(log, scenario, attempts);
  score.blade = measure_blade(log, attempts);
  score.motion = measure_motion(log, attempts);
  score.dual_task = measure_dual_task(log, scenario);
  measure_helps(log, scenario, led_in, score);
  judge(log, scenario, moments, score);
  score.reasons.insert(score.reasons.begin(), score.set_aside.begin(), score.set_aside.end());
  score.checklist = checklist_of(score, log, scenario);
  return score;
}

}  // namespace

Score score_trial(const TrialLog& log, const Scenario& scenario) {
  const std::optional<TrialLog> rest = after_lead_in(log);
  Score score = score_of(rest ? *rest : log, scenario, rest.has_value());
  score.pauses = pauses_in(log);
  return score;
}

}  // namespace vallecula::curricula
