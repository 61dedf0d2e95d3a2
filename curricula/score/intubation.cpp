// Where the tube's tip really was, what it pressed on, and what told of its place.
#include "curricula/score/intubation.h"

#include <algorithm>
#include <cmath>

#include "curricula/score/attempts.h"
#include "curricula/score/vectors.h"

namespace vallecula::curricula {
namespace {

constexpr double kStoppedN = 0.5;  ///< along the tube: from here on closed cords before the tip stop it (assumed)
/// Likewise of the cricoid: tubes that fit take up to 1.5 N there (engine/README.md), and only more says "too narrow".
constexpr double kCricoidStopsN = 2.0;
/// In all, while the tube stands there: one that opening cords let go of springs forward and knocks on it for some
/// milliseconds (assumed).
constexpr double kCricoidStopsS = 0.1;
constexpr double kAtTheLastS = 1.0;    ///< before the end: the tube still stands against it (assumed)
constexpr double kJustBeforeS = 10.0;  ///< before the end: the cricoid is what it was given up for (assumed)
constexpr double kBevelM = 0.008;  ///< a bevelled tip reaches past what holds the tube's full width by less than this
constexpr double kClosedOpening = 0.25;  ///< cords nearer together let no tube between them (assumed)
/// The head's flexion moves the tip down by this, for one degree (assumed: 5 mm for the 25 degrees of sniffing; it is
/// less in smaller infants).
constexpr double kTipDownPerDegreeM = 0.0002;
/// Mark at the lip by weight: kg and so many centimetres. It hits the middle of the trachea in 51 to 57 % of infants,
/// so it is told and never judged.
constexpr double kLipsCm = 6.0;
constexpr double kAssistantDegrees = 10.0;  ///< that the assistant extends the head further (engine::kExtension)

/// The tube stood against the cricoid, or against closed cords.
struct Stop {
  bool was = false;
  bool by_cords = false;
  double worked_s = 0.0;  ///< of the trial until then, less pauses
  double depth_m = 0.0;   ///< of the tip, past the cords
};

struct Course {
  const LogTick* last = nullptr;  ///< that was not paused; null: there is none
  Stop stop;                      ///< the last
  bool past_cricoid = false;      ///< ever
  double worked_s = 0.0;          ///< of the trial, less pauses
};

bool cords_closed(const LogIntubation& i) { return i.spasm || i.glottis_opening < kClosedOpening; }

bool forces_finite(const LogIntubation& i) {
  return std::isfinite(magnitude(i.model_force_n)) && std::isfinite(magnitude(i.displayed_force_n)) &&
         std::isfinite(i.tip_load_n) &&
         std::all_of(i.loads_n.begin(), i.loads_n.end(), [](double load) { return std::isfinite(load); });
}

void measure_forces(const LogTick& tick, IntubationScore& score) {
  const LogIntubation& i = tick.intubation;
  if (i.in_hand == LoggedInHand::catheter) return;
  if (std::isfinite(i.tip_load_n) && i.tip_load_n > score.tip_load_n.value) score.tip_against = i.tip_against;
  score.tip_load_n.take(i.tip_load_n, tick.time_s);
  for (std::size_t part = 0; part < kTubeLoads; ++part) score.loads_n[part].take(i.loads_n[part], tick.time_s);
  score.hand_force_n.take(magnitude(i.model_force_n), tick.time_s);
  score.displayed_hand_force_n.take(magnitude(i.displayed_force_n), tick.time_s);
  if (std::isfinite(i.buckled_m)) score.buckled_m = std::max(score.buckled_m, i.buckled_m);
  if (tube_past_cords(tick)) score.deepest_m = std::max(score.deepest_m, i.past_cords_m);
}

void measure_infant(const LogTick& tick, IntubationScore& score) {
  const LogIntubation& i = tick.intubation;
  const auto lower = [&](std::optional<double>& first, std::optional<double>& lowest, double& at_s, double value) {
    if (!std::isfinite(value) || (lowest && value >= *lowest)) return;
    if (!first) first = value;
    lowest = value;
    at_s = tick.time_s;
  };
  lower(score.first_spo2_percent, score.lowest_spo2_percent, score.lowest_spo2_at_s, 100.0 * i.spo2);
  lower(score.first_heart_per_min, score.lowest_heart_per_min, score.lowest_heart_at_s, i.heart_per_min);
}

Course follow(const TrialLog& log, const std::vector<Attempt>& attempts, IntubationScore& score) {
  Course course;
  long long worked = 0, at_cricoid = 0;
  for (const LogTick& tick : log.ticks) {
    if (paused(tick)) continue;
    const LogIntubation& i = tick.intubation;
    ++worked;
    course.last = &tick;
    course.past_cricoid = course.past_cricoid || (tube_past_cords(tick) && i.place != LoggedPlace::larynx);
    measure_forces(tick, score);
    if (!attempts.empty() && tick.time_s >= attempts.front().start_s) measure_infant(tick, score);
    course.worked_s = static_cast<double>(worked) * log.header.servo_period_s;
    if (i.in_hand == LoggedInHand::catheter || !(i.tip_load_n >= kStoppedN)) {
      at_cricoid = 0;
      continue;
    }
    const bool by_cords = i.tip_against == kTubeCords && cords_closed(i);
    at_cricoid += i.tip_against == kTubeCricoid && i.tip_load_n >= kCricoidStopsN;
    const bool by_cricoid = i.tip_against == kTubeCricoid && i.tip_load_n >= kCricoidStopsN &&
                            static_cast<double>(at_cricoid) * log.header.servo_period_s >= kCricoidStopsS;
    if (by_cords || by_cricoid)
      course.stop = {true, by_cords, course.worked_s, i.past_cords_m};
    else if (course.stop.was && !course.stop.by_cords && i.past_cords_m < course.stop.depth_m + kBevelM)
      course.stop.worked_s = course.worked_s;  // pressed on less, or on what lies next to it: it stands there still
  }
  return course;
}

/// Breaths given while the tip lay in the oesophagus, stay by stay.
void measure_oesophagus(const TrialLog& log, int breaths_to_confirm, IntubationScore& score) {
  bool there = false;
  int before = 0, breaths = 0;  // of the trial until now; of this stay
  for (const LogTick& tick : log.ticks) {
    if (paused(tick)) continue;
    const bool was_there = there;
    there = tube_in_oesophagus(tick);
    if (there && !was_there) {
      ++score.oesophagus_entries;
      breaths = 0;
    }
    if (there) {
      const int now = std::max(0, tick.intubation.breaths_given - before);
      breaths += now;
      score.oesophagus_breaths += now;
      if (breaths > 0) score.oesophagus_s += log.header.servo_period_s;
      if (!score.recognised_late && breaths > breaths_to_confirm) {
        score.recognised_late = true;
        score.recognised_late_at_s = tick.time_s;
      }
    }
    before = tick.intubation.breaths_given;
  }
}

/// The detector while the tube lay where it lies at the end.
void measure_confirmation(const TrialLog& log, IntubationScore& score) {
  bool in = false;
  int before = 0, at_begin = 0;
  for (const LogTick& tick : log.ticks) {
    if (paused(tick)) continue;
    const int breaths = tick.intubation.breaths_given;
    const bool was_in = in;
    in = tube_past_cords(tick);
    if (!in || !was_in) {
      score.co2_confirmed = false;
      score.co2_breaths.reset();
      score.breaths_in_place = 0;
      at_begin = before;
    }
    if (in) score.breaths_in_place = breaths - at_begin;
    if (in && !score.co2_confirmed && tick.intubation.detector_yellow && score.breaths_in_place > 0) {
      score.co2_confirmed = true;
      score.co2_breaths = score.breaths_in_place;
    }
    before = breaths;
  }
}

/// The cords were shut when the last attempt ended: laryngospasm, before which nobody need push.
bool spasm_ended_it(const TrialLog& log, const std::vector<Attempt>& attempts) {
  if (attempts.empty()) return false;
  const auto after = std::find_if(log.ticks.begin(), log.ticks.end(),
                                  [&](const LogTick& tick) { return tick.time_s >= attempts.back().end_s; });
  return after != log.ticks.begin() && std::prev(after)->intubation.spasm;
}

Outcome outcome_of_depth(double share) {
  if (in_middle_third(share)) return Outcome::good_depth;
  return share > 2.0 / 3.0 ? Outcome::too_deep : Outcome::too_shallow;
}

Outcome outcome_of(const TrialLog& log, const Scenario& scenario, const Course& course, const IntubationScore& score) {
  if (course.last == nullptr) return Outcome::abandoned;
  const LogTick& last = *course.last;
  if (tube_in_oesophagus(last)) return Outcome::oesophagus;
  const bool in = tube_past_cords(last);
  if (in && last.intubation.place == LoggedPlace::main_bronchus) return Outcome::mainstem;
  const double since_stop_s = course.worked_s - course.stop.worked_s;
  const bool stands = course.stop.was && since_stop_s <= kAtTheLastS;
  if (stands && score.deepest_m < course.stop.depth_m + kBevelM)
    return course.stop.by_cords ? Outcome::cords_closed : Outcome::cricoid_too_narrow;
  if (in && last.intubation.place == LoggedPlace::trachea) return outcome_of_depth(*score.depth_share());

  // Not past the cricoid, then: what stopped it?
  const bool by_cricoid =
      course.stop.was && !course.stop.by_cords && !course.past_cricoid && since_stop_s <= kJustBeforeS;
  const bool by_cords = (course.stop.was && course.stop.by_cords) || spasm_ended_it(log, score.attempts);
  if (by_cricoid && (stands || in)) return Outcome::cricoid_too_narrow;
  if (in) return Outcome::too_shallow;
  if (by_cords && stands) return Outcome::cords_closed;
  if (course.worked_s >= scenario.max_attempt_s) return Outcome::out_of_time;
  if (by_cricoid) return Outcome::cricoid_too_narrow;
  return by_cords ? Outcome::cords_closed : Outcome::abandoned;
}

}  // namespace

IntubationScore measure_intubation(const TrialLog& log, const Scenario& scenario, double& not_finite_s) {
  IntubationScore score;
  const auto& settings = log.header.settings;
  score.cords_to_carina_m = settings.at(kCordsToCarina);
  score.lips_rule_m = lips_rule_m(scenario.manikin.weight_kg);
  score.attempts = measure_attempts(log, scenario);
  const Course course = follow(log, score.attempts, score);
  measure_oesophagus(log, scenario.intubation->breaths_to_confirm, score);
  measure_confirmation(log, score);
  if (course.last != nullptr) {
    const LogIntubation& last = course.last->intubation;
    score.breaths_given = last.breaths_given;
    score.secretions_start_ml = log.ticks.front().intubation.secretions_ml;
    score.secretions_end_ml = last.secretions_ml;
    if (last.in_hand != LoggedInHand::catheter) {
      score.bronchus_side = last.side;
      if (last.at_mouth_m > 0.0 && settings.count(kLipsBeforeGums) > 0) score.at_lips_m = last.at_mouth_m;
    }
    if (tube_past_cords(*course.last) && last.place != LoggedPlace::main_bronchus) {
      score.depth_m = last.past_cords_m;
      const auto extension = settings.find(kHeadExtension);
      if (extension != settings.end())
        score.depth_neutral_m =
            last.past_cords_m +
            kTipDownPerDegreeM *
                (extension->second + ((course.last->buttons & kLoggedExtension) != 0 ? kAssistantDegrees : 0.0));
    }
  }
  score.outcome = outcome_of(log, scenario, course, score);
  for (const LogTick& tick : log.ticks) {
    if (forces_finite(tick.intubation)) continue;
    if (not_finite_s < 0.0 || tick.time_s < not_finite_s) not_finite_s = tick.time_s;
    break;
  }
  return score;
}

double lips_rule_m(double weight_kg) { return 0.01 * (weight_kg + kLipsCm); }

const Attempt* IntubationScore::decisive() const {
  const auto passed = std::find_if(attempts.rbegin(), attempts.rend(),
                                   [](const Attempt& attempt) { return attempt.time_to_pass_s.has_value(); });
  if (passed != attempts.rend()) return &*passed;
  return attempts.empty() ? nullptr : &attempts.back();
}

const Attempt* IntubationScore::longest() const {
  const auto found = std::max_element(attempts.begin(), attempts.end(),
                                      [](const Attempt& a, const Attempt& b) { return a.time_s < b.time_s; });
  return found == attempts.end() ? nullptr : &*found;
}

std::optional<double> IntubationScore::depth_share() const {
  if (!depth_m) return std::nullopt;
  return *depth_m / cords_to_carina_m;
}

std::optional<double> IntubationScore::depth_error_m() const {
  if (!depth_m) return std::nullopt;
  return *depth_m - 0.5 * cords_to_carina_m;
}

std::optional<double> IntubationScore::depth_neutral_share() const {
  if (!depth_neutral_m) return std::nullopt;
  return *depth_neutral_m / cords_to_carina_m;
}

bool IntubationScore::passed_untimed() const {
  return deepest_m > 0.0 && std::none_of(attempts.begin(), attempts.end(),
                                         [](const Attempt& attempt) { return attempt.time_to_pass_s.has_value(); });
}

}  // namespace vallecula::curricula
