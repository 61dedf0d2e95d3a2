#include "curricula/score/checklist.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "curricula/score/attempts.h"
#include "curricula/score/criterion.h"
#include "curricula/score/score.h"
#include "curricula/score/vectors.h"

namespace vallecula::curricula {
namespace {

using Item = ChecklistItem;
using Done = ChecklistItem::Done;

/// A blade that enters so far to the left of the midline is at neither place where it may go in (assumed).
constexpr double kStillMiddleM = 0.003;
/// Less of the glottis beside the tube than this is none (assumed).
constexpr double kSomeOfIt = 0.1;
/// The tip stands before the larynx so near to where it goes in: half a tube's width (assumed).
constexpr double kBeforeLarynxM = 0.0025;
/// What was seen before it went in tells nothing of a passing later than this (assumed).
constexpr double kStandsS = 3.0;

Item item(const char* id, const char* text, bool done, double at_s, const std::string& sentence) {
  return {id, text, done ? Done::yes : Done::no, at_s, sentence};
}
Item not_seen(const char* id, const char* text, const std::string& sentence) {
  return {id, text, Done::not_seen, -1.0, sentence};
}

Item blade_entry(const Score& score) {
  const char *id = "blade_in_right_or_middle", *text = "Blade in at the right corner of the mouth or over the middle";
  if (!score.blade.entry_left_m)
    return not_seen(id, text, "The blade was never in the mouth, or its midline is unknown");
  const double left_m = *score.blade.entry_left_m;
  return item(id, text, left_m <= kStillMiddleM, score.attempt_start_s,
              "The tip came in " + millimetres(std::fabs(left_m)) + " to the " + (left_m > 0.0 ? "left" : "right") +
                  " of the midline");
}

Item vallecula(const Score& score) {
  const char *id = "vallecula_reached", *text = "Tip in the vallecula";
  const BladeFigures& blade = score.blade;
  if (!blade.to_vallecula_m) return not_seen(id, text, "The blade was never in the mouth");
  if (blade.vallecula_reached)
    return item(id, text, true, blade.vallecula_reached_at_s,
                "The tip came within " + millimetres(*blade.to_vallecula_m) + " of it");
  const std::string missed = "The tip came no nearer to it than " + millimetres(*blade.to_vallecula_m);
  if (score.time_of_first_sight_s >= 0.0)
    return not_seen(id, text, missed + ", but the glottis was seen: lifting the epiglottis itself is of equal worth");
  return item(id, text, false, blade.to_vallecula_at_s, missed);
}

Item lift(const Score& score, const Scenario& scenario) {
  const char *id = "no_levering", *text = "Lifted, not levered on the upper jaw";
  const ForceFigures& force = score.force;
  if (!force.lift_share) return not_seen(id, text, "Too little was lifted to tell");
  const std::string target = limit_text(scenario.targets.gum_force_n) + " N";
  if (force.levered_over_target_at_s < 0.0)
    return item(id, text, true, force.levered_n.at_s, "The upper jaw never bore more than " + target + " of the load");
  return item(id, text, false, force.levered_over_target_at_s,
              "From " + second(force.levered_over_target_at_s) + " on the upper jaw bore more than " + target +
                  " of the load, " + fixed(force.levered_n.value, 1) + " N at most");
}

Item view_before_tube(const Attempt* attempt) {
  const char *id = "view_before_tube", *text = "Glottis in sight before the tube passed";
  if (!attempt || !attempt->passed_cords_s) return not_seen(id, text, "No tube passed the cords in an attempt");
  const bool done = attempt->view_at_s && *attempt->view_at_s <= *attempt->passed_cords_s;
  return item(id, text, done, *attempt->passed_cords_s,
              done ? "In sight at " + second(*attempt->view_at_s) + ", passed at " + second(*attempt->passed_cords_s)
                   : "Passed at " + second(*attempt->passed_cords_s) + " without a view before");
}

/// By what was seen while the tip stood before the larynx: in it a tube that fits the opening fills it and hides it
/// itself, whoever leads it.
Item passed_in_sight(const Attempt* attempt, const TrialLog& log) {
  const char *id = "tube_passed_in_sight", *text = "Tube seen as it passed between the cords";
  if (!attempt || !attempt->passed_cords_s) return not_seen(id, text, "No tube passed the cords in an attempt");
  const double passed_s = *attempt->passed_cords_s;
  if (passed_s >= attempt->end_s)
    return item(id, text, false, passed_s, "Passed at " + second(passed_s) + " with the blade out");
  const auto passed =
      std::find_if(log.ticks.begin(), log.ticks.end(), [&](const LogTick& t) { return t.time_s >= passed_s; });
  auto entered = passed;
  while (entered != log.ticks.begin() && std::prev(entered)->intubation.place == LoggedPlace::larynx) --entered;
  const auto stood = std::count_if(entered, passed, [](const LogTick& t) { return !paused(t); });
  if (static_cast<double>(stood) * log.header.servo_period_s > kStandsS)
    return not_seen(id, text,
                    "The tip stood in the larynx for more than " + fixed(kStandsS, 0) +
                        " s before it passed, and hid it from the log");
  // Sight is sampled in some ticks only: the newest counts wherever the tip was.
  std::optional<double> seen;
  for (auto tick = entered; tick != log.ticks.begin();) {
    --tick;
    if (seen && distance(tick->intubation.tip_m, entered->intubation.tip_m) > kBeforeLarynxM) break;
    if (tick->has_sight && !paused(*tick)) seen = std::max(seen.value_or(0.0), tick->glottis_visible);
  }
  return item(id, text, seen.value_or(0.0) >= kSomeOfIt, passed_s,
              fixed(100.0 * seen.value_or(0.0), 0) +
                  " % of the glottis in sight beside it before the cords, passed at " + second(passed_s));
}

/// Of the tube that lies where it lies at the first breath through it.
Item stylet_out(const TrialLog& log) {
  const char *id = "stylet_out", *text = "Stylet out before the first breath through the tube";
  int breaths = 0;
  for (const LogTick& tick : log.ticks) {
    const bool breath = tick.intubation.breaths_given > breaths;
    breaths = tick.intubation.breaths_given;
    if (!breath || paused(tick) || !tube_past_cords(tick)) continue;
    const bool out = tick.intubation.in_hand != LoggedInHand::tube_with_stylet;
    return item(id, text, out, tick.time_s,
                (out ? "The first breath at " : "Still in at the first breath at ") + second(tick.time_s));
  }
  return not_seen(id, text, "No breath was given through a tube past the cords");
}

Item suction(const TrialLog& log, const IntubationScore& tube) {
  const auto sucked = std::find_if(log.ticks.begin(), log.ticks.end(), [&](const LogTick& tick) {
    return tick.intubation.in_hand == LoggedInHand::catheter &&
           tick.intubation.secretions_ml < 0.9 * tube.secretions_start_ml;
  });
  const bool done = sucked != log.ticks.end();
  return item("secretions_cleared", "Secretions cleared by suction", done, done ? sucked->time_s : -1.0,
              fixed(tube.secretions_start_ml, 1) + " ml at first, " + fixed(tube.secretions_end_ml, 1) +
                  " ml at the end" + (done ? "" : ", no catheter took them"));
}

Item ventilated_between(const std::vector<Attempt>& attempts) {
  const auto none = std::find_if(attempts.begin() + 1, attempts.end(),
                                 [](const Attempt& attempt) { return attempt.breaths_before == 0; });
  const bool done = none == attempts.end();
  return item("ventilated_between", "Ventilated between attempts", done, done ? attempts.back().start_s : none->start_s,
              done ? "Breaths before each further attempt"
                   : "The attempt at " + second(none->start_s) + " began without a breath before");
}

Item confirmed(const IntubationScore& tube, const Scenario& scenario) {
  const char *id = "co2_confirmed", *text = "Place confirmed by the CO2 detector";
  if (tube.breaths_in_place == 0)
    return item(id, text, false, -1.0, "No breath was given through a tube past the cords");
  if (!tube.co2_confirmed)
    return item(id, text, false, -1.0, "Not yellow after " + std::to_string(tube.breaths_in_place) + " breaths");
  return item(id, text, *tube.co2_breaths <= scenario.intubation->breaths_to_confirm, -1.0,
              "Yellow with breath " + std::to_string(*tube.co2_breaths));
}

void add_tube(const Score& score, const TrialLog& log, const Scenario& scenario, std::vector<Item>& items) {
  const IntubationScore& tube = *score.intubation;
  const Attempt* decisive = tube.decisive();
  if (tube.secretions_start_ml > 0.0) items.push_back(suction(log, tube));
  items.push_back(view_before_tube(decisive));
  items.push_back(passed_in_sight(decisive, log));
  if (scenario.intubation->stylet) items.push_back(stylet_out(log));
  items.push_back(confirmed(tube, scenario));
  const double end_s = log.ticks.empty() ? -1.0 : log.ticks.back().time_s;
  items.push_back(
      item("depth_good", "Tip at a good depth", tube.outcome == Outcome::good_depth, end_s, outcome_in_words(tube)));
  if (tube.oesophagus_breaths > 0)
    items.push_back(item("oesophagus_recognised", "Tube in the oesophagus recognised in time",
                         tube.oesophagus_in_time(), tube.recognised_late ? tube.recognised_late_at_s : -1.0,
                         std::to_string(tube.oesophagus_breaths) + " breaths were given there"));
  if (tube.attempts.size() > 1) items.push_back(ventilated_between(tube.attempts));
}

}  // namespace

const char* name_of(ChecklistItem::Done done) {
  return done == Done::yes ? "yes" : done == Done::no ? "no" : "not seen";
}

std::vector<ChecklistItem> checklist_of(const Score& score, const TrialLog& log, const Scenario& scenario) {
  const std::string instructor = "No log can tell";
  std::vector<Item> items = {not_seen("equipment_checked", "Tube, blade, light and suction checked before", instructor),
                             not_seen("handle_in_left_hand", "Handle in the left hand", instructor), blade_entry(score),
                             vallecula(score), lift(score, scenario)};
  if (score.intubation) add_tube(score, log, scenario, items);
  items.push_back(not_seen("team_told", "Told the team what was seen and done", instructor));
  return items;
}

}  // namespace vallecula::curricula
