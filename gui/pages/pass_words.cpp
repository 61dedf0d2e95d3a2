#include "gui/pages/pass_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {

QString passes_with(const curricula::Scenario& scenario) {
  QString text =
      QString(QCoreApplication::translate(
                  "PassWords",
                  "Passes with: at most %1 N on the tongue and %2 N on the gum, at least %3 % of the glottis seen, "
                  "within %4 s, at most %5 s above the training target of %6 N on the tongue and %7 s at the device's "
                  "force limit."))
          .arg(decimal(scenario.pass.peak_tongue_force_n, 1))
          .arg(decimal(scenario.pass.peak_gum_force_n, 1))
          .arg(scenario.pass.glottis_visible_percent, 0, 'f', 0)
          .arg(scenario.pass.attempt_time_s, 0, 'f', 0)
          .arg(decimal(scenario.pass.time_over_target_s, 1))
          .arg(decimal(scenario.targets.tongue_force_n, 1))
          .arg(decimal(scenario.pass.time_over_device_limit_s, 1));
  if (!scenario.intubation) return text;
  const curricula::IntubationPass& pass = scenario.intubation->pass;
  QStringList tube, outcomes;
  for (const curricula::Outcome outcome : pass.outcomes) outcomes << in_words(words_of(outcome));
  tube << QCoreApplication::translate("PassWords", "outcome: %1")
              .arg(outcomes.join(QCoreApplication::translate("PassWords", " or ")));
  if (pass.attempts) tube << QCoreApplication::translate("PassWords", "at most %1 attempts").arg(*pass.attempts);
  if (pass.time_to_pass_s)
    tube << QCoreApplication::translate("PassWords", "at most %1 s from the view to the cords passed")
                .arg(*pass.time_to_pass_s);
  if (pass.lowest_spo2_percent)
    tube << QCoreApplication::translate("PassWords", "SpO2 not below %1 %").arg(*pass.lowest_spo2_percent);
  if (pass.lowest_heart_per_min)
    tube << QCoreApplication::translate("PassWords", "heart rate not below %1").arg(*pass.lowest_heart_per_min);
  if (pass.tube_force_n)
    tube << QCoreApplication::translate("PassWords", "at most %1 N along the tube").arg(*pass.tube_force_n);
  if (pass.co2_confirmed) tube << QCoreApplication::translate("PassWords", "the place confirmed by CO2");
  if (pass.depth_neutral) tube << QCoreApplication::translate("PassWords", "good depth with the head neutral, too");
  if (pass.oesophagus_in_time)
    tube << QCoreApplication::translate("PassWords", "a tube in the oesophagus recognised within %1 breaths")
                .arg(scenario.intubation->breaths_to_confirm);
  if (pass.no_severe_desaturation)
    tube << QCoreApplication::translate("PassWords", "no fall of saturation by 20 points in an attempt");
  return text + ' ' + QCoreApplication::translate("PassWords", "The tube: %1.").arg(tube.join(", "));
}

}  // namespace vallecula::gui
