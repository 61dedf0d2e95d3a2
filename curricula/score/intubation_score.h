// The figures of an intubation: part of a trial's score where the trial had one.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "curricula/intubation_spec.h"
#include "curricula/score/peak.h"
#include "curricula/trial_log.h"

namespace vallecula::curricula {

constexpr double kSevereDesaturation = 20.0;  ///< percentage points (NEAR4NEOS)
constexpr double kBradycardia = 100.0;        ///< heart below, per minute (NEAR4NEOS)

/// Percent. What no published curve of a newborn's SpO2 goes below: 29 % is the 3rd percentile a minute after birth
/// (Dawson 2010). Makers state an oximeter's accuracy from 70 to 100 % only; its digits go on below that. What the
/// model has below this is no figure for a person; files and exports keep it.
constexpr double kLeastToldSpo2 = 30.0;
/// "87"; "below 30" of less.
std::string told_spo2(double percent);

/// One way of the blade into the mouth and out of it (NEAR4NEOS). Moments in trial time; times less pauses.
struct Attempt {
  double start_s = 0.0, end_s = 0.0;
  double time_s = 0.0, paused_s = 0.0;
  int breaths_before = 0;                ///< given since the attempt before, or since the trial began
  std::optional<double> time_to_view_s;  ///< from its start to scenario.sight_percent of the glottis; never: nothing
  std::optional<double> view_at_s;       ///< second of the trial of that
  /// From the view (from the start where there was none before) to the last time the tip passed the cords in it, or,
  /// the blade out, before the next one.
  std::optional<double> time_to_pass_s;
  std::optional<double> passed_cords_s;  ///< second of the trial of that
  /// Displayed saturation, percent: the highest since the attempt before (or the trial's begin), and the lowest from
  /// its start to the next one's, or to the end: the display is late, so what falls after the blade is out is its
  /// doing.
  double highest_spo2_before_percent = 0.0, lowest_spo2_percent = 0.0;
  double lowest_heart_per_min = 0.0;  ///< over the same time
  bool desaturated = false;           ///< by kSevereDesaturation or more
  bool bradycardia = false;           ///< heart below kBradycardia
};

struct IntubationScore {
  Outcome outcome = Outcome::abandoned;
  std::vector<Attempt> attempts;
  double cords_to_carina_m = 0.0;         ///< this infant's
  std::optional<double> depth_m;          ///< of the tip past the cords at the end, where it lies in larynx or trachea
  std::optional<double> depth_neutral_m;  ///< the same with the head neutral, where its extension is known
  std::optional<double> at_lips_m;        ///< the tube's mark at the upper lip at the end, where it is in the mouth
  double lips_rule_m = 0.0;               ///< what that would be by the rule: the infant's weight in kg and 6 cm
  std::int8_t bronchus_side = -1;         ///< where the tip lies in a main bronchus at the end: 0 right, 1 left
  double deepest_m = 0.0;                 ///< past the cords, ever
  std::optional<double> lowest_spo2_percent, lowest_heart_per_min;  ///< from the first attempt on
  double lowest_spo2_at_s = -1.0, lowest_heart_at_s = -1.0;
  std::optional<double> first_spo2_percent, first_heart_per_min;  ///< as the first attempt began
  int breaths_given = 0;                                          ///< in the whole trial, by mask and tube
  bool co2_confirmed = false;      ///< the detector turned yellow while the tube lay where it lies at the end
  std::optional<int> co2_breaths;  ///< breaths through it until then
  int breaths_in_place = 0;        ///< breaths through it altogether
  int oesophagus_entries = 0;      ///< times the tube's tip went in
  int oesophagus_breaths = 0;      ///< given while it lay there
  double oesophagus_s = 0.0;       ///< from the first of them in each stay until withdrawn, together
  /// The tube that lay in the oesophagus was drawn in time: it lies there no more, and no stay was too long.
  bool oesophagus_in_time() const { return !recognised_late && outcome != Outcome::oesophagus; }
  bool recognised_late = false;                   ///< more than breaths_to_confirm in one stay
  double recognised_late_at_s = -1.0;             ///< second of the trial of the first breath too many
  Peak tip_load_n;                                ///< along the tube, of what stood before its tip
  std::uint8_t tip_against = kNothingAgainstTip;  ///< what that was, a LoggedTubeLoad
  std::array<Peak, kTubeLoads> loads_n{};         ///< by what the tube touched, sums of magnitudes
  Peak hand_force_n;                              ///< model force on the hand that holds the tube
  Peak displayed_hand_force_n;
  double buckled_m = 0.0;  ///< at most
  double secretions_start_ml = 0.0, secretions_end_ml = 0.0;

  /// The last attempt in which the cords were passed, else the last one; null: there was none.
  const Attempt* decisive() const;
  const Attempt* longest() const;  ///< null: there was none
  /// Depth as a share of the way from the cords to the carina.
  std::optional<double> depth_share() const;
  std::optional<double> depth_neutral_share() const;  ///< the same with the head neutral
  std::optional<double> depth_error_m() const;        ///< from the middle of the good third; positive: too deep
  /// The cords were passed, but before the blade was first in the mouth: no attempt has a time of it.
  bool passed_untimed() const;
};

/// The outcome for a person, with the depth: "The tube's tip lies 24.1 mm past the cords, ...". Without a full stop.
std::string outcome_in_words(const IntubationScore& score);
/// Of a depth as a share of the way from the cords to the carina: good; its ends belong to it.
inline bool in_middle_third(double share) noexcept { return share >= 1.0 / 3.0 && share <= 2.0 / 3.0; }
/// Of a tube in a main bronchus: "the right main bronchus".
std::string bronchus_in_words(const IntubationScore& score);
/// The tube's mark at the upper lip by the rule: the weight in kg and 6 cm.
double lips_rule_m(double weight_kg);
/// "cricoid", "tongue" ...: what a tube's load is on.
const char* name_of(LoggedTubeLoad load);

}  // namespace vallecula::curricula
