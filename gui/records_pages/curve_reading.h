// One learning curve as it is to be shown: its figures, the scenario's lines, CUSUM and mastery. No window in here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curricula/records/progress.h"
#include "curricula/scenario.h"

namespace vallecula::gui {

/// What the trial page, the report and the rubric hold a figure of this name against; nothing: they do not.
std::optional<double> pass_limit(const curricula::Scenario& scenario, const std::string& figure);
std::optional<double> training_target(const curricula::Scenario& scenario, const std::string& figure);

struct CurveReading {
  std::vector<bool> successes;               ///< one a whole trial that counts; by rule and attempts below
  std::vector<curricula::CusumPoint> cusum;  ///< likewise
  curricula::CusumRule rule;
  int attempts = 2;           ///< of a procedure; more is no success
  bool assessments_only = false;  ///< by the rule, practice counts in nothing
  std::string rule_in_words;  ///< whose rule it is, with its source
  int interrupted = 0, set_aside = 0;  ///< counted in nothing
  int to_three_in_a_row = -1;  ///< trials; -1: not reached
  int to_competent = -1;       ///< trials until the sum says competent; -1: not reached
  int in_a_row = 0;            ///< successes up to the last trial
};

/// `rows`: one curve, as Progress::curve gives it. `curriculum`: theirs, where it is known (else null): a module with a
/// CUSUM rule of its own is judged by that, else by the published one.
/// The window and the paper show this reading, and no other.
CurveReading read_curve(const std::vector<curricula::RecordRow>& rows, const curricula::Curriculum* curriculum);

/// Passed, and in no more attempts than the reading's rule takes.
bool succeeded(const curricula::RecordRow& row, const CurveReading& reading);

const char* name_of(curricula::CusumVerdict verdict);  ///< "competent"
/// Of the last test that ended: its verdict; "undecided" where none has, with the sum.
std::string verdict_in_words(const std::vector<curricula::CusumPoint>& cusum);

}  // namespace vallecula::gui
