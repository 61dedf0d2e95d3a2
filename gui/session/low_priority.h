// Work that nobody waits for leaves the processor to all that is waited for.
#pragma once

namespace vallecula::gui {

/// Lowers the calling thread's priority, and with it that of threads it starts, for good; `nice`: 1..19, 19 the least.
void take_low_priority(int nice);

}  // namespace vallecula::gui
