// The sentences a person reads when a device stops.
#include "device/haptic_device.h"

namespace vallecula::device {

namespace {

constexpr std::array<const char*, 10> kNames = {"none",       "force_exceeded", "communication_lost",
                                                "unplugged",  "motor_warm",     "non_finite_command",
                                                "servo_late", "not_calibrated", "driver_error",
                                                "frozen"};

}  // namespace

const char* name_of(DeviceFault fault) noexcept {
  const auto index = static_cast<std::size_t>(fault);
  return index < kNames.size() ? kNames[index] : "unknown";
}

DeviceFault fault_named(const std::string& name) noexcept {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i]) return static_cast<DeviceFault>(i);
  return DeviceFault::none;
}

const char* describe(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::none:
      return "The device works.";
    case DeviceFault::force_exceeded:
      return "The device was pressed against its force limit for too long and switched its force off: ease the "
             "hand.";
    case DeviceFault::communication_lost:
      return "The device does not answer: check its cable and its power.";
    case DeviceFault::unplugged:
      return "The device is unplugged: plug it in again.";
    case DeviceFault::motor_warm:
      return "The device's motors are too warm: let it rest for a minute.";
    case DeviceFault::non_finite_command:
      return "A force that is not a number was held back and zero force was sent: please report this trial's log.";
    case DeviceFault::servo_late:
      return "The servo loop is late: close other programs, and set up real-time priority.";
    case DeviceFault::not_calibrated:
      return "The device does not know where it stands: put its pen into the ink well, or move it once to its ends.";
    case DeviceFault::frozen:
      return "The trial is held: it goes on when it is let go.";
    case DeviceFault::driver_error:
      return "The device's driver reports an error: unplug it, wait five seconds, plug it in again.";
  }
  return "The device reports an unknown fault.";
}

}  // namespace vallecula::device
