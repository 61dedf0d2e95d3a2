// The rubric's lines about an intubation (private to the library).
#pragma once

#include <vector>

#include "curricula/score/score.h"

namespace vallecula::curricula {

/// The limit of an attempt holds for each of them, so for the longest. There is at least one.
Criterion longest_attempt_time(const Scenario& scenario, const Score& score);

/// Appends a line for the outcome and for each limit that scenario.intubation.pass has; of times only where the whole
/// way was the hand's (`timed`).
void judge_intubation(const Scenario& scenario, bool timed, const IntubationScore& score,
                      std::vector<Criterion>& criteria);

}  // namespace vallecula::curricula
