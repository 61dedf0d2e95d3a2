// A course of schema 2 on the block patient in which much happens beside the hands.
#pragma once

#include <filesystem>

namespace vallecula::gui::test {

/// Scenarios "busy" (a question at 0.3 s, an alarm at 0.5 s, talk at 0.6 s of trial time; no cut, no bars), "helped"
/// (all helps, a variation) and, in a module that opens after theirs, "later". Right is answer 2.
std::filesystem::path write_busy_course(const std::filesystem::path& folder);

}  // namespace vallecula::gui::test
