// Scores are pure functions of the trial log.
#pragma once

#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/trial_log.h"

namespace vallecula::curricula {

struct Score {
  double peak_tongue_force_n = 0.0;          ///< model force; magnitude, tongue only
  double time_of_peak_tongue_force_s = 0.0;
  double time_to_trachea_visible_s = -1.0;   ///< from the attempt's start; -1: never (null in JSON)
  double glottis_visible_max_percent = 0.0;
  double peak_gum_force_n = 0.0;
  double time_of_peak_gum_force_s = 0.0;
  double attempt_time_s = 0.0;               ///< blade into the mouth to blade out (NEAR4NEOS)
  double attempt_start_s = 0.0;              ///< in trial time
  double time_over_force_limit_s = 0.0;      ///< device limit: state not `tracking`
  double time_over_target_s = 0.0;           ///< tongue force over the scenario's target
  double loop_rate_hz = 0.0;
  long long deadline_misses = 0;
  long long ticks = 0;
  bool passed = false;
  std::vector<std::string> reasons;          ///< each with the figure, the limit and the second it happened
};

Score score_trial(const TrialLog& log, const Scenario& scenario);
std::string score_to_json(const Score& score, const TrialLog& log, const Scenario& scenario);

}  // namespace vallecula::curricula
