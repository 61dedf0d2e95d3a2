// One device driven by itself, without a patient: its guard at the servo's rate on a thread of its own. For the check
// before a session.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "device/guarded_device.h"
#include "device/latest_value.h"

namespace vallecula::gui {

/// Size of a test's push in the hand, N: at most this, and at most half of what the device bears for long.
constexpr double kPushN = 1.0;
/// A push lasts so long, and ends at once when the handle has gone so far: nobody holds it.
constexpr double kPushS = 0.8, kPushedAwayM = 0.04;

/// What the guard last saw of the device. Vectors are right, up and towards the person, as the operator has them.
struct ProbeState {
  std::array<double, 3> tool_m{0, 0, 0};  ///< from where it was when centre() was asked for
  std::uint32_t buttons = 0;              ///< after the guard's map
  device::GuardState guard = device::GuardState::working;
  device::DeviceFault fault = device::DeviceFault::none;  ///< of the pause that holds; none: it is not paused
  device::Calibration calibration = device::Calibration::not_needed;
  int centres = 0, measures = 0;  ///< as centre() and measure() gave it: which of them this is the state after
  double measured_s = 0.0;        ///< since measure() was asked for
  std::int64_t ticks = 0;         ///< in that time
  std::int64_t late = 0;          ///< of them: their force was written more than 1 ms after it was due
  bool real_time = false;         ///< the system granted real-time priority
  int pushes = 0;                 ///< done, whole or not
  double pushed_n = 0.0;          ///< the largest force that was sent to the device in the last push
  bool pushed_away = false;       ///< the last push ended because the handle went away
};

/// Owns the device from the first tick to the last. Forces go through the guard's output chain only, and none is asked
/// for while the guard is not working. Setters and newest(): one thread, the window's.
class DeviceProbe {
 public:
  DeviceProbe(std::unique_ptr<device::HapticDevice> device, const device::GuardSettings& settings);
  ~DeviceProbe();  ///< lets go of the device
  DeviceProbe(const DeviceProbe&) = delete;
  DeviceProbe& operator=(const DeviceProbe&) = delete;

  const device::DeviceInfo& info() const { return info_; }
  device::HapticDevice& device() { return *device_; }
  const ProbeState& newest() { return published_.newest(); }
  int centre();
  int measure();
  /// Along +1 or -1 of axis 0 right, 1 up, 2 towards the person.
  void push(int axis, int sign);
  /// The hand has hold of a device that was away.
  void confirm() { guard_.confirm(); }
  double push_n() const { return push_n_; }  ///< size of push() in the hand; 0: the device shows no force

 private:
  struct Asked {
    int centre = 0, measure = 0, push = 0;  ///< how often
    int axis = 0, sign = 1;
  };
  void run();
  double push_at(double seconds) const noexcept;

  const std::unique_ptr<device::HapticDevice> device_;
  const device::DeviceInfo info_;
  const double push_n_, model_push_n_;  ///< in the hand; what is asked of the guard for it
  device::GuardedDevice guard_;
  Asked wanted_;  ///< the window's
  device::LatestValue<Asked> asked_{Asked()};
  device::LatestValue<ProbeState> published_{ProbeState()};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace vallecula::gui
