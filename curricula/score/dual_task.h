// The dual task: what was asked beside the hands, and what came back.
#pragma once

#include <optional>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/trial_log.h"

namespace vallecula::curricula {

/// One question or alarm that was shown. Its time runs with the trial's: a pause stops it.
struct Reaction {
  enum class Result {
    right,   ///< the right answer, or the alarm silenced, within time_allowed_s
    wrong,   ///< another answer within it
    missed,  ///< nothing within it; a later answer changes nothing
    open     ///< the trial ended before its time was over: counts for nothing
  };
  int distraction = 0;  ///< of the scenario, counted from 1
  double shown_at_s = 0.0;
  Result result = Result::open;
  std::optional<double> reaction_s;  ///< of a right or wrong answer
};

struct DualTask {
  std::vector<Reaction> reactions;  ///< in the order in which they were shown; talk asks for nothing
  int right = 0, wrong = 0, missed = 0;
  /// Answers to nothing: to what was not shown (yet), was answered before, is not in the scenario or is no question;
  /// alarms silenced that did not ring; answers that the question does not offer.
  int false_answers = 0;
  std::optional<double> mean_reaction_s;  ///< of right and wrong answers; none: nothing

  int errors() const noexcept { return wrong + false_answers; }
};

/// Nothing where the log's scenario has no distractions.
std::optional<DualTask> measure_dual_task(const TrialLog& log, const Scenario& scenario);

}  // namespace vallecula::curricula
