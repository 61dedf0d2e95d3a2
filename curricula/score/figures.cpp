#include "curricula/score/figures.h"

#include <algorithm>

namespace vallecula::curricula {
namespace {

using Value = std::optional<double>;
constexpr const char* kNear4Neos = "NEAR4NEOS";
constexpr const char* kOwn = "own";

Value from_zero(double value) { return value >= 0.0 ? Value(value) : std::nullopt; }

/// Of a trial with an intubation; else nothing.
template <class Get>
Value of_intubation(const Score& score, Get get) {
  return score.intubation ? Value(get(*score.intubation)) : std::nullopt;
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      {"passed", "Passed", "", "every limit of the scenario was kept", kOwn, false, 1,
       [](const Score& s) { return Value(s.passed ? 1.0 : 0.0); }},
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
  };
  return all;
}

const Figure* find_figure(const std::string& name) {
  const auto found =
      std::find_if(figures().begin(), figures().end(), [&name](const Figure& one) { return one.name == name; });
  return found == figures().end() ? nullptr : &*found;
}

}  // namespace vallecula::curricula
