#include "gui/report/advice.h"

#include <QCoreApplication>

namespace vallecula::gui {
namespace {

/// Of the infant's heart and saturation; empty: they stayed within their limits.
std::string infant_advice(const curricula::IntubationScore& tube, const curricula::IntubationPass& pass) {
  if (pass.lowest_heart_per_min && tube.lowest_heart_per_min && *tube.lowest_heart_per_min < *pass.lowest_heart_per_min)
    return QCoreApplication::translate("Advice",
                                       "Stop the attempt earlier: the heart slowed down. Blade and tube out, ventilate "
                                       "until it is above 100, then "
                                       "again.")
        .toStdString();
  if (pass.lowest_spo2_percent && tube.lowest_spo2_percent && *tube.lowest_spo2_percent < *pass.lowest_spo2_percent)
    return QCoreApplication::translate(
               "Advice",
               "Give breaths until the saturation is back before each attempt: the display is late, and it goes on "
               "falling.")
        .toStdString();
  return "";
}

/// Of an intubation, the infant first; empty: the laryngoscopy is what to look at. `timed`: its times are judged;
/// `seen`: the glottis came into sight.
std::string tube_advice(const curricula::IntubationScore& tube, const curricula::IntubationPass& pass, bool timed,
                        bool seen) {
  using curricula::Outcome;
  if (tube.recognised_late)
    return QCoreApplication::translate("Advice",
                                       "Draw the tube as soon as six breaths bring no colour and no faster heart: it "
                                       "was in the oesophagus, and "
                                       "that must be known early.")
        .toStdString();
  switch (tube.outcome) {
    case Outcome::oesophagus:
      return QCoreApplication::translate("Advice",
                                         "Watch the tip pass between the cords, and give breaths until the detector "
                                         "tells: the tube went behind "
                                         "the larynx.")
          .toStdString();
    case Outcome::mainstem:
      return QCoreApplication::translate(
                 "Advice", "Stop when the black mark stands at the cords: deeper, the tube goes into one lung.")
          .toStdString();
    case Outcome::too_deep:
      return QCoreApplication::translate(
                 "Advice",
                 "Draw the tube back until the black mark stands at the cords, and keep the mark at the lips in mind.")
          .toStdString();
    case Outcome::too_shallow:
      return QCoreApplication::translate(
                 "Advice",
                 "Bring the tube on until the black mark stands at the cords: a shallow tube slips out when the head "
                 "moves.")
          .toStdString();
    case Outcome::cricoid_too_narrow:
      return QCoreApplication::translate(
                 "Advice", "Take a smaller tube: what does not pass the cricoid with a gentle turn must not be pushed.")
          .toStdString();
    case Outcome::cords_closed:
      return QCoreApplication::translate(
                 "Advice",
                 "Wait before closed cords until they open with a breath; closed for long, take the blade out and "
                 "ventilate.")
          .toStdString();
    case Outcome::abandoned:
    case Outcome::out_of_time:
      if (const std::string of_infant = infant_advice(tube, pass); !of_infant.empty()) return of_infant;
      if (seen)
        return QCoreApplication::translate(
                   "Advice",
                   "The glottis was in sight: take the tube at once then, keep looking at the cords, and bring its tip "
                   "through them.")
            .toStdString();
      return QCoreApplication::translate(
                 "Advice",
                 "See the glottis first, then take the tube in beside the blade without losing sight of the cords.")
          .toStdString();
    case Outcome::good_depth:
      break;
  }
  if (const std::string of_infant = infant_advice(tube, pass); !of_infant.empty()) return of_infant;
  if (pass.co2_confirmed && !tube.co2_confirmed)
    return QCoreApplication::translate(
               "Advice",
               "Confirm the tube's place: give five or six breaths through it and watch the detector before you end.")
        .toStdString();
  if (pass.tube_force_n && tube.tip_load_n.value > *pass.tube_force_n)
    return QCoreApplication::translate(
               "Advice",
               "Turn or draw back where the tube meets resistance; pushing swells the airway it has to go through.")
        .toStdString();
  if (pass.attempts && static_cast<int>(tube.attempts.size()) > *pass.attempts)
    return QCoreApplication::translate("Advice",
                                       "Prepare more before the blade goes in: tube at hand, throat clear, infant "
                                       "ventilated. Each attempt costs "
                                       "the infant.")
        .toStdString();
  const curricula::Attempt* decisive = tube.decisive();
  if (timed && pass.time_to_pass_s && decisive != nullptr && decisive->time_to_pass_s &&
      *decisive->time_to_pass_s > *pass.time_to_pass_s)
    return QCoreApplication::translate("Advice",
                                       "Have the tube at the corner of the mouth when the glottis comes into sight: "
                                       "the way from there took too "
                                       "long.")
        .toStdString();
  return "";
}

}  // namespace

std::string what_to_change(const curricula::Score& score, const curricula::Scenario& scenario) {
  const auto& pass = scenario.pass;
  const auto& targets = scenario.targets;
  if (!score.attempt_begun && !score.mouth_unknown)
    return QCoreApplication::translate(
               "Advice",
               "The blade never entered the mouth: bring its tip in at the right corner, then follow the tongue down.")
        .toStdString();
  if (score.intubation && scenario.intubation) {
    const std::string tube = tube_advice(*score.intubation, scenario.intubation->pass, !score.at_vallecula,
                                         score.time_of_first_sight_s >= 0.0);
    if (!tube.empty()) return tube;
  }
  if (score.peak_gum_force_n > pass.peak_gum_force_n)
    return QCoreApplication::translate("Advice",
                                       "Lift the whole blade along its handle, to the ceiling and the feet, clear of "
                                       "both gums: turning it about a "
                                       "gum presses there and opens no view.")
        .toStdString();
  if (score.time_over_force_limit_s > pass.time_over_device_limit_s)
    return QCoreApplication::translate(
               "Advice",
               "Stop pressing when the grey blade parts from the steel one: the device is at its limit, and more hand "
               "gives no more "
               "view.")
        .toStdString();
  if (score.peak_tongue_force_n > pass.peak_tongue_force_n)
    return QCoreApplication::translate("Advice",
                                       "Place the tip deeper in the vallecula before you lift: from there the same "
                                       "view takes less force on the "
                                       "tongue.")
        .toStdString();
  if (score.glottis_visible_max_percent < pass.glottis_visible_percent)
    return score.glottis_visible_max_percent <= 0.0
               ? QCoreApplication::translate(
                     "Advice",
                     "Follow the tongue down to the vallecula before you lift: short of it the lift does not carry the "
                     "epiglottis "
                     "away.")
                     .toStdString()
               : QCoreApplication::translate(
                     "Advice",
                     "Keep lifting along the handle for a little longer: the view opens from the arytenoids forward.")
                     .toStdString();
  if (score.time_over_target_s > pass.time_over_target_s)
    return QCoreApplication::translate("Advice",
                                       "Lower the lift a little once the glottis is in sight: holding the tongue above "
                                       "its target adds force, not "
                                       "view.")
        .toStdString();
  if (score.attempt_time_s > pass.attempt_time_s && !score.at_vallecula)
    return QCoreApplication::translate(
               "Advice",
               "End the attempt at %1 seconds, whatever is to be seen: take the blade out, ventilate, and begin again.")
        .arg(QString::fromStdString(std::to_string(static_cast<int>(pass.attempt_time_s))))
        .toStdString();
  if (!score.passed)
    return QCoreApplication::translate("Advice", "Look at the reasons below and change one of them at a time.")
        .toStdString();
  // Passed: the figure that used most of its room.
  const double tongue = pass.peak_tongue_force_n > 0.0 ? score.peak_tongue_force_n / pass.peak_tongue_force_n : 0.0;
  const double gum = pass.peak_gum_force_n > 0.0 ? score.peak_gum_force_n / pass.peak_gum_force_n : 0.0;
  const double time =
      pass.attempt_time_s > 0.0 && !score.at_vallecula ? score.attempt_time_s / pass.attempt_time_s : 0.0;
  if (gum >= tongue && gum >= time && score.peak_gum_force_n > 0.5 * targets.gum_force_n)
    return QCoreApplication::translate("Advice",
                                       "Well done. Next time keep the blade clear of the gums from beginning to end.")
        .toStdString();
  if (tongue >= time)
    return QCoreApplication::translate("Advice", "Well done. Next time try for the same view with a gentler lift.")
        .toStdString();
  if (score.mouth_entries > 1)
    return QCoreApplication::translate(
               "Advice", "Well done. Next time go more smoothly, in one motion: the blade went in %1 times.")
        .arg(score.mouth_entries)
        .toStdString();
  return QCoreApplication::translate("Advice", "Well done. Do it the same way again.").toStdString();
}

}  // namespace vallecula::gui
