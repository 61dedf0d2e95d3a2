// The schema files' text, built into the library: validation cannot be lost by moving a file.
#pragma once

namespace vallecula::curricula {

/// JSON Schema of a curriculum with `schema: 1`: closed, only read.
const char* curriculum_schema_1();
/// With `schema: 2`, the newest. A scenario of it may hold everything that one of schema 1 holds.
const char* curriculum_schema_2();

}  // namespace vallecula::curricula
