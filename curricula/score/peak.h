// The largest value of one tick, and when.
#pragma once

#include <cmath>

namespace vallecula::curricula {

struct Peak {
  double value = 0.0;
  double at_s = -1.0;  ///< second of the trial; -1: it was never above 0

  /// What is no number is not larger.
  void take(double other, double other_at_s) noexcept {
    if (std::isfinite(other) && other > value) value = other, at_s = other_at_s;
  }
};

}  // namespace vallecula::curricula
