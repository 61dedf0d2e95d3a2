// The table of all fields of a curriculum, made from the schema.
#pragma once

#include <string>

namespace vallecula::curricula {

/// Markdown, one row a field, by name within each group: field, type, unit, allowed, default, meaning. Made from a
/// schema document (curriculum_schema_2()); throws std::logic_error for one that refers to nothing.
std::string reference_table(const char* schema_json);

}  // namespace vallecula::curricula
