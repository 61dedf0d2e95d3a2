// Counts what `operator new` is asked for, to show that a tick allocates nothing.
#pragma once

namespace vallecula::device::testing {

/// Allocations by this thread since the program began.
long long allocations() noexcept;

}  // namespace vallecula::device::testing
