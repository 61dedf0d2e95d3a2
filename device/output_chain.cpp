#include "device/output_chain.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

/// From this warmth on the force allowed falls from the peak to the continuous one, which it reaches at 1.
constexpr double kWarm = 0.8;
/// A force wanted of more than this is a contact.
constexpr double kContactN = 0.02;

double checked(double value, bool ok, const char* name) {
  if (!std::isfinite(value) || !ok) {
    throw std::invalid_argument(std::string("output chain: ") + name + " = " + std::to_string(value) +
                                " is out of range");
  }
  return value;
}

}  // namespace

OutputChain::OutputChain(const OutputLimits& limits) {
  checked(limits.period_s, limits.period_s > 0.0, "period_s");
  peak_n_ = checked(limits.peak_force_n, limits.peak_force_n >= 0.0, "peak_force_n");
  checked(limits.continuous_force_n, limits.continuous_force_n >= 0.0, "continuous_force_n");
  continuous_n_ = limits.continuous_force_n > 0.0 ? std::min(limits.continuous_force_n, peak_n_) : peak_n_;
  step_n_ = checked(limits.rate_n_s, limits.rate_n_s > 0.0, "rate_n_s") * limits.period_s;
  checked(limits.cutoff_hz, limits.cutoff_hz > 0.0 && limits.cutoff_hz * limits.period_s < 0.5, "cutoff_hz");
  gain_ = 1.0 - std::exp(-2.0 * M_PI * limits.cutoff_hz * limits.period_s);
  checked(limits.thermal_time_s, limits.thermal_time_s > 0.0, "thermal_time_s");
  warming_ = 1.0 - std::exp(-limits.period_s / limits.thermal_time_s);
  ramp_step_ = limits.period_s / checked(limits.soft_start_s, limits.soft_start_s >= limits.period_s, "soft_start_s");
  scale_ = checked(limits.force_scale, limits.force_scale > 0.0 && limits.force_scale <= 1.0, "force_scale");
}

double OutputChain::thermal_limit_n(double device_warmth) const noexcept {
  const double warmest = std::max(warmth(), device_warmth);  // where the device tells of itself, the warmer of the two
  const double left = std::clamp((1.0 - warmest) / (1.0 - kWarm), 0.0, 1.0);
  return continuous_n_ + (peak_n_ - continuous_n_) * left;
}

void OutputChain::warm_up() noexcept {
  const double sent_n = length(sent_);
  heat_n2_ += warming_ * (sent_n * sent_n - heat_n2_);
}

std::array<double, 3> OutputChain::send(HapticDevice& device, const std::array<double, 3>& force_n) noexcept {
  warm_up();
  const Vector wanted = scale(force_n, scale_);
  if (ramp_ > 0.0 || length(wanted) > kContactN) ramp_ = std::min(1.0, ramp_ + ramp_step_);
  // What is allowed falls by no more than half of what a tick may change, so that the clamp keeps the rate limit too:
  // shortening to a smaller ball moves the force sent by no more than the ball shrank.
  const double before_n = allowed_n_;
  allowed_n_ = std::max(std::min(thermal_limit_n(device.motor_warmth()), peak_n_ * ramp_), before_n - 0.5 * step_n_);
  const double step_n = step_n_ - std::max(0.0, before_n - allowed_n_);

  // The filter runs on what was really sent: one state, so no hidden force builds up behind the clamp.
  const Vector filtered = add(sent_, scale(subtract(wanted, sent_), gain_));
  const Vector force = add(sent_, shortened(subtract(filtered, sent_), step_n));
  if (!finite(force) || !finite(wanted)) {
    drop();
    fault_ = DeviceFault::non_finite_command;
  } else {
    sent_ = shortened(force, allowed_n_);
  }
  device.write(sent_);
  return sent_;
}

void OutputChain::stop(HapticDevice& device) noexcept {
  warm_up();
  drop();
  device.write(sent_);
}

void OutputChain::drop() noexcept {
  sent_ = {0, 0, 0};
  ramp_ = allowed_n_ = 0.0;
}

void OutputChain::reset() noexcept {
  drop();
  fault_ = DeviceFault::none;
}

}  // namespace vallecula::device
