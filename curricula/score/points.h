// The rubric's weights: how many of the points a trial earned, and what each pass mark stands on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curricula/score/score.h"

namespace vallecula::curricula {

/// One pass mark of a scored trial.
struct MarkPoints {
  std::string mark;      ///< the field in the scenario's pass, "peak_tongue_force_n"
  double of = 0.0;       ///< points it is worth
  double earned = 0.0;   ///< all of them or none: a mark is met or it is not; none where there was nothing to judge
  double at_s = -1.0;    ///< trial time that decided, as in the criterion; -1: none
  std::string sentence;  ///< the criterion's
  std::string source;    ///< of the limit, ending with "not validated"; for a mark without one "no source given"
};

/// The scenario's pass marks that were judged; the points of all of them together are 100, shared by the rubric's
/// weights (1 where it names none). A trial that was cut off, or whose attempt never began, earns none. Empty where
/// every weight is 0, and where the trial was begun at the vallecula: a part has no score of the whole. Points inform;
/// what fails a trial is `passed`.
std::vector<MarkPoints> points_of(const Score& score, const Scenario& scenario);

/// A pass mark's source for a person: never without saying that nobody has validated it.
std::string source_of(const Scenario& scenario, const std::string& mark);

}  // namespace vallecula::curricula
