// Which scenario is made for an infant as large as a patient: a scenario's weight decides on blade, tube and targets.
#pragma once

#include <string>
#include <vector>

#include "curricula/scenario.h"

namespace vallecula::gui {

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
