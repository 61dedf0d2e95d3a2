// Brings a curriculum of an older schema to the newest (private to the library).
#pragma once

#include <yaml-cpp/yaml.h>

namespace vallecula::curricula {

/// `document` has passed schema 1. Its scenarios become one module in which everything may be practised and assessed.
/// Every field of a scenario means in schema 2 what it meant in schema 1.
void migrate_1_to_2(YAML::Node& document);

}  // namespace vallecula::curricula
