#include "curricula/score/helps.h"

#include <algorithm>

#include "curricula/score/criterion.h"

namespace vallecula::curricula {
namespace {

/// How often and how long one of these bits was set, less pauses where nothing is asked for in them.
Use use_of(const TrialLog& log, std::uint32_t bits, bool in_pauses = false) {
  Use use;
  long long ticks = 0;
  std::uint32_t before = 0;
  for (const LogTick& tick : log.ticks) {
    if (!in_pauses && paused(tick)) continue;
    const std::uint32_t asked = tick.buttons & bits;
    ticks += asked != 0;
    use.times += (asked & ~before) != 0;
    if (asked != 0 && use.first_s < 0.0) use.first_s = tick.time_s;
    before = asked;
  }
  use.for_s = static_cast<double>(ticks) * log.header.servo_period_s;
  return use;
}

bool ended_by_hand(const TrialLog& log) {
  return log.footer.complete && (log.footer.ended == kEndedByReset || log.footer.ended == kEndedByTrainee);
}

bool tube_entered(const TrialLog& log) {
  return std::any_of(log.ticks.begin(), log.ticks.end(), [](const LogTick& tick) {
    return tick.has_intubation && tick.intubation.place != LoggedPlace::outside;
  });
}

/// A limit of force was passed, wherever the tips were: that is not made undone by ending. Questions are not judged.
bool did_harm(const Scenario& scenario, const Score& score) {
  const PassLimits& pass = scenario.pass;
  return score.peak_tongue_force_n > pass.peak_tongue_force_n || score.peak_gum_force_n > pass.peak_gum_force_n ||
         score.time_over_target_s > pass.time_over_target_s ||
         score.time_over_force_limit_s > pass.time_over_device_limit_s;
}

std::string from(const Use& use) { return " from " + second(use.first_s); }

}  // namespace

std::optional<TrialLog> after_lead_in(const TrialLog& log) {
  const auto led = log.header.settings.find(kLeadInTicks);
  if (led == log.header.settings.end() || log.ticks.empty()) return std::nullopt;
  long long left = static_cast<long long>(led->second);
  auto first = log.ticks.begin();
  for (; first != std::prev(log.ticks.end()) && left > 0; ++first) left -= !paused(*first);
  return TrialLog{log.header, {first, log.ticks.end()}, log.events, log.footer};
}

void measure_helps(const TrialLog& log, const Scenario& scenario, bool led_in, Score& score) {
  score.at_vallecula = led_in;
  score.no_attempt = !led_in && scenario.attempt.mode == Mode::practice && ended_by_hand(log) && !score.mouth_unknown &&
                     !score.attempt_begun && !tube_entered(log) && !did_harm(scenario, score);
  score.eye_moves = use_of(log, kLoggedEyeMoves);
  score.extension = use_of(log, kLoggedExtension);
  score.aided = use_of(log, kLoggedAided, true);  // the trial waits while an expert is shown
  if (log.header.has_intubation) {                // without one they change nothing
    score.saturation_driven = use_of(log, kLoggedSaturationDriven);
    score.heart_driven = use_of(log, kLoggedHeartDriven);
    score.spasm_driven = use_of(log, kLoggedSpasm);
  }
  if (led_in)
    score.set_aside.push_back(
        "Begun at the vallecula: the blade was led there, so the trial counts neither as passed nor as failed, and its "
        "times are not judged");
  if (score.no_attempt)
    score.set_aside.push_back(
        "Neither blade nor tube entered the mouth: no attempt, so the trial counts neither as passed nor as failed");
  const auto earlier = [](const Use& a, const Use& b) {
    return a.times == 0 || (b.times > 0 && b.first_s < a.first_s) ? b : a;
  };
  const Use vital = earlier(score.saturation_driven, score.heart_driven);
  if (vital.times > 0)
    score.set_aside.push_back("The instructor changed the infant's vital signs" + from(vital) +
                              ": the trial counts neither as passed nor as failed");
  if (score.spasm_driven.times > 0)
    score.set_aside.push_back("The instructor closed the vocal cords" + from(score.spasm_driven) +
                              ": the trial counts neither as passed nor as failed");
}

}  // namespace vallecula::curricula
