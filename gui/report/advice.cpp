#include "gui/report/advice.h"

namespace vallecula::gui {
namespace {

/// Of an intubation, the infant first; empty: the laryngoscopy is what to look at.
std::string tube_advice(const curricula::IntubationScore& tube, const curricula::IntubationPass& pass) {
  using curricula::Outcome;
  if (tube.recognised_late)
    return "Draw the tube as soon as six breaths bring no colour and no faster heart: it was in the oesophagus, and "
           "that must be known early.";
  switch (tube.outcome) {
    case Outcome::oesophagus:
      return "Watch the tip pass between the cords, and give breaths until the detector tells: the tube went behind "
             "the larynx.";
    case Outcome::mainstem:
      return "Stop when the black mark stands at the cords: deeper, the tube goes into one lung.";
    case Outcome::too_deep:
      return "Draw the tube back until the black mark stands at the cords, and keep the mark at the lips in mind.";
    case Outcome::too_shallow:
      return "Bring the tube on until the black mark stands at the cords: a shallow tube slips out when the head "
             "moves.";
    case Outcome::cricoid_too_narrow:
      return "Take a smaller tube: what does not pass the cricoid with a gentle turn must not be pushed.";
    case Outcome::cords_closed:
      return "Wait before closed cords until they open with a breath; closed for long, take the blade out and "
             "ventilate.";
    case Outcome::abandoned:
    case Outcome::out_of_time:
      return "See the glottis first, then take the tube in beside the blade without losing sight of the cords.";
    case Outcome::good_depth:
      break;
  }
  if (pass.lowest_heart_per_min && tube.lowest_heart_per_min && *tube.lowest_heart_per_min < *pass.lowest_heart_per_min)
    return "Stop the attempt earlier: the heart slowed down. Blade and tube out, ventilate until it is above 100, then "
           "again.";
  if (pass.lowest_spo2_percent && tube.lowest_spo2_percent && *tube.lowest_spo2_percent < *pass.lowest_spo2_percent)
    return "Give breaths until the saturation is back before each attempt: the display is late, and it goes on "
           "falling.";
  if (pass.co2_confirmed && !tube.co2_confirmed)
    return "Confirm the tube's place: give five or six breaths through it and watch the detector before you end.";
  if (pass.tube_force_n && tube.tip_load_n.value > *pass.tube_force_n)
    return "Turn or draw back where the tube meets resistance; pushing swells the airway it has to go through.";
  if (pass.attempts && static_cast<int>(tube.attempts.size()) > *pass.attempts)
    return "Prepare more before the blade goes in: tube at hand, throat clear, infant ventilated. Each attempt costs "
           "the infant.";
  const curricula::Attempt* decisive = tube.decisive();
  if (pass.time_to_pass_s && decisive != nullptr && decisive->time_to_pass_s &&
      *decisive->time_to_pass_s > *pass.time_to_pass_s)
    return "Have the tube at the corner of the mouth when the glottis comes into sight: the way from there took too "
           "long.";
  return "";
}

}  // namespace

std::string what_to_change(const curricula::Score& score, const curricula::Scenario& scenario) {
  const auto& pass = scenario.pass;
  const auto& targets = scenario.targets;
  if (!score.attempt_begun)
    return "The blade never entered the mouth: bring its tip in at the right corner, then follow the tongue down.";
  if (score.intubation && scenario.intubation)
    if (const std::string tube = tube_advice(*score.intubation, scenario.intubation->pass); !tube.empty()) return tube;
  if (score.peak_gum_force_n > pass.peak_gum_force_n)
    return "Lift the whole blade along its handle, to the ceiling and the feet, clear of both gums: turning it about a "
           "gum presses there and opens no view.";
  if (score.time_over_force_limit_s > pass.time_over_device_limit_s)
    return "Stop pressing when the grey blade parts from the steel one: the device is at its limit, and more hand "
           "gives no more "
           "view.";
  if (score.peak_tongue_force_n > pass.peak_tongue_force_n)
    return "Place the tip deeper in the vallecula before you lift: from there the same view takes less force on the "
           "tongue.";
  if (score.glottis_visible_max_percent < pass.glottis_visible_percent)
    return score.glottis_visible_max_percent <= 0.0
               ? "Follow the tongue down to the vallecula before you lift: short of it the lift does not carry the "
                 "epiglottis "
                 "away."
               : "Keep lifting along the handle for a little longer: the view opens from the arytenoids forward.";
  if (score.time_over_target_s > pass.time_over_target_s)
    return "Lower the lift a little once the glottis is in sight: holding the tongue above its target adds force, not "
           "view.";
  if (score.attempt_time_s > pass.attempt_time_s)
    return "End the attempt at " + std::to_string(static_cast<int>(pass.attempt_time_s)) +
           " seconds, whatever is to be seen: take the blade out, ventilate, and begin again.";
  if (!score.passed) return "Look at the reasons below and change one of them at a time.";
  // Passed: the figure that used most of its room.
  const double tongue = pass.peak_tongue_force_n > 0.0 ? score.peak_tongue_force_n / pass.peak_tongue_force_n : 0.0;
  const double gum = pass.peak_gum_force_n > 0.0 ? score.peak_gum_force_n / pass.peak_gum_force_n : 0.0;
  const double time = pass.attempt_time_s > 0.0 ? score.attempt_time_s / pass.attempt_time_s : 0.0;
  if (gum >= tongue && gum >= time && score.peak_gum_force_n > 0.5 * targets.gum_force_n)
    return "Well done. Next time keep the blade clear of the gums from beginning to end.";
  if (tongue >= time) return "Well done. Next time try for the same view with a gentler lift.";
  return "Well done. Next time go the same way with fewer pauses.";
}

}  // namespace vallecula::gui
