#include "curricula/score/intubation_rubric.h"

#include <algorithm>
#include <cmath>

#include "curricula/score/criterion.h"

namespace vallecula::curricula {
namespace {

std::string at(double time_s) { return time_s < 0.0 ? std::string() : " at " + second(time_s); }

Criterion outcome(const IntubationPass& pass, const IntubationScore& score) {
  const bool met = std::count(pass.outcomes.begin(), pass.outcomes.end(), score.outcome) != 0;
  std::string sentence = outcome_in_words(score);
  if (!met) {
    sentence += "; asked for: ";
    for (const Outcome accepted : pass.outcomes)
      sentence += (accepted == pass.outcomes.front() ? "" : ", ") + words_of(accepted);
  }
  const Attempt* decisive = score.decisive();
  return fact("outcome", met, decisive && decisive->passed_cords_s ? *decisive->passed_cords_s : -1.0, sentence);
}

/// The lowest that the monitor showed: what never fell, in whole figures, below what the first attempt began with is
/// not said to have fallen.
Criterion lowest(const char* name, const char* unit, double value, double at_s, const std::optional<double>& first,
                 double limit, const std::string& what) {
  Criterion c = at_least(name, unit, value, limit, at_s, what + " fell to", at(at_s));
  const bool fell = !first || std::round(value) < std::round(*first);
  // So low no saturation has a figure for a person, unless its limit is as low.
  const bool bare = c.unit == "%" && limit >= kLeastToldSpo2 && std::round(value) < kLeastToldSpo2;
  if (fell && !bare) return c;
  const std::string told = bare ? told_spo2(value) : figure(c);
  if (fell) {
    c.sentence = what + " fell to " + told + " " + unit + at(at_s) + ", less than the " + limit_text(limit) + " " +
                 unit + " asked for";
    return c;
  }
  c.sentence = what + (c.met ? " stayed at " : " began at ") + told + " " + unit +
               (c.met ? " or above, at least the " : " and fell no further, less than the ") + limit_text(limit) + " " +
               unit + " asked for";
  return c;
}

Criterion co2(const IntubationScore& score, int breaths_to_confirm) {
  const std::string allowed = std::to_string(breaths_to_confirm) + " breaths allowed";
  if (!score.co2_confirmed) {
    return {"co2_confirmed",
            "",
            static_cast<double>(score.breaths_in_place),
            static_cast<double>(breaths_to_confirm),
            -1.0,
            false,
            "The tube's place was not confirmed: the detector did not turn yellow with " +
                std::to_string(score.breaths_in_place) + " breaths through it, of " + allowed};
  }
  const bool met = *score.co2_breaths <= breaths_to_confirm;
  return {"co2_confirmed",
          "",
          static_cast<double>(*score.co2_breaths),
          static_cast<double>(breaths_to_confirm),
          -1.0,
          met,
          "The detector turned yellow with breath " + std::to_string(*score.co2_breaths) +
              (met ? ", within the " : ", more than the ") + allowed};
}

/// Where the tip lies once the roll under the shoulders is gone: lower in the trachea.
Criterion depth_neutral(const IntubationScore& score) {
  const double share = *score.depth_neutral_share();
  const bool met = in_middle_third(share);
  return fact("depth_neutral", met, -1.0,
              "With the head neutral the tube's tip lies about " + millimetres(*score.depth_neutral_m) +
                  " past the cords, " + fixed(100.0 * share, 0) + " % of the way to the carina: " +
                  (met           ? "in the middle third"
                   : share > 0.5 ? "to be drawn back"
                                 : "to be advanced"));
}

Criterion oesophagus_in_time(const IntubationScore& score, int breaths_to_confirm) {
  const std::string allowed = std::to_string(breaths_to_confirm) + " breaths in one stay";
  if (!score.oesophagus_in_time() && !score.recognised_late)
    return fact("oesophagus_in_time", false, -1.0, "The tube lay in the oesophagus to the end: it was not recognised");
  return fact("oesophagus_in_time", !score.recognised_late, score.recognised_late_at_s,
              score.recognised_late ? "The tube in the oesophagus was recognised late: more than " + allowed +
                                          at(score.recognised_late_at_s)
              : score.oesophagus_entries > 0 ? "The tube in the oesophagus was recognised within " + allowed
                                             : "The tube was never in the oesophagus");
}

Criterion no_severe_desaturation(const IntubationScore& score) {
  const auto worst = std::find_if(score.attempts.begin(), score.attempts.end(),
                                  [](const Attempt& attempt) { return attempt.desaturated; });
  const std::string points = fixed(kSevereDesaturation, 0) + " points or more";
  if (worst == score.attempts.end())
    return fact("no_severe_desaturation", true, -1.0, "In no attempt did saturation fall by " + points);
  return fact("no_severe_desaturation", false, worst->start_s,
              "In attempt " + std::to_string(worst - score.attempts.begin() + 1) + " of " +
                  std::to_string(score.attempts.size()) + ", begun at " + second(worst->start_s) +
                  ", saturation fell by " + points + ", from " + told_spo2(worst->highest_spo2_before_percent) +
                  " to " + told_spo2(worst->lowest_spo2_percent) + " %");
}

/// The blade was in the mouth, or the tube touched or entered something: only then has a tube kept a limit.
bool tube_tried(const IntubationScore& score) {
  return !score.attempts.empty() || score.deepest_m > 0.0 || score.oesophagus_entries > 0 ||
         std::any_of(score.loads_n.begin(), score.loads_n.end(), [](const Peak& load) { return load.value > 0.0; });
}

/// Whether a detector has anything to say: the tube lies in the airway or in the oesophagus.
bool lies_somewhere(Outcome outcome) {
  return outcome == Outcome::good_depth || outcome == Outcome::too_shallow || outcome == Outcome::too_deep ||
         outcome == Outcome::mainstem || outcome == Outcome::oesophagus;
}

}  // namespace

std::string outcome_in_words(const IntubationScore& score) {
  const auto depth = [&](const char* verdict) {
    return "The tube's tip lies " + millimetres(*score.depth_m) + " past the cords, " +
           fixed(100.0 * *score.depth_share(), 0) + " % of the way to the carina: " + verdict;
  };
  switch (score.outcome) {
    case Outcome::good_depth:
      return depth("good depth");
    case Outcome::too_shallow:
      return depth("in the trachea, but to be advanced");
    case Outcome::too_deep:
      return depth("in the trachea, but to be drawn back");
    case Outcome::mainstem:
      return "The tube's tip lies in " + bronchus_in_words(score) + ": only one lung gets air";
    case Outcome::oesophagus:
      return "The tube lies in the oesophagus";
    case Outcome::cricoid_too_narrow:
      return "The tube was stopped by the cricoid and never came past it";
    case Outcome::cords_closed:
      return "The cords were closed, and the tube is not past them";
    case Outcome::abandoned:
      return "The tube is not in the trachea: the intubation was given up";
    case Outcome::out_of_time:
      return "The trial's time was over before the tube was in the trachea";
  }
  return "";
}

std::string told_spo2(double percent) {
  return std::round(percent) < kLeastToldSpo2 ? "below " + fixed(kLeastToldSpo2, 0) : fixed(percent, 0);
}

std::string bronchus_in_words(const IntubationScore& score) {
  return score.bronchus_side == 0   ? "the right main bronchus"
         : score.bronchus_side == 1 ? "the left main bronchus"
                                    : "a main bronchus";
}

const char* name_of(LoggedTubeLoad load) {
  static constexpr std::array<const char*, kTubeLoads> kNames = {"vestibule", "cords",      "subglottis", "cricoid",
                                                                 "trachea",   "bronchus",   "oesophagus", "pharynx",
                                                                 "tongue",    "epiglottis", "blade"};
  return kNames[static_cast<std::size_t>(load)];
}

Criterion longest_attempt_time(const Scenario& scenario, const Score& score) {
  const std::vector<Attempt>& attempts = score.intubation->attempts;
  const Attempt& longest = *score.intubation->longest();
  const auto number = &longest - attempts.data() + 1;
  std::string what = "The attempt took";
  if (attempts.size() > 1)
    what = "Attempt " + std::to_string(number) + " of " + std::to_string(attempts.size()) + ", the longest, took";
  std::string when = " (" + second(longest.start_s) + " to " + second(longest.end_s);
  if (longest.paused_s > 0.0) when += ", paused for " + second(longest.paused_s);
  if (!score.blade_out && &longest == &attempts.back()) when += ", the blade was still in the mouth";
  return at_most("attempt_time_s", "s", longest.time_s, scenario.pass.attempt_time_s, longest.start_s, what,
                 when + ")");
}

void judge_intubation(const Scenario& scenario, bool timed, const IntubationScore& score,
                      std::vector<Criterion>& criteria) {
  const IntubationPass& pass = scenario.intubation->pass;
  criteria.push_back(outcome(pass, score));
  if (pass.lowest_spo2_percent && score.lowest_spo2_percent)
    criteria.push_back(lowest("lowest_spo2_percent", "%", *score.lowest_spo2_percent, score.lowest_spo2_at_s,
                              score.first_spo2_percent, *pass.lowest_spo2_percent, "Saturation"));
  if (pass.lowest_heart_per_min && score.lowest_heart_per_min)
    criteria.push_back(lowest("lowest_heart_per_min", "per minute", *score.lowest_heart_per_min,
                              score.lowest_heart_at_s, score.first_heart_per_min, *pass.lowest_heart_per_min,
                              "The heart"));
  if (pass.tube_force_n) {
    const Peak& peak = score.tip_load_n;
    const std::string against = score.tip_against < kTubeLoads
                                    ? std::string(" (") + name_of(static_cast<LoggedTubeLoad>(score.tip_against)) + ")"
                                    : std::string();
    const Criterion push =
        at_most("tube_force_n", "N", peak.value, *pass.tube_force_n, peak.at_s,
                "The tube was pushed against what stood before its tip" + against + " with", at(peak.at_s));
    if (tube_tried(score) || !push.met) criteria.push_back(push);
  }
  const Attempt* decisive = score.decisive();
  if (pass.time_to_pass_s && timed && decisive && decisive->time_to_pass_s) {
    const char* since = decisive->view_at_s && *decisive->view_at_s <= *decisive->passed_cords_s
                            ? "From the view to the cords passed it took"
                            : "From the blade in the mouth to the cords passed, without a view, it took";
    const char* blade = *decisive->passed_cords_s >= decisive->end_s ? ", with the blade out already" : "";
    criteria.push_back(at_most("time_to_pass_s", "s", *decisive->time_to_pass_s, *pass.time_to_pass_s,
                               *decisive->passed_cords_s, since, at(*decisive->passed_cords_s) + blade));
  } else if (pass.time_to_pass_s && timed && score.passed_untimed()) {
    criteria.push_back(fact("time_to_pass_s", false, -1.0,
                            "The cords were passed before the blade was in the mouth, so not under sight"));
  }
  if (pass.attempts && !score.attempts.empty()) {  // without one "attempt_begun" says what is wrong: no limit was kept
    const auto count = static_cast<double>(score.attempts.size());
    const auto limit = static_cast<double>(*pass.attempts);
    criteria.push_back({"attempts", "", count, limit, score.attempts.back().start_s, count <= limit,
                        std::to_string(score.attempts.size()) +
                            (score.attempts.size() == 1 ? " attempt, " : " attempts, ") +
                            (count <= limit ? "within the " : "more than the ") + limit_text(limit) + " allowed"});
  }
  if (pass.co2_confirmed && lies_somewhere(score.outcome))
    criteria.push_back(co2(score, scenario.intubation->breaths_to_confirm));
  if (pass.depth_neutral && score.depth_neutral_m) criteria.push_back(depth_neutral(score));
  if (pass.oesophagus_in_time && tube_tried(score))
    criteria.push_back(oesophagus_in_time(score, scenario.intubation->breaths_to_confirm));
  if (pass.no_severe_desaturation && !score.attempts.empty()) criteria.push_back(no_severe_desaturation(score));
}

}  // namespace vallecula::curricula
