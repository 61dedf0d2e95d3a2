// The attempts of an intubation, each with what the infant did meanwhile (private to the library).
#pragma once

#include "curricula/scenario.h"
#include "curricula/score/intubation_score.h"

namespace vallecula::curricula {

/// The tube's tip lies between the cords or past them, in the airway.
bool tube_past_cords(const LogTick& tick) noexcept;

std::vector<Attempt> measure_attempts(const TrialLog& log, const Scenario& scenario);

}  // namespace vallecula::curricula
