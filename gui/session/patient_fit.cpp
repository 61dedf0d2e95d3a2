#include "gui/session/patient_fit.h"

#include <cmath>
#include <cstdio>

#include "gui/session/airway_course.h"
#include "gui/session/anatomy_motion.h"
#include "gui/session/play_check.h"

namespace vallecula::gui {
namespace {

constexpr double kTermWeight_kg = 3.2;  ///< of the manikin whose size is 1
constexpr double kOtherSize = 0.15;     ///< a difference that targets made for one size do not bear

/// How many times as large as another infant one of this weight is: lengths go with the weight's cube root.
double times_as_large(double weight_kg, double other_kg) { return std::cbrt(weight_kg / other_kg); }

}  // namespace

double weight_as_large(const pipeline::PatientPackage& package) {
  return kTermWeight_kg * std::pow(size_of(package), 3.0);
}

bool fits(const curricula::Scenario& scenario, double weight_kg) {
  return std::abs(times_as_large(weight_kg, scenario.manikin.weight_kg) - 1.0) <= kOtherSize;
}

std::vector<std::string> misfits(const pipeline::PatientPackage& package, const curricula::Scenario& scenario) {
  std::vector<std::string> said;
  const double weight_kg = weight_as_large(package);
  if (!fits(scenario, weight_kg)) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "this patient is %.1f times as large as the scenario's infant (upper gum to vallecula): the "
                  "scenario's targets do not fit",
                  times_as_large(weight_kg, scenario.manikin.weight_kg));
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
