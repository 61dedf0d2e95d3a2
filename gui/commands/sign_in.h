// Signing in on the command line.
#pragma once

#include <string>

#include "curricula/records/people.h"

namespace vallecula::gui {

/// The PIN is asked for on the terminal, unseen; where there is none it is the first line of the input. Throws
/// std::runtime_error (no such person), PinRefused.
curricula::SignedIn sign_in(curricula::People& people, const std::string& name);

}  // namespace vallecula::gui
