// Which scenario is made for an infant as large as a patient: a scenario's weight decides on blade, tube and targets.
#pragma once

#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// Weight (kg) of the manikin that is as large as this patient, from upper gum to vallecula; lengths go with the
/// weight's cube root. A package holds no weight of its own.
double weight_as_large(const pipeline::PatientPackage& package);

/// A patient as large as an infant of this weight (kg) is no more than 15 % larger or smaller than the scenario's: then
/// misfits() has nothing to say of its size.
bool fits(const curricula::Scenario& scenario, double weight_kg);

/// Of a course, those that may be begun.
struct OpenScenarios {
  const curricula::Curriculum* course = nullptr;
  std::vector<std::string> ids;
};
struct FittingScenario {
  const curricula::Curriculum* course = nullptr;  ///< null: none is nearer than the one that was chosen
  const curricula::Scenario* scenario = nullptr;
};

/// Of what is open the scenario nearest in weight that asks for the same as `chosen`, a tube or none (null: for
/// either). Of the first course where one fits; where none fits in any, the nearest of the first course.
FittingScenario fitting_scenario(const std::vector<OpenScenarios>& courses, const curricula::Scenario* chosen,
                                 double weight_kg);

}  // namespace vallecula::gui
