#include "device/drivers/recorded_device.h"

#include <algorithm>
#include <cmath>

namespace vallecula::device {
namespace {

/// Times of ticks are sums and products of the period: equal to far better than this.
constexpr double kSameTimeS = 1e-6;

}  // namespace

RecordedDevice::RecordedDevice(std::vector<TimedReading> readings, double device_limit_n)
    : readings_(std::move(readings)), device_limit_n_(device_limit_n) {
  if (readings_.empty()) throw DeviceError("recorded hand: it holds no tick; take another trial");
  for (std::size_t i = 1; i < readings_.size(); ++i) {
    if (!(readings_[i].time_s > readings_[i - 1].time_s))
      throw DeviceError("recorded hand: tick " + std::to_string(i) + " is not later than the one before");
  }
  if (!std::isfinite(device_limit_n) || device_limit_n < 0.0)
    throw DeviceError("recorded hand: its device's limit is no force");
}

DeviceInfo RecordedDevice::info() const {
  DeviceInfo info;
  info.kind = "recorded";
  info.model = "recorded hand";
  info.peak_force_n = device_limit_n_;
  info.actuated_dof = 3;
  return info;
}

DeviceReading RecordedDevice::read(double time_s) noexcept {
  const auto next = std::upper_bound(readings_.begin(), readings_.end(), time_s + kSameTimeS,
                                     [](double t, const TimedReading& r) { return t < r.time_s; });
  const DeviceReading& reading = next == readings_.begin() ? next->reading : (next - 1)->reading;
  fault_.store(reading.valid ? DeviceFault::none : DeviceFault::communication_lost, std::memory_order_relaxed);
  return reading;
}

}  // namespace vallecula::device
