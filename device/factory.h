// Devices by name.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "device/haptic_device.h"
#include "device/trajectory.h"

namespace vallecula::device {

struct DeviceKind {
  std::string kind;      ///< "mouse"
  std::string argument;  ///< what must follow the colon, [in brackets] what may; empty: nothing
  std::string description;
  bool hardware = false;  ///< can be made only where such a device is plugged in
};

/// As a person writes it: "mouse", "scripted:FILE.csv", "spacemouse[:SERIAL]".
std::string form_of(const DeviceKind& kind);

/// Every kind make_device() knows.
std::vector<DeviceKind> device_kinds();

/// Makes a device of `kind` with `argument` (the text after the colon of KIND[:ARG]). "scripted" takes a trajectory
/// file (read_hand_script); hands with other settings are made as ScriptedDevice. Throws DeviceError
/// naming the kinds there are, or what is wrong with the argument.
std::unique_ptr<HapticDevice> make_device(const std::string& kind, const std::string& argument);

}  // namespace vallecula::device
