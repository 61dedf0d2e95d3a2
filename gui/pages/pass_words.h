// What a scenario asks for, in a sentence or two for whoever is about to try it.
#pragma once

#include <QString>

#include "curricula/scenario.h"

namespace vallecula::gui {

/// Every limit of the scenario's rubric.
QString passes_with(const curricula::Scenario& scenario);

}  // namespace vallecula::gui
