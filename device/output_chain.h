// The only way a force reaches a device: low-pass, rate limit, finite check, clamp, send. None can be switched off.
#pragma once

#include "device/haptic_device.h"

namespace vallecula::device {

struct OutputLimits {
  double peak_force_n = 7.9;  ///< magnitude never exceeded; 0 for a device that shows no force
  double rate_n_s = 400.0;    ///< bound on the change of the force sent, as a vector, per second
  double cutoff_hz = 200.0;   ///< first-order low-pass; below the servo's Nyquist frequency
  double period_s = 0.001;    ///< of the servo
};

/// One per device, used by the servo thread only.
class OutputChain {
 public:
  /// Throws std::invalid_argument when a limit is not a positive finite number (peak_force_n may be zero).
  explicit OutputChain(const OutputLimits& limits);

  /// Filters and limits `force_n` (N, world axes), writes it to `device` and returns what was sent. A force that is not
  /// finite becomes zero at once (the one step the rate limit does not bound) and sets the fault; the next finite
  /// force grows from zero under the rate limit. Wait-free.
  std::array<double, 3> send(HapticDevice& device, const std::array<double, 3>& force_n) noexcept;

  const std::array<double, 3>& last_sent_n() const noexcept { return sent_; }
  /// non_finite_command from the first such force until reset().
  DeviceFault fault() const noexcept { return fault_; }
  /// Zero force as the starting point, no fault.
  void reset() noexcept;

 private:
  double peak_n_, step_n_, gain_;
  std::array<double, 3> sent_{0, 0, 0};
  DeviceFault fault_ = DeviceFault::none;
};

}  // namespace vallecula::device
