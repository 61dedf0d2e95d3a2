#include "curricula/score/figures.h"

#include <algorithm>
#include <cmath>

namespace vallecula::curricula {
namespace {

using Value = std::optional<double>;
constexpr const char* kNear4Neos = "NEAR4NEOS";
constexpr const char* kOwn = "own";
constexpr const char* kLever = "own; shown apart as in the Imperial trainer (ICRA 2023)";

Value times(const Value& value, double factor) { return value ? Value(factor * *value) : std::nullopt; }
Value in_mm(const Value& metres) { return times(metres, 1e3); }
Value in_percent(const Value& share) { return times(share, 100.0); }
Value if_begun(const Score& score, double value) { return score.attempt_begun ? Value(value) : std::nullopt; }

Value from_zero(double value) { return value >= 0.0 ? Value(value) : std::nullopt; }

/// Of a trial with an intubation; else nothing.
template <class Get>
Value of_intubation(const Score& score, Get get) {
  return score.intubation ? Value(get(*score.intubation)) : std::nullopt;
}

/// Of a trial with a dual task; else nothing.
template <class Get>
Value of_dual_task(const Score& score, Get get) {
  return score.dual_task ? Value(get(*score.dual_task)) : std::nullopt;
}

double any(const Score& score, bool Attempt::*what) {
  const auto& attempts = score.intubation->attempts;
  return std::any_of(attempts.begin(), attempts.end(), [what](const Attempt& one) { return one.*what; }) ? 1.0 : 0.0;
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      {"passed", "Passed", "", "every limit of the scenario was kept", kOwn, false, 1,
       [](const Score& s) { return s.set_aside.empty() ? Value(s.passed ? 1.0 : 0.0) : std::nullopt; }},
      {"attempt_time_s", "Attempt time", "s", "blade into the mouth to blade out, less pauses; of several the longest",
       kNear4Neos, false, -1, [](const Score& s) { return s.attempt_begun ? Value(s.attempt_time_s) : std::nullopt; }},
      {"time_to_trachea_visible_s", "Time to first sight", "s",
       "from the attempt's start to the first sight of as much of the glottis as the scenario asks for", kOwn, false,
       -1, [](const Score& s) { return from_zero(s.time_to_trachea_visible_s); }},
      {"glottis_visible_max_percent", "Best view of the glottis", "%", "largest share of the glottis in sight (POGO)",
       "Levitan 1998", false, 1, [](const Score& s) { return Value(s.glottis_visible_max_percent); }},
      {"peak_tongue_force_n", "Peak tongue force", "N", "largest single tick of the model force on the tongue", kOwn,
       false, -1, [](const Score& s) { return Value(s.peak_tongue_force_n); }},
      {"peak_gum_force_n", "Peak gum force", "N", "largest single tick of the model force on the gums", kOwn, false, -1,
       [](const Score& s) { return Value(s.peak_gum_force_n); }},
      {"time_over_target_s", "Time over the target force", "s",
       "time with more model force on the tongue than the scenario's target", kOwn, false, -1,
       [](const Score& s) { return Value(s.time_over_target_s); }},
      {"time_over_force_limit_s", "Time over the device limit", "s",
       "time in which the device was at its limit, or had let go because of it", kOwn, false, -1,
       [](const Score& s) { return Value(s.time_over_force_limit_s); }},
      {"attempts", "Attempts", "", "ways of the blade into the mouth and out", kNear4Neos, false, -1,
       [](const Score& s) {
         return of_intubation(s, [](const IntubationScore& i) { return static_cast<double>(i.attempts.size()); });
       }},
      {"time_to_pass_s", "Time to pass the tube", "s",
       "from the view (else the attempt's start) to the tip past the cords, in the decisive attempt", kNear4Neos, false,
       -1,
       [](const Score& s) {
         return s.intubation && s.intubation->decisive() ? s.intubation->decisive()->time_to_pass_s : Value();
       }},
      {"lowest_spo2_percent", "Lowest saturation", "%", "displayed, from the first attempt on", kNear4Neos, false, 1,
       [](const Score& s) { return s.intubation ? s.intubation->lowest_spo2_percent : Value(); }},
      {"lowest_heart_per_min", "Lowest heart rate", "1/min", "from the first attempt on", kNear4Neos, false, 1,
       [](const Score& s) { return s.intubation ? s.intubation->lowest_heart_per_min : Value(); }},
      {"desaturated", "Severe desaturation", "",
       "in any attempt the displayed saturation fell by 20 points or more from the highest before it", kNear4Neos,
       false, -1, [](const Score& s) { return s.intubation ? Value(any(s, &Attempt::desaturated)) : std::nullopt; }},
      {"bradycardia", "Bradycardia", "", "in any attempt the heart was below 100 per minute", kNear4Neos, false, -1,
       [](const Score& s) { return s.intubation ? Value(any(s, &Attempt::bradycardia)) : std::nullopt; }},
      {"depth_error_mm", "Tube's depth error", "mm",
       "of the tip in larynx or trachea at the end, from the middle of the good third of this infant's way from the "
       "cords "
       "to the carina; positive: too deep",
       kOwn, false, 0, [](const Score& s) { return s.intubation ? in_mm(s.intubation->depth_error_m()) : Value(); }},
      {"tube_at_lips_cm", "Tube's mark at the lips", "cm",
       "the tube's length inside the upper lip at the end; by the rule, which is a help and judges nothing, the weight "
       "in kg and 6 cm",
       kOwn, false, 0,
       [](const Score& s) {
         return s.intubation && s.intubation->at_lips_m ? Value(100.0 * *s.intubation->at_lips_m) : std::nullopt;
       }},
      {"mean_tongue_force_n", "Mean tongue force", "N",
       "mean of the model force on the tongue over the time in which there was any", "PMID 1519691", false, -1,
       [](const Score& s) { return s.force.mean_tongue_n; }},
      {"tongue_force_integral_ns", "Tongue force over time", "N s",
       "integral of the model force on the tongue over the trial", "PMID 1519691", false, -1,
       [](const Score& s) { return Value(s.force.tongue_integral_ns); }},
      {"peak_tongue_pressure_kpa", "Peak tongue pressure", "kPa",
       "largest mean pressure over the contact with the tongue in a tick with 0.5 N or more on it: force by the area "
       "of the "
       "tissue's surface at rest that the contacts stand for",
       kOwn, false, -1,
       [](const Score& s) {
         const auto& pressed = s.force.tongue_pressure_pa;
         return pressed ? Value(1e-3 * pressed->value) : std::nullopt;
       }},
      {"lift_share_percent", "Lifted, not levered", "%",
       "share of the load of tongue and epiglottis, along the handle, that the upper jaw did not bear as a fulcrum",
       kLever, false, 1, [](const Score& s) { return in_percent(s.force.lift_share); }},
      {"peak_levered_n", "Peak levered load", "N", "largest part of that load that the upper jaw bore in a tick",
       kLever, false, -1, [](const Score& s) { return Value(s.force.levered_n.value); }},
      {"peak_palate_force_n", "Peak palate force", "N", "largest single tick of the model force on the palate", kOwn,
       false, -1, [](const Score& s) { return Value(s.peak_force_n[kPalate]); }},
      {"time_to_stable_view_s", "Time to stable view", "s",
       "from the attempt's start to the begin of the first 2 s in one piece with as much of the glottis in sight as "
       "the "
       "scenario asks for; 2 s are assumed",
       kOwn, false, -1, [](const Score& s) { return s.view.time_to_stable_s; }},
      {"mean_glottis_visible_percent", "Mean view of the glottis", "%",
       "mean share of the glottis in sight (POGO), over the time in the attempts in which there was any",
       "Levitan 1998", false, 1, [](const Score& s) { return s.view.mean_percent; }},
      {"cormack_lehane", "Cormack-Lehane grade", "",
       "1: more than half of the glottis seen at best, 2: less of it; 3 and 4 are none, for no log knows whether the "
       "epiglottis was in sight",
       "Cormack and Lehane 1984", false, -1,
       [](const Score& s) {
         const auto grade = cormack_lehane(s.glottis_visible_max_percent);
         return grade ? Value(*grade) : std::nullopt;
       }},
      {"entry_left_mm", "Blade's entry left of the midline", "mm",
       "of the tip as it first enters the mouth; negative: to the patient's right", kOwn, false, 0,
       [](const Score& s) { return in_mm(s.blade.entry_left_m); }},
      {"blade_from_midline_mm", "Blade's tip from the midline", "mm",
       "distance of the tip from the plane through gum midlines and vallecula when it is nearest to the vallecula",
       kOwn, false, -1,
       [](const Score& s) { return s.blade.left_m ? Value(1e3 * std::fabs(*s.blade.left_m)) : std::nullopt; }},
      {"tip_to_vallecula_mm", "Blade's tip to the vallecula", "mm",
       "least distance of the tip from the vallecula's landmark at rest", kOwn, false, -1,
       [](const Score& s) { return in_mm(s.blade.to_vallecula_m); }},
      {"vallecula_reached", "Vallecula reached", "",
       "the tip came within 15 % of the way from gums to vallecula of it; assumed", kOwn, false, 1,
       [](const Score& s) { return if_begun(s, s.blade.vallecula_reached ? 1.0 : 0.0); }},
      {"past_vallecula_mm", "Blade's tip past the vallecula", "mm",
       "farthest of the tip beyond the vallecula at rest, along the way from the gums to it", kOwn, false, -1,
       [](const Score& s) { return if_begun(s, 1e3 * s.blade.past_vallecula_m); }},
      {"mouth_entries", "Entries of the blade", "", "times the tip came into the mouth after a second or more outside",
       kOwn, false, -1, [](const Score& s) { return Value(s.mouth_entries); }},
      {"tip_path_mm", "Way of the blade's tip", "mm", "length of the tip's way in the attempts, from means of 20 ms",
       kOwn, false, -1, [](const Score& s) { return if_begun(s, 1e3 * s.motion.tip_path_m); }},
      {"smoothness_sparc", "Smoothness of the hand", "",
       "spectral arc length of the tip's speed in an attempt's longest stretch without a pause (10 Hz, threshold 5 %, "
       "padding 4, sampled at 50 Hz)",
       "Balasubramanian 2015", true, 1, [](const Score& s) { return s.motion.smoothness; }},
      {"tremor_mm", "Tremor of the hand", "mm",
       "root mean square of the tip's way from 4 to 12 Hz over the same stretch, three axes together", kOwn, true, -1,
       [](const Score& s) { return in_mm(s.motion.tremor_m); }},
      {"dual_task_reaction_s", "Mean reaction time", "s",
       "from a question or alarm shown to its answer within the time allowed, right or wrong, less pauses", kOwn, false,
       -1, [](const Score& s) { return s.dual_task ? s.dual_task->mean_reaction_s : Value(); }},
      {"dual_task_errors", "Errors in the dual task", "", "wrong answers, and answers to nothing", kOwn, false, -1,
       [](const Score& s) {
         return of_dual_task(s, [](const DualTask& d) { return static_cast<double>(d.errors()); });
       }},
      {"dual_task_missed", "Missed in the dual task", "", "questions and alarms without an answer in the time allowed",
       kOwn, false, -1,
       [](const Score& s) { return of_dual_task(s, [](const DualTask& d) { return static_cast<double>(d.missed); }); }},
  };
  return all;
}

const Figure* find_figure(const std::string& name) {
  const auto found =
      std::find_if(figures().begin(), figures().end(), [&name](const Figure& one) { return one.name == name; });
  return found == figures().end() ? nullptr : &*found;
}

}  // namespace vallecula::curricula
