#include "device/factory.h"

#include "device/drivers/mouse_device.h"
#include "device/drivers/scripted_device.h"

namespace vallecula::device {

std::vector<DeviceKind> device_kinds() {
  return {
      {"mouse", "", "mouse and keyboard; the force is drawn, not felt"},
      {"scripted", "FILE.csv", "a hand that follows a trajectory t,x,y,z[,qw,qx,qy,qz] (s, m), with faults by time"}};
}

std::unique_ptr<HapticDevice> make_device(const std::string& kind, const std::string& argument) {
  if (kind == "mouse") {
    if (!argument.empty()) throw DeviceError("device mouse: takes no argument, but '" + argument + "' was given");
    return std::make_unique<MouseDevice>();
  }
  if (kind == "scripted") {
    if (argument.empty()) throw DeviceError("device scripted: needs a trajectory file; write scripted:FILE.csv");
    HandScript script = read_hand_script(argument);
    return std::make_unique<ScriptedDevice>(Trajectory(std::move(script.keyframes)), script.hand,
                                            std::move(script.faults));
  }
  std::string known;
  for (const DeviceKind& k : device_kinds()) {
    known += (known.empty() ? "" : ", ") + k.kind + (k.argument.empty() ? "" : ":" + k.argument);
  }
  throw DeviceError("device '" + kind + "': no such kind; there are " + known);
}

}  // namespace vallecula::device
