// How well and how steadily the glottis was seen.
#pragma once

#include <optional>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/trial_log.h"

namespace vallecula::curricula {

struct Stay;

/// Of the sight samples (every 20 steps, kept until the next one) with the blade in the mouth, less pauses.
struct ViewFigures {
  std::optional<double> mean_percent;  ///< of the glottis, over the time in which any of it was in sight; never: nothing
  double in_sight_s = 0.0;             ///< with scenario.sight_percent or more of it
  /// From the start of the first attempt that has one to the begin of the first kStableViewS in one piece with
  /// scenario.sight_percent or more.
  std::optional<double> time_to_stable_s;
  double stable_at_s = -1.0;  ///< second of the trial of that; -1: never
};

constexpr double kStableViewS = 2.0;  ///< assumed: long enough to reach for the tube

ViewFigures measure_view(const TrialLog& log, const Scenario& scenario, const std::vector<Stay>& attempts);

/// Cormack and Lehane's grade by the best view: 1 where most of the glottis is seen (more than half), 2 where any of it
/// is (1984: "most of the glottis", "at best almost half"; modifications ask for the full glottis for 1). Nothing where
/// none is seen: that is 3 with the epiglottis in sight and 4 without, and no log knows whether it was.
std::optional<int> cormack_lehane(double best_percent) noexcept;

}  // namespace vallecula::curricula
