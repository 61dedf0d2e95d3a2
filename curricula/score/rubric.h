// From figures to passed or not, with a sentence for each line of the rubric (private to the library).
#pragma once

#include "curricula/score/score.h"

namespace vallecula::curricula {

/// Moments of events, trial time; -1: never.
struct Moments {
  double over_target_s = -1.0;          ///< the first
  double longest_off_tracking_s = -1.0;  ///< start of the longest stay at the device limit or lost
  double not_finite_s = -1.0;  ///< a recorded force was not a number
};

/// Fills criteria, passed and reasons from the figures already in `score`.
void judge(const TrialLog& log, const Scenario& scenario, const Moments& moments, Score& score);

}  // namespace vallecula::curricula
