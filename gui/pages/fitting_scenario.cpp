#include "gui/pages/fitting_scenario.h"

#include <cmath>

#include "gui/session/patient_fit.h"

namespace vallecula::gui {
namespace {

/// How far apart two weights are; the same for twice and for half.
double apart(double one_kg, double other_kg) { return std::abs(std::log(one_kg / other_kg)); }

}  // namespace

FittingScenario fitting_scenario(const std::vector<OpenScenarios>& courses, const curricula::Scenario* chosen,
                                 double weight_kg) {
  FittingScenario first;
  for (const OpenScenarios& open : courses) {
    FittingScenario best;
    for (const std::string& id : open.ids) {
      const curricula::Scenario* one = open.course->find(id);
      if (one == nullptr || (chosen != nullptr && one->intubation.has_value() != chosen->intubation.has_value()))
        continue;
      const curricula::Scenario* nearest = best.scenario != nullptr ? best.scenario : chosen;
      if (nearest == nullptr || apart(one->manikin.weight_kg, weight_kg) < apart(nearest->manikin.weight_kg, weight_kg))
        best = {open.course, one};
    }
    if (best.scenario != nullptr && fits(*best.scenario, weight_kg)) return best;
    if (&open == &courses.front()) first = best;
  }
  return first;
}

}  // namespace vallecula::gui
