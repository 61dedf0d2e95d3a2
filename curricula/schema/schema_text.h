// The schema file's text, built into the library: validation cannot be lost by moving a file.
#pragma once

namespace vallecula::curricula {

/// JSON Schema of a curriculum with `schema: 1`.
const char* curriculum_schema_1();

}  // namespace vallecula::curricula
