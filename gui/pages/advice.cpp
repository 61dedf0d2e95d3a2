#include "gui/pages/advice.h"

namespace vallecula::gui {

std::string what_to_change(const curricula::Score& score, const curricula::Scenario& scenario) {
  const auto& pass = scenario.pass;
  const auto& targets = scenario.targets;
  if (!score.attempt_begun)
    return "The blade never entered the mouth: bring its tip in at the right corner, then follow the tongue down.";
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
