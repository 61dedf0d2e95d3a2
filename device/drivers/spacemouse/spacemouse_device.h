// A SpaceMouse as a hand: its reports are read on a thread of its own, the servo thread integrates the rate they ask
// for.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "device/drivers/spacemouse/rate_control.h"
#include "device/drivers/spacemouse/spacemouse_list.h"
#include "device/latest_value.h"

struct hid_device_;

namespace vallecula::device {

/// Six-degree rate control in the device's own axes; shows no force. Unplugged, it reports the fault and its last pose,
/// and looks twice a second whether it is back; it then goes on from there.
class SpaceMouseDevice final : public HapticDevice {
 public:
  /// `argument`: a serial number or a number in the list of `vallecula devices`; empty: the first that this program
  /// does not use yet. Throws DeviceError saying what is missing, or why it cannot be opened, and how to mend it.
  explicit SpaceMouseDevice(const std::string& argument = "", const RateSettings& settings = {});
  ~SpaceMouseDevice() override;
  SpaceMouseDevice(const SpaceMouseDevice&) = delete;
  SpaceMouseDevice& operator=(const SpaceMouseDevice&) = delete;

  DeviceInfo info() const override { return spacemouse_info(place_); }
  DeviceReading read(double time_s) noexcept override;
  void write(const std::array<double, 3>&) noexcept override {}  // it has no motors
  DeviceFault fault() const noexcept override { return fault_.load(std::memory_order_relaxed); }

 private:
  struct Handed {
    SpaceMouseState cap;
    DeviceFault fault = DeviceFault::none;
  };
  void run();                             ///< the reading thread
  bool open_at(const std::string& path);  ///< caller holds hid_lock()
  void close_handle();
  void look_for_it();
  void hand_over(DeviceFault fault);

  const SpaceMousePlace place_;  ///< where it was first found: the model and the serial number it is known by
  // Servo's side.
  RateControl rate_;
  LatestValue<Handed> handed_{Handed{}};
  // Reading thread's side; the constructor's before it starts.
  hid_device_* handle_ = nullptr;
  std::string path_;
  SpaceMouseState cap_;
  // Between them.
  std::atomic<DeviceFault> fault_{DeviceFault::none};
  std::mutex waiting_;
  std::condition_variable wake_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace vallecula::device
