#include "gui/session/device_choice.h"

#include <algorithm>
#include <array>

#include "device/drivers/mouse_device.h"
#include "device/drivers/scripted_device.h"
#include "gui/session/scripted_hands.h"

namespace vallecula::gui {

namespace {

constexpr std::array<const char*, 3> kScriptedHands = {"expert", "novice", "press"};

struct DeviceName {
  std::string kind, argument;
};

DeviceName split(const std::string& name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos) return {name, ""};
  return {name.substr(0, colon), name.substr(colon + 1)};
}

bool is_scripted_hand(const std::string& argument) {
  return std::find(kScriptedHands.begin(), kScriptedHands.end(), argument) != kScriptedHands.end();
}

bool is_csv(const std::string& argument) {
  const std::string ending = ".csv";
  return argument.size() > ending.size() &&
         argument.compare(argument.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

void check_device_name(const std::string& name) {
  const DeviceName device = split(name);
  const bool mouse = device.kind == "mouse" && device.argument.empty() && name == "mouse";
  const bool scripted = device.kind == "scripted" && (is_scripted_hand(device.argument) || is_csv(device.argument));
  if (mouse || scripted) return;
  throw UnknownDevice("there is no device '" + name +
                      "'; take mouse, scripted:expert, scripted:novice, scripted:press or scripted:FILE.csv");
}

std::unique_ptr<device::HapticDevice> make_device(const std::string& name, const pipeline::PatientPackage& package,
                                                  const curricula::Scenario& scenario) {
  check_device_name(name);
  const DeviceName device = split(name);
  if (device.kind == "mouse") {
    auto mouse = std::make_unique<device::MouseDevice>();
    // The person begins where the scripted expert does: in front of the mouth, blade ready.
    const device::Trajectory expert = scripted_hand("expert", package, scenario);
    const device::Keyframe start = expert.at(expert.start_s());
    mouse->place(start.position_m, start.rotation_wxyz);
    return mouse;
  }
  // A script cannot look and correct itself as a person does, so its hand is firm: 1 N moves it by a third of a
  // millimetre (assumed).
  device::HandSettings hand;
  hand.stiffness_n_m = 3000.0;
  if (is_csv(device.argument)) {
    return std::make_unique<device::ScriptedDevice>(device::Trajectory(device::read_trajectory_csv(device.argument)),
                                                    hand);
  }
  return std::make_unique<device::ScriptedDevice>(scripted_hand(device.argument, package, scenario), hand);
}

}  // namespace vallecula::gui
