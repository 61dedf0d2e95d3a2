// One device as the library's servo loop sees it: reads the pose, decides on faults, lets a force through or not.
#pragma once

#include <atomic>
#include <cstdint>

#include "device/drivers/hdapi/hd_decode.h"
#include "device/latest_value.h"

namespace vallecula::device::hdapi {

/// What a device says of itself when it is opened.
struct Properties {
  DeviceInfo info;
  Vector middle_mm{0, 0, 0};  ///< of the usable workspace
  unsigned int calibration_styles = 0;
  int motors = 3;
};

/// The force shown is zero whenever: a fault holds; the command is not finite; the device does not know where it
/// stands; no new command came for kWatchdogS, which is servo_late unless the last one was zero. A fault ends when no
/// error came for kQuietS, the command is below kEasedShare of the peak, warm motors have cooled to kCoolWarmth; then
/// the force output is switched on again and grows from zero over kRampS. A command of exactly zero is shown at once;
/// any other change is bounded to kMostRateNS, as in the output chain, so that what a late turn or a burst of ticks
/// brings at once reaches the hand spread over the turns that follow.
constexpr double kWatchdogS = 0.05, kQuietS = 0.5, kEasedShare = 0.5, kCoolWarmth = 0.8, kRampS = 0.1;
constexpr double kMostRateNS = 400.0;

class Channel {
 public:
  // --- the driver's side: one thread, the trial's servo; wait-free ---------------------------------------------------
  struct State {
    Pose pose;
    std::uint32_t buttons = 0;
  };
  const State& newest() noexcept { return state_.newest(); }
  void command(const Vector& force_n) noexcept;

  // --- any thread ----------------------------------------------------------------------------------------------------
  /// The fault that holds; without one, that of the time for which the library's loop has been standing still.
  DeviceFault fault() const noexcept;
  Calibration calibration() const noexcept { return calibration_.load(std::memory_order_relaxed); }
  double warmth() const noexcept { return warmth_.load(std::memory_order_relaxed); }
  /// No force from now on, for good: the owner goes.
  void silence() noexcept { silent_.store(true, std::memory_order_relaxed); }
  bool silent() const noexcept { return silent_.load(std::memory_order_relaxed); }

  // --- while the library's loop stands -------------------------------------------------------------------------------
  void attach(Handle handle, const Properties& properties) noexcept;
  /// The device is not there any more: fault unplugged until the next attach().
  void detach() noexcept;
  Handle handle() const noexcept { return handle_; }
  bool lost() const noexcept;

  // --- the library's loop, each turn in this order -------------------------------------------------------------------
  void begin(const Functions& hd, double now_s) noexcept;
  /// An error that the library reports of this device.
  void note(DeviceFault fault) noexcept;
  /// may_show: false in the turns before the loop is stopped; no force then.
  void exchange(const Functions& hd, bool may_show) noexcept;
  void settle(const Functions& hd) noexcept;

 private:
  struct Command {
    Vector force_n{0, 0, 0};
    std::uint64_t number = 0;
  };
  void look_slowly(const Functions& hd) noexcept;
  Vector force_to_show(bool may_show) noexcept;
  bool over(DeviceFault fault) const noexcept;

  // Set while the loop stands.
  Handle handle_ = kNoDevice;
  Vector middle_mm_{0, 0, 0};
  double peak_n_ = 0.0, period_s_ = 0.001;
  unsigned int styles_ = 0;
  int motors_ = 3;
  // The loop's own.
  State now_;
  Command newest_command_;
  Vector shown_{0, 0, 0};
  double elapsed_s_ = 0.0, last_s_ = 0.0;  ///< own time: a turn lasts its nominal period at least
  double commanded_s_ = -1.0, error_s_ = 0.0;
  DeviceFault noted_ = DeviceFault::none;
  std::uint64_t turns_ = 0, on_since_ = 0;
  bool answers_ = false;
  // Handed over.
  LatestValue<State> state_{State{}};
  LatestValue<Command> commands_{Command{}};
  std::uint64_t commands_given_ = 0;  ///< the driver's side
  std::atomic<bool> bad_command_{false}, silent_{false};
  std::atomic<DeviceFault> fault_{DeviceFault::not_calibrated};
  std::atomic<Calibration> calibration_{Calibration::needs_update};
  std::atomic<double> warmth_{-1.0};
  std::atomic<std::int64_t> turned_ns_{0};
};

}  // namespace vallecula::device::hdapi
