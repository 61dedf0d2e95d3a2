#include "curricula/score/rubric.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "curricula/score/choice_rubric.h"
#include "curricula/score/criterion.h"
#include "curricula/score/intubation_rubric.h"
#include "curricula/score/mouth.h"

namespace vallecula::curricula {
namespace {

Criterion completeness(const TrialLog& log, const Score& score) {
  const double end_s = log.ticks.empty() ? 0.0 : log.ticks.back().time_s;
  const std::string why = log.footer.ended.empty() ? "" : " (" + log.footer.ended + ")";
  return fact("trial_complete", score.complete, end_s,
              score.complete ? "The trial was recorded to its end at " + second(end_s)
                             : "The trial was interrupted" + why + ": its log ends at " + second(end_s));
}

Criterion attempt_begun(const TrialLog& log, const Score& score) {
  if (score.attempt_begun) {
    return fact("attempt_begun", true, score.attempt_start_s,
                "The blade entered the mouth at " + second(score.attempt_start_s));
  }
  return fact("attempt_begun", false, -1.0,
              mouth_from_landmarks(log.header.landmarks_m)
                  ? "The attempt never began: the blade's tip did not enter the mouth"
                  : "The attempt cannot be timed: the log lacks usable landmarks of the gums and the vallecula");
}

Criterion glottis_seen(const Scenario& scenario, const Score& score) {
  const double limit = scenario.pass.glottis_visible_percent, at_s = score.time_of_glottis_max_s;
  Criterion c = at_least("glottis_visible_max_percent", "%", score.glottis_visible_max_percent, limit, at_s,
                         "Glottis seen to", " at " + second(at_s));
  if (at_s < 0.0) c.sentence = "The glottis was never in sight; " + limit_text(limit) + " % of it must be seen";
  return c;
}

Criterion attempt_time(const Scenario& scenario, const Score& score) {
  std::string when = " (" + second(score.attempt_start_s) + " to " +
                     second(score.attempt_start_s + score.attempt_time_s + score.attempt_paused_s);
  if (score.attempt_paused_s > 0.0) when += ", paused for " + second(score.attempt_paused_s);
  if (score.mouth_entries > 1) when += ", the blade went in " + std::to_string(score.mouth_entries) + " times";
  if (!score.blade_out) when += ", the blade was still in the mouth";
  return at_most("attempt_time_s", "s", score.attempt_time_s, scenario.pass.attempt_time_s, score.attempt_start_s,
                 "The attempt took", when + ")");
}

/// The blade was in the mouth, or, where that cannot be told, touched something: only then is a limit kept.
bool blade_tried(const Score& score) {
  const auto touched = [](double force_n) { return force_n > 0.0; };
  return score.attempt_begun ||
         (score.mouth_unknown && std::any_of(score.peak_force_n.begin(), score.peak_force_n.end(), touched));
}

Criterion peak(const char* name, const char* what, double value, double limit, double at_s) {
  const bool touched = value > 0.0;
  return at_most(name, "N", value, limit, touched ? at_s : -1.0, what, touched ? " at " + second(at_s) : "");
}

}  // namespace

void judge(const TrialLog& log, const Scenario& scenario, const Moments& moments, Score& score) {
  const PassLimits& pass = scenario.pass;
  const auto since = [](const char* what, double at_s) {
    return at_s < 0.0 ? std::string() : " (" + std::string(what) + " " + second(at_s) + ")";
  };
  score.criteria = {completeness(log, score), attempt_begun(log, score), glottis_seen(scenario, score)};
  if (score.attempt_begun && !score.at_vallecula)
    score.criteria.push_back(score.intubation ? longest_attempt_time(scenario, score) : attempt_time(scenario, score));
  const std::array limits = {
      peak("peak_tongue_force_n", "Peak force on the tongue", score.peak_tongue_force_n, pass.peak_tongue_force_n,
           score.time_of_peak_tongue_force_s),
      peak("peak_gum_force_n", "Peak force on the gums", score.peak_gum_force_n, pass.peak_gum_force_n,
           score.time_of_peak_gum_force_s),
      at_most("time_over_target_s", "s", score.time_over_target_s, pass.time_over_target_s, moments.over_target_s,
              "Force on the tongue above its target of " + limit_text(scenario.targets.tongue_force_n) + " N for",
              since("first at", moments.over_target_s)),
      at_most("time_over_force_limit_s", "s", score.time_over_force_limit_s, pass.time_over_device_limit_s,
              moments.longest_off_tracking_s,
              "Device at its force limit of " + limit_text(log.header.device_limit_n) + " N or lost, for",
              since("longest from", moments.longest_off_tracking_s))};
  // Whoever did nothing has kept no limit; one that was passed all the same is told.
  std::copy_if(limits.begin(), limits.end(), std::back_inserter(score.criteria),
               [judged = blade_tried(score)](const Criterion& limit) { return judged || !limit.met; });
  if (moments.not_finite_s >= 0.0) {
    score.criteria.push_back(fact(
        "forces_finite", false, moments.not_finite_s,
        "A recorded force is not a number at " + second(moments.not_finite_s) + ": please report this trial's log"));
  }

  judge_choice(scenario, score.criteria);
  if (score.intubation) judge_intubation(scenario, !score.at_vallecula, *score.intubation, score.criteria);

  score.passed = true;
  for (const Criterion& c : score.criteria) score.passed = score.passed && c.met;
  score.reasons.clear();
  for (const Criterion& c : score.criteria) {
    if (c.met == score.passed) score.reasons.push_back(c.sentence);
  }
}

}  // namespace vallecula::curricula
