// The cumulative sum over successes and failures: when enough of them say that a hand is competent.
#pragma once

#include <vector>

namespace vallecula::curricula {

/// What a sequence of trials is tested for, as shares of 0..1 (0 < acceptable < unacceptable < 1, 0 < alpha, beta and
/// alpha + beta < 1). The acceptable failure rate is the one published for neonatal intubation, 80 % success within two
/// attempts (PMC8290971). Its other numbers were not found: these are assumed; with them the shortest way is 8
/// successes, which is the shortest that was reported there (8 to 46).
struct CusumRule {
  double acceptable_failure = 0.2;
  double unacceptable_failure = 0.4;
  double alpha = 0.1;  ///< risk of calling an acceptable hand deficient
  double beta = 0.1;   ///< risk of calling an unacceptable hand competent
};

/// Of the rule: P = ln(p1 / p0), Q = ln((1 - p0) / (1 - p1)).
struct CusumLines {
  double step = 0.0;   ///< s = Q / (P + Q): a success takes it away, a failure adds 1 - s
  double lower = 0.0;  ///< -h0 = -ln((1 - alpha) / beta) / (P + Q): competent at or below
  double upper = 0.0;  ///< h1 = ln((1 - beta) / alpha) / (P + Q): deficient at or above
};

enum class CusumVerdict { undecided, competent, deficient };

struct CusumPoint {
  double sum = 0.0;  ///< after this trial
  CusumVerdict verdict = CusumVerdict::undecided;
};

/// Throws std::invalid_argument for a rule outside its range.
CusumLines cusum_lines(const CusumRule& rule);

/// One point a trial, in the order given. A verdict ends a test and the next trial begins a new one at 0: nobody pays
/// for ever for first failures, and a relapse after competence is seen as soon as a first lapse would be.
std::vector<CusumPoint> cusum(const CusumRule& rule, const std::vector<bool>& successes);

/// Trials up to and with the n-th success in a row; -1: not reached. Throws std::invalid_argument for n < 1.
int trials_to_consecutive(const std::vector<bool>& successes, int n);

}  // namespace vallecula::curricula
