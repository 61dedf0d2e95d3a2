#include "gui/records_pages/curve_reading.h"

#include <QCoreApplication>
#include <cstdio>
#include <map>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

using curricula::CusumVerdict;
using curricula::Scenario;

constexpr int kInARow = 3;

}  // namespace

std::optional<double> pass_limit(const Scenario& scenario, const std::string& figure) {
  const curricula::PassLimits& pass = scenario.pass;
  const std::map<std::string, double> of_all{{"peak_tongue_force_n", pass.peak_tongue_force_n},
                                             {"peak_gum_force_n", pass.peak_gum_force_n},
                                             {"glottis_visible_max_percent", pass.glottis_visible_percent},
                                             {"attempt_time_s", pass.attempt_time_s},
                                             {"time_over_target_s", pass.time_over_target_s},
                                             {"time_over_force_limit_s", pass.time_over_device_limit_s}};
  if (const auto found = of_all.find(figure); found != of_all.end()) return found->second;
  if (!scenario.intubation) return std::nullopt;
  const auto& tube = scenario.intubation->pass;
  if (figure == "time_to_pass_s") return tube.time_to_pass_s;
  if (figure == "lowest_spo2_percent") return tube.lowest_spo2_percent;
  if (figure == "lowest_heart_per_min") return tube.lowest_heart_per_min;
  if (figure == "attempts" && tube.attempts) return *tube.attempts;
  return std::nullopt;
}

std::optional<double> training_target(const Scenario& scenario, const std::string& figure) {
  if (figure == "peak_tongue_force_n") return scenario.targets.tongue_force_n;
  if (figure == "peak_gum_force_n") return scenario.targets.gum_force_n;
  return std::nullopt;
}

CurveReading read_curve(const std::vector<curricula::RecordRow>& rows, const curricula::Curriculum* curriculum) {
  CurveReading reading;
  const curricula::Module* module =
      curriculum != nullptr && !rows.empty() ? curriculum->module_of(rows.front().scenario_id) : nullptr;
  if (module != nullptr && module->mastery.by_cusum) {
    reading.rule = module->mastery.cusum;
    reading.attempts = module->mastery.attempts;
    reading.assessments_only = module->mastery.assessments_only;
    reading.rule_in_words =
        (reading.assessments_only
             ? QCoreApplication::translate(
                   "CurveReading",
                   "By the rule of the module \"%1\" (%2), on this scenario alone, and on assessments alone.")
             : QCoreApplication::translate("CurveReading",
                                           "By the rule of the module \"%1\" (%2), on this scenario alone."))
            .arg(course_words(module->title), course_words(module->mastery.source))
            .toStdString();
  } else {
    reading.rule_in_words =
        QCoreApplication::translate(
            "CurveReading",
            "By the published rule: 80 % success within two attempts (PMC8290971); unacceptable rate and risks are "
            "assumed.")
            .toStdString();
  }
  for (const curricula::RecordRow& row : rows) {
    if (!row.score.counts()) {
      ++(row.score.complete ? reading.set_aside : reading.interrupted);
      continue;
    }
    if (reading.assessments_only && row.mode != curricula::Mode::assessment) continue;
    const bool success = succeeded(row, reading);
    reading.successes.push_back(success);
    reading.in_a_row = success ? reading.in_a_row + 1 : 0;
  }
  reading.cusum = curricula::cusum(reading.rule, reading.successes);
  reading.to_three_in_a_row = curricula::trials_to_consecutive(reading.successes, kInARow);
  for (std::size_t i = 0; i < reading.cusum.size() && reading.to_competent < 0; ++i)
    if (reading.cusum[i].verdict == CusumVerdict::competent) reading.to_competent = static_cast<int>(i) + 1;
  return reading;
}

bool succeeded(const curricula::RecordRow& row, const CurveReading& reading) {
  return row.score.passed && row.attempts <= reading.attempts;
}

const char* name_of(CusumVerdict verdict) {
  switch (verdict) {
    case CusumVerdict::competent:
      return "competent";
    case CusumVerdict::deficient:
      return "not competent";
    case CusumVerdict::undecided:
      break;
  }
  return "undecided";
}

std::string verdict_in_words(const std::vector<curricula::CusumPoint>& cusum) {
  for (std::size_t i = cusum.size(); i-- > 0;)
    if (cusum[i].verdict != CusumVerdict::undecided)
      return QCoreApplication::translate("CurveReading", "%1 (trial %2)")
          .arg(in_words(name_of(cusum[i].verdict)))
          .arg(i + 1)
          .toStdString();
  return in_words(name_of(CusumVerdict::undecided)).toStdString();
}

}  // namespace vallecula::gui
