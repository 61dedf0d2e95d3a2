// What is plugged in, as a person is told: one list over all drivers.
#pragma once

#include <string>
#include <vector>

#include "device/haptic_device.h"

namespace vallecula::device {

struct FoundDevice {
  std::string name;  ///< KIND[:ARG] as make_device() takes it; empty: cannot be made as things are
  DeviceInfo info;
  bool figures_known = true;  ///< false: it was not opened; rate, forces, workspace and calibration are not known
  Calibration calibration = Calibration::not_needed;
  std::string problem;  ///< why it cannot be used, or (with a name) what it lacks; empty: nothing
  std::string mend;     ///< what to do about it, or about its calibration
};

/// Always there.
FoundDevice found_mouse();

/// Every device that is plugged in, and every driver that is missing something (with what and where it looked) or sees
/// none of its devices; the mouse is always there. Opens nothing that another program may be using for longer than it
/// takes to ask. May take a second; never throws for a device's sake.
std::vector<FoundDevice> find_devices();

}  // namespace vallecula::device
