// A score as lines on a terminal.
#pragma once

#include <ostream>

#include "curricula/score/score.h"

namespace vallecula::gui {

/// The figures with units, passed or not, and the reasons.
void print_score(std::ostream& out, const curricula::Score& score, const curricula::Scenario& scenario);

}  // namespace vallecula::gui
