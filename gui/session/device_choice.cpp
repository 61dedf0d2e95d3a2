#include "gui/session/device_choice.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "curricula/trial_log.h"
#include "device/drivers/mouse_device.h"
#include "device/drivers/recorded_device.h"
#include "device/drivers/scripted_device.h"
#include "device/factory.h"
#include "gui/session/operator_axes.h"
#include "gui/session/scripted_hands.h"

namespace vallecula::gui {

namespace {

/// Hands planned from the patient's landmarks: the only devices the factory cannot make, for it knows no patient.
constexpr std::array<const char*, 3> kScriptedHands = {"expert", "novice", "press"};
constexpr const char* kScripted = "scripted";
/// Nor does it know a trial's log.
constexpr const char* kRecorded = "recorded";
constexpr const char* kRecord = "TRIAL.vtrial";

struct DeviceName {
  std::string kind, argument;
  bool has_argument = false;
};

DeviceName split(const std::string& name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos) return {name, "", false};
  return {name.substr(0, colon), name.substr(colon + 1), true};
}

bool is_scripted_hand(const DeviceName& device) {
  return device.kind == kScripted &&
         std::find(kScriptedHands.begin(), kScriptedHands.end(), device.argument) != kScriptedHands.end();
}

/// Whether `given` has the form of `wanted`, the factory's word for an argument: "" nothing, "FILE.csv" that ending,
/// "[SERIAL]" nothing or something.
bool fits(const std::string& wanted, const DeviceName& given) {
  if (wanted.empty()) return !given.has_argument;
  if (wanted.front() == '[') return !given.has_argument || !given.argument.empty();
  const std::size_t dot = wanted.rfind('.');
  if (dot == std::string::npos) return !given.argument.empty();
  const std::string ending = wanted.substr(dot);
  return given.argument.size() > ending.size() &&
         given.argument.compare(given.argument.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

std::string device_names() {
  std::vector<std::string> names;
  for (const device::DeviceKind& kind : device::device_kinds()) {
    if (kind.kind == kScripted) {
      for (const char* hand : kScriptedHands) names.push_back(std::string(kScripted) + ":" + hand);
    }
    names.push_back(device::form_of(kind));
  }
  names.push_back(std::string(kRecorded) + ":" + kRecord);
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return list;
}

bool is_scripted(const std::string& name) {
  const std::string kind = split(name).kind;
  return kind == kScripted || kind == kRecorded;
}

void check_device_name(const std::string& name) {
  const DeviceName given = split(name);
  if (is_scripted_hand(given)) return;
  if (given.kind == kRecorded && given.has_argument) {
    std::error_code error;
    if (fits(kRecord, given) || std::filesystem::is_directory(given.argument, error)) return;
    throw UnknownDevice("device '" + name + "': no .vtrial file and no folder; take recorded:" + kRecord +
                        " or the folder of a trial");
  }
  for (const device::DeviceKind& kind : device::device_kinds()) {
    if (kind.kind == given.kind && fits(kind.argument, given)) return;
  }
  throw UnknownDevice("there is no device '" + name + "'; take " + device_names());
}

namespace {

std::unique_ptr<device::HapticDevice> recorded_hand(const std::string& file) {
  const curricula::TrialLog log = curricula::read_trial_log(file);
  std::vector<device::TimedReading> readings(log.ticks.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const curricula::LogTick& tick = log.ticks[i];
    readings[i] = {tick.time_s,
                   {tick.device_pose.position_m, tick.device_pose.rotation_wxyz, tick.buttons, tick.device_valid}};
  }
  return std::make_unique<device::RecordedDevice>(std::move(readings), log.header.device_limit_n);
}

}  // namespace

device::Keyframe starting_pose(const pipeline::PatientPackage& package, const curricula::Scenario& scenario) {
  const device::Trajectory expert = scripted_hand("expert", package, scenario);
  return expert.at(expert.start_s());
}

std::unique_ptr<device::GuardedDevice> guard_device(device::HapticDevice& device, const device::GuardSettings& settings,
                                                    const pipeline::PatientPackage& package,
                                                    const curricula::Scenario& scenario) {
  auto guard = std::make_unique<device::GuardedDevice>(device, settings);
  if (!device.info().own_axes) return guard;
  const OperatorAxes axes = operator_axes(package);
  guard->set_view_axes({axes.right.x(), axes.right.y(), axes.right.z()}, {axes.up.x(), axes.up.y(), axes.up.z()});
  const device::Keyframe start = starting_pose(package, scenario);
  guard->begin_at(start.position_m, start.rotation_wxyz);
  return guard;
}

std::unique_ptr<device::HapticDevice> make_device(const std::string& name, const pipeline::PatientPackage& package,
                                                  const curricula::Scenario& scenario) {
  check_device_name(name);
  const DeviceName given = split(name);
  if (is_scripted_hand(given)) {
    return std::make_unique<device::ScriptedDevice>(scripted_hand(given.argument, package, scenario),
                                                    device::firm_hand());
  }
  if (given.kind == kRecorded) return recorded_hand(given.argument);
  std::unique_ptr<device::HapticDevice> made = device::make_device(given.kind, given.argument);
  if (auto* mouse = dynamic_cast<device::MouseDevice*>(made.get())) {
    const device::Keyframe start = starting_pose(package, scenario);
    mouse->place(start.position_m, start.rotation_wxyz);
  }
  return made;
}

}  // namespace vallecula::gui
