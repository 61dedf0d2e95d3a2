#include "device/output_chain.h"

#include <limits>
#include <stdexcept>
#include <string>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

double checked(double value, bool ok, const char* name) {
  if (!std::isfinite(value) || !ok) {
    throw std::invalid_argument(std::string("output chain: ") + name + " = " + std::to_string(value) +
                                " is out of range");
  }
  return value;
}

/// Shortens v to `limit`; a hair less, so that rounding cannot leave it above.
Vector shortened(const Vector& v, double limit) noexcept {
  const double norm = length(v);
  if (!(norm > limit)) return v;
  return scale(v, limit / norm * (1.0 - 4.0 * std::numeric_limits<double>::epsilon()));
}

}  // namespace

OutputChain::OutputChain(const OutputLimits& limits) {
  checked(limits.period_s, limits.period_s > 0.0, "period_s");
  peak_n_ = checked(limits.peak_force_n, limits.peak_force_n >= 0.0, "peak_force_n");
  step_n_ = checked(limits.rate_n_s, limits.rate_n_s > 0.0, "rate_n_s") * limits.period_s;
  checked(limits.cutoff_hz, limits.cutoff_hz > 0.0 && limits.cutoff_hz * limits.period_s < 0.5, "cutoff_hz");
  gain_ = 1.0 - std::exp(-2.0 * M_PI * limits.cutoff_hz * limits.period_s);
}

std::array<double, 3> OutputChain::send(HapticDevice& device, const std::array<double, 3>& force_n) noexcept {
  // The filter runs on what was really sent: one state, so no hidden force builds up behind the clamp.
  const Vector filtered = add(sent_, scale(subtract(force_n, sent_), gain_));
  Vector force = add(sent_, shortened(subtract(filtered, sent_), step_n_));
  if (!finite(force) || !finite(force_n)) {
    force = {0, 0, 0};
    fault_ = DeviceFault::non_finite_command;
  }
  sent_ = shortened(force, peak_n_);
  device.write(sent_);
  return sent_;
}

void OutputChain::reset() noexcept {
  sent_ = {0, 0, 0};
  fault_ = DeviceFault::none;
}

}  // namespace vallecula::device
