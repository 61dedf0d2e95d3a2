// What was asked for beside the hands, and what keeps a trial from counting.
#pragma once

#include "curricula/score/score.h"

namespace vallecula::curricula {

/// The log without the ticks in which the blade was led to the vallecula; at least its last tick. Where it was not led,
/// nothing.
std::optional<TrialLog> after_lead_in(const TrialLog& log);

/// Fills the score's uses and what sets the trial aside; `log`: what is scored.
void measure_helps(const TrialLog& log, const Scenario& scenario, bool led_in, Score& score);

}  // namespace vallecula::curricula
