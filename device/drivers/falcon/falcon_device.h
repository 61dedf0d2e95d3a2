// The Novint Falcon: three degrees of freedom sensed and driven, through libusb on a thread of its own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "device/drivers/falcon/falcon_kinematics.h"
#include "device/drivers/falcon/falcon_start.h"
#include "device/found_devices.h"
#include "device/latest_value.h"

namespace vallecula::device {

/// Every Falcon that is plugged in, with what keeps it from being used.
std::vector<FoundDevice> find_falcon();

/// Reads a position and gives a force; its grip does not turn, so the rotation is always the identity. Until a person
/// has moved the grip to its ends once (its light is red: pull it all the way out, push it all the way in), it does not
/// know where it stands, reads as not valid and gives no force. Unplugged, it is looked for twice a second. A force
/// that stands for 50 ms without a new one is withheld, and told as servo_late until one comes; whatever it was
/// withheld for, force grows from nothing again over 0.1 s.
class FalconDevice final : public HapticDevice {
 public:
  /// Opens and starts the first Falcon that is free; `firmware` as falcon::read_firmware() takes it. Throws
  /// DeviceError: none there, no permission, held by another program, no firmware, or the step of the start that
  /// failed.
  explicit FalconDevice(const std::string& firmware = "");
  /// Switches the force off and lets go within half a second.
  ~FalconDevice() override;

  DeviceInfo info() const override { return info_; }
  DeviceReading read(double time_s) noexcept override;
  void write(const std::array<double, 3>& force_n) noexcept override;
  DeviceFault fault() const noexcept override;
  Calibration calibration() const noexcept override {
    return homed_.load(std::memory_order_relaxed) ? Calibration::good : Calibration::needs_hand;
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct Wish {
    Vector force_n{0, 0, 0};
    std::uint64_t count = 0;
  };

  // --- the driver's thread -------------------------------------------------------------------------------------------
  void run() noexcept;
  void tick() noexcept;
  Vector force_now(Clock::time_point now) noexcept;
  bool take(const falcon::Report& report, Clock::time_point now) noexcept;
  void lose(DeviceFault fault) noexcept;
  void reopen() noexcept;
  void let_go() noexcept;
  void beat(Clock::time_point now) noexcept { beat_.store(now.time_since_epoch().count(), std::memory_order_relaxed); }

  const std::vector<std::uint8_t> firmware_;
  DeviceInfo info_;
  std::atomic<bool> stop_{false};
  std::mutex waiting_;
  std::condition_variable stopped_;

  // The driver's thread's (the constructor's until it starts).
  falcon::FalconUsb usb_;
  falcon::PacketReader reader_;
  falcon::Plausibility plausibility_;
  Vector position_{0, 0, 0};
  bool clean_ = false;           ///< the last exchange was whole: force may be shown
  int turns_shown_ = 0;          ///< since force was last withheld
  Clock::time_point good_at_{};  ///< the last report that was taken
  std::uint64_t wish_count_ = 0;
  Clock::time_point wish_at_{};

  // Between the threads.
  LatestValue<Wish> wish_;
  LatestValue<DeviceReading> reading_;
  std::atomic<DeviceFault> link_fault_{DeviceFault::none};
  std::atomic<bool> homed_{false};
  std::atomic<bool> overdue_{false};  ///< the servo left a force standing
  std::atomic<Clock::rep> beat_;      ///< when the driver's thread last came round

  // The servo's thread's.
  Wish wished_;
  std::atomic<bool> not_finite_{false};

  std::thread thread_;
};

}  // namespace vallecula::device
