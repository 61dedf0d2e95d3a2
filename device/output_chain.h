// The only way a force reaches a device: low-pass, rate limit, finite check, clamp, send. None can be switched off.
// What the clamp allows is the peak for short, the continuous force for long, and grows from zero at the first contact.
#pragma once

#include "device/haptic_device.h"

namespace vallecula::device {

struct OutputLimits {
  double peak_force_n = 7.9;        ///< magnitude never exceeded; 0 for a device that shows no force
  double rate_n_s = 400.0;          ///< bound on the change of the force sent, as a vector, per second
  double cutoff_hz = 200.0;         ///< first-order low-pass; below the servo's Nyquist frequency
  double period_s = 0.001;          ///< of the servo
  double continuous_force_n = 0.0;  ///< what the motors bear for long; 0: as much as the peak
  /// Of the motors' warming. Assumed: no device tells its own; with 60 s a Touch X bears its 7.9 N for 2.4 s.
  double thermal_time_s = 60.0;
  double soft_start_s = 0.5;  ///< after reset(): from the first contact on the force allowed grows from zero this long
  double force_scale = 1.0;   ///< force shown to the hand over the model's; above 0, at most 1
};

/// One per device, used by the servo thread only.
class OutputChain {
 public:
  /// Throws std::invalid_argument when a limit is not a positive finite number (peak_force_n may be zero).
  explicit OutputChain(const OutputLimits& limits);

  /// Filters and limits `force_n` (N, world axes), writes it to `device` and returns what was sent. A force that is not
  /// finite becomes zero at once (the one step the rate limit does not bound) and sets the fault; the next finite
  /// force grows from zero under the rate limit and the soft start. Wait-free.
  std::array<double, 3> send(HapticDevice& device, const std::array<double, 3>& force_n) noexcept;
  /// Zero force at once, for a tick in which none may be shown; the motors cool meanwhile, the soft start begins anew.
  void stop(HapticDevice& device) noexcept;
  /// The soft start begins anew without a step: the force allowed falls to zero under the rate limit first.
  void soften() noexcept { ramp_ = 0.0; }

  const std::array<double, 3>& last_sent_n() const noexcept { return sent_; }
  /// non_finite_command from the first such force until reset().
  DeviceFault fault() const noexcept { return fault_; }
  /// How warm the motors are by the model: 0 cold, 1 as after long at the continuous force, which is never passed.
  double warmth() const noexcept { return continuous_n_ > 0.0 ? heat_n2_ / (continuous_n_ * continuous_n_) : 0.0; }
  /// Zero force as the starting point, no fault. What is warm stays warm.
  void reset() noexcept;

 private:
  double thermal_limit_n(double device_warmth) const noexcept;
  void warm_up() noexcept;
  void drop() noexcept;

  double peak_n_, continuous_n_, step_n_, gain_, warming_, ramp_step_, scale_;
  std::array<double, 3> sent_{0, 0, 0};
  double heat_n2_ = 0.0;    ///< I2t: square of the force sent, low-passed with the thermal time
  double ramp_ = 0.0;       ///< share of the soft start that is done
  double allowed_n_ = 0.0;  ///< largest force that may be sent now: never above the peak
  DeviceFault fault_ = DeviceFault::none;
};

}  // namespace vallecula::device
