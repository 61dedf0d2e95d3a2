#include "gui/session/patient_fit.h"

#include <cmath>
#include <cstdio>

#include "gui/session/airway_course.h"
#include "gui/session/anatomy_motion.h"
#include "gui/session/play_check.h"

namespace vallecula::gui {
namespace {

constexpr double kTermWeight_kg = 3.2;  ///< of the manikin whose size is 1; lengths go with the weight's cube root
constexpr double kOtherSize = 0.15;     ///< a difference that targets made for one size do not bear

}  // namespace

std::vector<std::string> misfits(const pipeline::PatientPackage& package, const curricula::Scenario& scenario) {
  std::vector<std::string> said;
  const double times = size_of(package) / std::cbrt(scenario.manikin.weight_kg / kTermWeight_kg);
  if (std::abs(times - 1.0) > kOtherSize) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "this patient is %.1f times as large as the scenario's infant (upper gum to vallecula): the "
                  "scenario's targets do not fit",
                  times);
    said.emplace_back(text);
  }
  for (const auto& item : package.quality)  // as check_by_playing() names it
    if (item.name == "glottis in sight when lifted" && item.value && *item.value < 100.0 * kSeenEnough)
      said.emplace_back(
          "this patient's import could not bring the glottis into sight, and a trial may not either: see its quality "
          "report");
  if (scenario.intubation)
    for (const std::string& what : airway_of(package).assumed) said.push_back(what);
  return said;
}

}  // namespace vallecula::gui
