#include "curricula/progress/cusum.h"

#include <cmath>
#include <stdexcept>

namespace vallecula::curricula {

CusumLimits cusum_limits(const CusumRule& rule) {
  const double p0 = rule.acceptable_failure_rate, p1 = rule.unacceptable_failure_rate;
  const bool in_range =
      p0 > 0.0 && p1 > p0 && p1 < 1.0 && rule.alpha > 0.0 && rule.beta > 0.0 && rule.alpha + rule.beta < 1.0;
  if (!in_range)
    throw std::invalid_argument(
        "CUSUM: 0 < acceptable < unacceptable failure rate < 1, errors above 0 and together below 1");
  const double p = std::log(p1 / p0), q = std::log((1.0 - p0) / (1.0 - p1));
  const double s = q / (p + q);
  return {s, 1.0 - s, std::log((1.0 - rule.alpha) / rule.beta) / (p + q),
          std::log((1.0 - rule.beta) / rule.alpha) / (p + q)};
}

CusumCurve cusum(const std::vector<bool>& success, const CusumRule& rule) {
  const CusumLimits limits = cusum_limits(rule);
  CusumCurve curve;
  double sum = 0.0, began = 0.0;
  for (std::size_t i = 0; i < success.size(); ++i) {
    sum += success[i] ? -limits.success_step : limits.failure_step;
    curve.sum.push_back(sum);
    const int at = static_cast<int>(i);
    if (sum - began <= -limits.competent) {
      if (curve.competent_at < 0) curve.competent_at = at;
      curve.last = CusumVerdict::competent;
      began = sum;
    } else if (sum - began >= limits.deficient) {
      if (curve.deficient_at < 0) curve.deficient_at = at;
      curve.last = CusumVerdict::deficient;
      began = sum;
    }
  }
  return curve;
}

int procedures_to_consecutive(const std::vector<bool>& success, int n) {
  if (n < 1) throw std::invalid_argument("successes in a row: 1 or more");
  int in_a_row = 0;
  for (std::size_t i = 0; i < success.size(); ++i) {
    in_a_row = success[i] ? in_a_row + 1 : 0;
    if (in_a_row == n) return static_cast<int>(i) + 1;
  }
  return -1;
}

}  // namespace vallecula::curricula
