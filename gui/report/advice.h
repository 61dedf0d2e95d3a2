// The one sentence a trainee takes along: what to change first.
#pragma once

#include <string>

#include "curricula/score/score.h"

namespace vallecula::gui {

/// The weightiest shortcoming of the trial in words of technique (CLINICAL.md): force on the gum before force on the
/// tongue before sight before time. For a passed trial: what was nearest to its limit.
std::string what_to_change(const curricula::Score& score, const curricula::Scenario& scenario);

}  // namespace vallecula::gui
