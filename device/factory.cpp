#include "device/factory.h"

#include "device/drivers/falcon/falcon_device.h"
#include "device/drivers/hdapi/hd_device.h"
#include "device/drivers/mouse_device.h"
#include "device/drivers/scripted_device.h"
#include "device/drivers/spacemouse/spacemouse_device.h"

namespace vallecula::device {

std::vector<DeviceKind> device_kinds() {
  return {
      {"mouse", "", "mouse and keyboard; the force is drawn, not felt"},
      {"touch", "[NAME]", "3D Systems Touch, Touch X and other HDAPI devices; NAME as their set-up calls it", true},
      {"falcon", "[FIRMWARE.bin]", "a Novint Falcon: position and force; its grip does not turn the blade", true},
      {"spacemouse", "[SERIAL]", "a SpaceMouse: the cap steers by speed; the force is drawn, not felt", true},
      {"scripted", "FILE.csv", "a hand that follows a trajectory t,x,y,z[,qw,qx,qy,qz] (s, m), with faults by time"}};
}

std::string form_of(const DeviceKind& kind) {
  if (kind.argument.empty()) return kind.kind;
  return kind.argument.front() == '[' ? kind.kind + "[:" + kind.argument.substr(1) : kind.kind + ":" + kind.argument;
}

std::unique_ptr<HapticDevice> make_device(const std::string& kind, const std::string& argument) {
  if (kind == "mouse") {
    if (!argument.empty()) throw DeviceError("device mouse: takes no argument, but '" + argument + "' was given");
    return std::make_unique<MouseDevice>();
  }
  if (kind == "spacemouse") return std::make_unique<SpaceMouseDevice>(argument);
  if (kind == "scripted") {
    if (argument.empty()) throw DeviceError("device scripted: needs a trajectory file; write scripted:FILE.csv");
    HandScript script = read_hand_script(argument);
    return std::make_unique<ScriptedDevice>(Trajectory(std::move(script.keyframes)), script.hand,
                                            std::move(script.faults));
  }
  if (kind == "touch") return std::make_unique<hdapi::HdDevice>(argument);
  if (kind == "falcon") return std::make_unique<FalconDevice>(argument);
  std::string known;
  for (const DeviceKind& k : device_kinds()) known += (known.empty() ? "" : ", ") + form_of(k);
  throw DeviceError("device '" + kind + "': no such kind; there are " + known);
}

}  // namespace vallecula::device
