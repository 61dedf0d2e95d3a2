#include "curricula/progress/cusum.h"

#include <cmath>
#include <stdexcept>

namespace vallecula::curricula {

CusumLines cusum_lines(const CusumRule& rule) {
  const double p0 = rule.acceptable_failure, p1 = rule.unacceptable_failure;
  // Written so that a value that is not a number is refused as well.
  if (!(p0 > 0.0 && p0 < p1 && p1 < 1.0))
    throw std::invalid_argument("cusum: needs 0 < acceptable failure rate < unacceptable failure rate < 1");
  if (!(rule.alpha > 0.0 && rule.beta > 0.0 && rule.alpha + rule.beta < 1.0))
    throw std::invalid_argument("cusum: needs alpha and beta above 0, together below 1");
  const double p = std::log(p1 / p0), q = std::log((1.0 - p0) / (1.0 - p1));
  return {q / (p + q), -std::log((1.0 - rule.alpha) / rule.beta) / (p + q),
          std::log((1.0 - rule.beta) / rule.alpha) / (p + q)};
}

std::vector<CusumPoint> cusum(const CusumRule& rule, const std::vector<bool>& successes) {
  const CusumLines lines = cusum_lines(rule);
  std::vector<CusumPoint> points;
  points.reserve(successes.size());
  int won = 0, lost = 0;  // of this test; a running sum of steps would drift past its line
  for (const bool success : successes) {
    ++(success ? won : lost);
    CusumPoint point;
    point.sum = lost * (1.0 - lines.step) - won * lines.step;
    if (point.sum <= lines.lower) point.verdict = CusumVerdict::competent;
    if (point.sum >= lines.upper) point.verdict = CusumVerdict::deficient;
    if (point.verdict != CusumVerdict::undecided) won = lost = 0;
    points.push_back(point);
  }
  return points;
}

int trials_to_consecutive(const std::vector<bool>& successes, int n) {
  if (n < 1) throw std::invalid_argument("successes in a row: 1 or more");
  int in_a_row = 0;
  for (std::size_t i = 0; i < successes.size(); ++i) {
    in_a_row = successes[i] ? in_a_row + 1 : 0;
    if (in_a_row == n) return static_cast<int>(i) + 1;
  }
  return -1;
}

}  // namespace vallecula::curricula
