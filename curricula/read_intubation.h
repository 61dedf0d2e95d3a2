// From YAML to IntubationSpec (private to the library).
#pragma once

#include <string>

#include "curricula/intubation_spec.h"
#include "curricula/schema/validator.h"

namespace vallecula::curricula {

/// `node` has passed the schema and names its tube; `path` stands before every field's name, "intubation.". Throws
/// CurriculumError where fields contradict each other.
IntubationSpec read_intubation(const YAML::Node& node, const Validator& rules, const std::string& path);

}  // namespace vallecula::curricula
