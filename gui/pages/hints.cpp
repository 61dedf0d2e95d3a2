#include "gui/pages/hints.h"

#include <QCoreApplication>

#include "gui/views/monitor_panel.h"

namespace vallecula::gui {
namespace {

constexpr double kHidesMl = 0.3;      // that one would suck out first
constexpr double kResistanceN = 0.5;  // along the tube, at its tip
constexpr double kClosed = 0.15;      // of the cords' opening
constexpr int kBreathsToTell = 6;     // CLINICAL: the detector changes within 5 or 6

/// Out of sight below the cords or behind the larynx a person knows only that the tube went in.
bool passed(const engine::IntubationRecord& now) {
  using engine::TipPlace;
  return now.place == TipPlace::trachea || now.place == TipPlace::main_bronchus || now.place == TipPlace::oesophagus;
}

}  // namespace

QString key_to_the_tube(bool takes_turns, Tool in_hand) {
  return takes_turns && in_hand != Tool::tube ? QString("X") : QString();
}

QString need_of(const engine::Snapshot& snapshot, bool blade_in) {
  const engine::IntubationRecord& now = snapshot.intubation;
  const bool something_in = blade_in || now.place != engine::TipPlace::outside;
  if (now.heart_per_min < kCompressions)
    return QCoreApplication::translate(
        "Hints",
        "Heart rate below 60. Stop the attempt: blade and tube out, ventilate by mask (hold B); in life, "
        "compressions.");
  if (now.heart_per_min >= kSlowHeart && now.spo2 >= kLowSpo2) return {};
  if (passed(now) && now.detector_yellow) return {};  // it is being ventilated
  if (something_in)
    return QCoreApplication::translate(
        "Hints",
        "Stop this attempt: blade and tube out, then hold B to ventilate until the heart rate is above 100 and "
        "SpO2 is back.");
  return QCoreApplication::translate(
      "Hints", "Hold B to ventilate by mask until the heart rate is above 100 and SpO2 is back. SpO2 lags behind.");
}

Banner need_before(const engine::Snapshot& snapshot, const QString& need, const QString& alert) {
  const QString hand = snapshot.state == engine::HapticState::lost
                           ? ' ' + QCoreApplication::translate("Hints", "Bring the grey blade back to the steel one.")
                           : QString();
  return {need + hand, !alert.isEmpty() || snapshot.intubation.heart_per_min < kCompressions};
}

QString levering_words(double gum_n, double target_n) {
  if (!(gum_n > target_n)) return {};
  return QCoreApplication::translate("Hints",
                                     "The blade presses on the upper gum: lift along its handle, do not tip it back.");
}

QString hint_for(const engine::Snapshot& snapshot, double sight_percent, bool blade_in, const QString& other_hand) {
  using engine::InHand;
  using engine::TipPlace;
  const engine::IntubationRecord& now = snapshot.intubation;
  if (const QString need = need_of(snapshot, blade_in); !need.isEmpty()) return need;
  if (now.in_hand == InHand::catheter)
    return QCoreApplication::translate(
        "Hints",
        "Suction catheter: its tip into the secretions, then hold V. Out of the mouth, C gives the tube back.");
  if (passed(now)) {
    if (now.detector_yellow)
      return QCoreApplication::translate(
          "Hints",
          "The detector is yellow: the tube is in the airway. Bring its tip to good depth and take the blade out; "
          "then End.");
    if (now.breaths_given >= kBreathsToTell && now.given_per_min > 0.0)
      return QCoreApplication::translate(
          "Hints",
          "No CO2 after these breaths: unless the heart rate rises, the tube is in the wrong place. Out, ventilate "
          "by mask, again.");
    if (now.in_hand == InHand::tube_with_stylet)
      return QCoreApplication::translate(
          "Hints",
          "Its tip is out of sight. Between the cords? Then T draws the stylet, and the cord mark goes to the cords.");
    return QCoreApplication::translate(
        "Hints", "Cord mark at the cords? Hold B for 5 or 6 breaths; watch the heart rate and the CO2 detector.");
  }
  if (now.place == TipPlace::larynx || (now.place == TipPlace::mouth && now.tip_load_n > kResistanceN)) {
    if (now.spasm)
      return QCoreApplication::translate(
          "Hints", "The cords stay shut: laryngospasm. Draw back, ventilate by mask (B) and wait; never push.");
    if (now.glottis_opening < kClosed)
      return QCoreApplication::translate("Hints", "The cords are closed. Wait for them to open; never push.");
    if (now.tip_load_n > kResistanceN)
      return QCoreApplication::translate("Hints",
                                         "Resistance. Draw back a little, turn the tube, try again; never push.");
    return QCoreApplication::translate(
        "Hints", "Tip before the cords: on, between them, and keep them in sight until the mark has passed.");
  }
  if (now.place == TipPlace::mouth)
    return QCoreApplication::translate(
        "Hints",
        "Tube along the right side of the mouth, beside the blade, not down its channel; keep the cords in sight.");
  if (now.secretions_ml > kHidesMl)
    return QCoreApplication::translate(
        "Hints", "Secretions hide the throat: C takes the suction catheter, V held draws them off.");
  if (100.0 * snapshot.glottis_visible >= sight_percent)
    return other_hand.isEmpty()
               ? QCoreApplication::translate(
                     "Hints",
                     "Glottis in sight. The tube in at the right corner of the mouth. L held: pressure on the larynx.")
               : QCoreApplication::translate("Hints",
                                             "Glottis in sight. %1 takes the tube: in at the right corner of the "
                                             "mouth. L held: pressure on the larynx.")
                     .arg(other_hand);
  if (blade_in)
    return QCoreApplication::translate(
        "Hints",
        "Tongue to the left, tip into the vallecula, then lift along the handle; do not lever. L held: pressure on "
        "the larynx.");
  return QCoreApplication::translate(
      "Hints",
      "Ventilated? Blade in at the right corner of the mouth. An attempt lasts 30 s at most; B held gives breaths "
      "between attempts.");
}

}  // namespace vallecula::gui
