// A device for tests that reads and fails as it is told, and keeps what it was told.
#pragma once

#include "device/haptic_device.h"
#include "device/rotation.h"

namespace vallecula::device {

class PuppetDevice final : public HapticDevice {
 public:
  explicit PuppetDevice(bool own_axes, double continuous_n = 0.0) : own_axes_(own_axes), continuous_n_(continuous_n) {}
  DeviceInfo info() const override {
    DeviceInfo info;
    info.kind = "puppet";
    info.peak_force_n = 7.9;
    info.continuous_force_n = continuous_n_;
    info.own_axes = own_axes_;
    info.max_stiffness_n_m = max_stiffness_n_m;
    return info;
  }
  DeviceReading read(double) noexcept override { return reading; }
  void write(const std::array<double, 3>& force_n) noexcept override { heard = force_n, ++writes; }
  DeviceFault fault() const noexcept override { return trouble; }
  Calibration calibration() const noexcept override { return calibrated; }

  DeviceReading reading;
  DeviceFault trouble = DeviceFault::none;
  Calibration calibrated = Calibration::good;
  Vector heard{0, 0, 0};
  int writes = 0;
  double max_stiffness_n_m = 0.0;

 private:
  bool own_axes_;
  double continuous_n_;
};

}  // namespace vallecula::device
