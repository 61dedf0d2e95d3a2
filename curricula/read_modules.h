// From YAML to a curriculum's modules, and the rules about them that no schema can say (private to the library).
#pragma once

#include <vector>

#include "curricula/scenario.h"
#include "curricula/schema/validator.h"

namespace vallecula::curricula {

/// `document` has passed the schema; `scenarios` are those read from it. Throws CurriculumError for a scenario that
/// belongs to no module or to two, for names that are none, for modules that wait for each other.
std::vector<Module> read_modules(const YAML::Node& document, const std::vector<Scenario>& scenarios,
                                 const Validator& rules);

}  // namespace vallecula::curricula
