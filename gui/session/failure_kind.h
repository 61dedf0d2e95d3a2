// What kind of failure it was, in words that are always the same: for the program's log, which names nobody.
#pragma once

#include <exception>
#include <string>

namespace vallecula::gui {

/// "the patient's package", "the course", "the device", ...; "another cause" of what says nothing of its kind.
std::string failure_kind(const std::exception& error);

}  // namespace vallecula::gui
