// Touch, Touch X and the other devices that HDAPI drives.
#pragma once

#include <memory>

#include "device/drivers/hdapi/hd_scheduler.h"
#include "device/found_devices.h"

namespace vallecula::device::hdapi {

/// The pose is the stylus's: where its gimbal's centre is, from the middle of the workspace, and how it is turned, in
/// the device's axes. Read while a fault holds too (valid is false then), as long as the device answers.
class HdDevice final : public HapticDevice {
 public:
  /// Opens the device that the vendor's set-up calls `name`; empty: the default one. Waits up to a second for it to be
  /// ready. Throws DeviceError saying what is missing, where it looked, and the mend.
  explicit HdDevice(const std::string& name);
  /// The motors are off when it returns; never waits longer than twice Scheduler::kPatience.
  ~HdDevice() override;
  HdDevice(const HdDevice&) = delete;
  HdDevice& operator=(const HdDevice&) = delete;

  DeviceInfo info() const override { return opened_.info; }
  DeviceReading read(double time_s) noexcept override;
  void write(const std::array<double, 3>& force_n) noexcept override { opened_.channel->command(force_n); }
  DeviceFault fault() const noexcept override { return opened_.channel->fault(); }
  Calibration calibration() const noexcept override { return opened_.channel->calibration(); }
  double motor_warmth() const noexcept override { return opened_.channel->warmth(); }

 private:
  std::shared_ptr<Scheduler> scheduler_;
  Scheduler::Opened opened_;
};

/// The devices that the vendor's set-up knows, or why there is none. Those that this program has open are told as they
/// are, and nothing else is touched; otherwise each is opened for as long as it takes to ask. Who lists and who opens
/// wait for each other: neither finds a device taken by the other.
std::vector<FoundDevice> ask_touch();
/// The same for a list that is shown anew every second: asks once in kAskAgain, and gives the last answer between.
std::vector<FoundDevice> find_touch();
constexpr std::chrono::seconds kAskAgain{5};

}  // namespace vallecula::device::hdapi
