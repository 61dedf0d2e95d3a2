// Counts every allocation of the test program, so that a tick can be shown to make none.
#pragma once

#include <atomic>

namespace vallecula::engine::testing {

extern std::atomic<long> allocations;

}  // namespace vallecula::engine::testing
