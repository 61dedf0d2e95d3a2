// From YAML to one scenario, and the rules about it that no schema can say (private to the library).
#pragma once

#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/schema/validator.h"

namespace vallecula::curricula {

/// `node` has passed the schema and names its blade and tube; `path` stands before every field's name, "scenarios[0].".
/// Throws CurriculumError where fields contradict each other. `yaml` is left empty.
Scenario read_scenario(const YAML::Node& node, const Validator& rules, const std::string& path);

/// The pass marks this scenario judges by, as their fields are named in `pass` and `intubation.pass`.
std::vector<std::string> marks_of(const YAML::Node& scenario);

}  // namespace vallecula::curricula
