// Where the small programs lie that do in a process of their own what could end ours.
#pragma once

#include <filesystem>
#include <optional>

namespace vallecula::pipeline {

/// $VALLECULA_HELPERS, else beside the running program, else ../lib/vallecula beside it. Nothing when it is in none.
std::optional<std::filesystem::path> find_helper_program(const char* name);

}  // namespace vallecula::pipeline
