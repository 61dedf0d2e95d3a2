// The tube's half of a trial, measured (private to the library).
#pragma once

#include "curricula/score/score.h"

namespace vallecula::curricula {

/// Needs a log with an intubation and its scenario's. Sets `not_finite_s` to the first tick with a force that is no
/// number, where that is earlier than what it holds (below 0: never).
IntubationScore measure_intubation(const TrialLog& log, const Scenario& scenario, double& not_finite_s);

}  // namespace vallecula::curricula
