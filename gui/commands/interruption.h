// Ctrl-C and a polite kill in the middle of long work: it is left at the next report of progress, and cleans up.
#pragma once

#include <string>

namespace vallecula::gui {

/// From here on the first SIGINT or SIGTERM only raises a flag; a second one ends the program at once.
void watch_for_interruption();
bool interrupted() noexcept;
/// Throws std::runtime_error("WORK was interrupted; nothing was written") once the flag is up.
void stop_when_interrupted(const std::string& work);

}  // namespace vallecula::gui
