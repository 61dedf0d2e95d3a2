// The hand of a recorded trial, tick for tick.
#pragma once

#include <atomic>
#include <vector>

#include "device/trajectory.h"

namespace vallecula::device {

struct TimedReading {
  double time_s = 0.0;
  DeviceReading reading;  ///< in the patient's axes
};

/// Gives back what was read then, pauses as well, whatever force it is shown: a record cannot yield. A trial of the
/// same patient, scenario and build is the recorded one to the bit when neither ran in real time; in real time the
/// simulation's steps fall on other ticks each time.
class RecordedDevice final : public HapticDevice {
 public:
  /// `device_limit_n`: of the recorded trial. Throws DeviceError unless there is a reading, times increase strictly and
  /// the limit is finite and not negative.
  RecordedDevice(std::vector<TimedReading> readings, double device_limit_n);

  DeviceInfo info() const override;
  /// The last reading that is not later than `time_s`.
  DeviceReading read(double time_s) noexcept override;
  void write(const std::array<double, 3>&) noexcept override {}
  /// Which fault it was is not recorded.
  DeviceFault fault() const noexcept override { return fault_.load(std::memory_order_relaxed); }
  bool confirms_itself() const noexcept override { return true; }
  bool plays_back() const noexcept override { return true; }
  bool finished(double time_s) const noexcept override { return time_s > readings_.back().time_s; }

 private:
  std::vector<TimedReading> readings_;
  double device_limit_n_;
  std::atomic<DeviceFault> fault_{DeviceFault::none};
};

}  // namespace vallecula::device
