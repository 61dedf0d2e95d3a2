// Blade and tube, where the trainee chose them before the trial.
#pragma once

#include <vector>

#include "curricula/scenario.h"
#include "curricula/score/score.h"

namespace vallecula::curricula {

/// Adds "right_blade" and "right_tube" where the scenario of the log says that there was a choice.
void judge_choice(const Scenario& scenario, std::vector<Criterion>& criteria);

}  // namespace vallecula::curricula
