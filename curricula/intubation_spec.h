// The second half of the procedure as a scenario asks for it: the tube, the infant around it, and what passes.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vallecula::curricula {

/// Where the infant's saturation and heart begin. Only the first is calibrated to a published course.
enum class InfantCourse { premedicated_preterm, term, preoxygenated, delivery_room };

/// What became of the tube, by where its tip really is at the end (see score_trial).
enum class Outcome {
  good_depth,   ///< tip in the middle third of this infant's way from the cords to the carina
  too_shallow,  ///< in the trachea, to adjust
  too_deep,     ///< likewise
  mainstem,     ///< in one main bronchus; which: LogIntubation::side
  oesophagus,
  cricoid_too_narrow,  ///< the tube was stopped by the cricoid and never came past it
  cords_closed,        ///< the tube was stopped by closed cords, or laryngospasm ended the attempt
  abandoned,
  out_of_time,
};
constexpr int kOutcomes = 9;

/// The word in curricula, score.json and the records, "good-depth".
const char* name_of(Outcome outcome);
std::string words_of(Outcome outcome);  ///< for a person: "good depth" of "good-depth"
/// The outcome of that name; nothing for another word.
std::optional<Outcome> outcome_named(const std::string& name);

/// Thresholds of the rubric. What is not given is measured but not judged.
struct IntubationPass {
  std::vector<Outcome> outcomes{Outcome::good_depth};  ///< accepted
  std::optional<double> lowest_spo2_percent;           ///< displayed; must not be undercut from the first attempt on
  std::optional<double> lowest_heart_per_min;          ///< likewise
  std::optional<double> tube_force_n;                  ///< along the tube, of what stands before its tip
  std::optional<double> time_to_pass_s;                ///< from the view to the cords passed
  std::optional<int> attempts;
  bool co2_confirmed = false;           ///< within breaths_to_confirm
  bool depth_neutral = false;           ///< a tube in the trachea lies in the middle third with the head neutral, too
  bool oesophagus_in_time = false;      ///< never more than breaths_to_confirm breaths in one stay there, nor there at the end
  bool no_severe_desaturation = false;  ///< in no attempt a fall by 20 points or more
};

struct IntubationSpec {
  std::string tube;  ///< inner diameter in mm: "2.5", "3.0", "3.5", "4.0"
  std::vector<std::string> offered_tubes;  ///< to choose from; none: no choice
  bool stylet = false;
  double stylet_mm = 1.2;  ///< diameter of its metal
  int catheter_f = 8;      ///< suction catheter, French (a third of a millimetre); 0: none at hand
  InfantCourse course = InfantCourse::term;
  double gestation_weeks = 40.0;
  unsigned infant_seed = 0;            ///< one infant of the population; 0: its median
  double added_oxygen_percent = 10.0;  ///< to the gas it had before, in breaths given
  bool premedicated = false;           ///< atropine and a muscle relaxant
  bool breathes = true;                ///< by itself, all through the trial; the cords open with it
  double laryngospasm_s = 0.0;         ///< after a touch; 0: none
  bool laryngospasm_from_start = false;
  double cord_closure_s = 1.0;  ///< median time the cords stay closed after a touch
  double secretions_ml = 0.0;
  double laryngeal_pressure_n = 3.0;  ///< of the assistant, on request; 0: there is none
  int breaths_to_confirm = 6;         ///< a detector without colour after these says: not in the trachea
  IntubationPass pass;
};

}  // namespace vallecula::curricula
