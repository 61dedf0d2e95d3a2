#include "gui/pages/module_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

constexpr int kAnyNumber = 20;  // the most that a rule may allow says nothing

QString within(int attempts) {
  if (attempts >= kAnyNumber) return {};
  return attempts == 1 ? QCoreApplication::translate("ModuleWords", " at the first attempt")
                       : QCoreApplication::translate("ModuleWords", " within %1 attempts").arg(attempts);
}

}  // namespace

QString state_of(const curricula::ModuleProgress& progress) {
  return progress.mastered ? QCoreApplication::translate("ModuleWords", "mastered")
         : progress.open   ? QCoreApplication::translate("ModuleWords", "open")
                           : QCoreApplication::translate("ModuleWords", "closed");
}

QString progress_line(const curricula::Module& module, const curricula::ModuleProgress& progress) {
  QString line = QCoreApplication::translate("ModuleWords", "no trial yet");
  if (progress.trials > 0)
    line = QCoreApplication::translate("ModuleWords", "%1 of %2 trials passed%3")
               .arg(progress.succeeded)
               .arg(progress.trials)
               .arg(within(module.mastery.attempts));
  line += QCoreApplication::translate("ModuleWords", ", %1 of %2 scenarios done")
              .arg(progress.scenarios_done)
              .arg(module.scenarios.size());
  if (module.mastery.by_cusum)
    line += QCoreApplication::translate("ModuleWords", ", cumulative sum %1 (mastered at %2)")
                .arg(decimal(progress.cusum.empty() ? 0.0 : progress.cusum.back().sum, 1))
                .arg(decimal(curricula::cusum_lines(module.mastery.cusum).lower, 1));
  return line;
}

QString mastery_rule(const curricula::Module& module) {
  const curricula::MasteryRule& rule = module.mastery;
  QString text =
      rule.by_cusum ? QString(QCoreApplication::translate(
                                  "ModuleWords",
                                  "Mastered when the cumulative sum (CUSUM) over all its trials reaches %1 and each "
                                  "scenario has been passed"))
                          .arg(decimal(curricula::cusum_lines(rule.cusum).lower, 1))
      : rule.passes == 1
          ? QCoreApplication::translate("ModuleWords", "Mastered when each scenario has been passed")
          : QCoreApplication::translate("ModuleWords", "Mastered when each scenario has been passed %1 times running")
                .arg(rule.passes);
  text += within(rule.attempts);
  text +=
      rule.assessments_only ? QCoreApplication::translate("ModuleWords", "; only assessments count. ") : QString(". ");
  return text + QCoreApplication::translate("ModuleWords", "Source: %1. Not validated.").arg(course_words(rule.source));
}

QString why_closed(const curricula::Curriculum& curriculum, const std::vector<curricula::ModuleProgress>& progress,
                   const std::string& scenario_id) {
  QStringList missing;
  const auto ask_for = [&](const std::vector<std::string>& after) {
    for (const std::string& id : after)
      for (std::size_t m = 0; m < curriculum.modules.size(); ++m) {
        const QString title = course_words(curriculum.modules[m].title);
        if (curriculum.modules[m].id == id && !progress[m].mastered && !missing.contains(title)) missing << title;
      }
  };
  if (const curricula::Module* module = curriculum.module_of(scenario_id)) ask_for(module->after);
  if (const curricula::Scenario* scenario = curriculum.find(scenario_id)) ask_for(scenario->after);
  return missing.isEmpty() ? QString()
                           : QCoreApplication::translate("ModuleWords", "Opens after %1 is mastered.")
                                 .arg(missing.join(QCoreApplication::translate("ModuleWords", " and ")));
}

}  // namespace vallecula::gui
