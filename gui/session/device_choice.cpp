#include "gui/session/device_choice.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "curricula/trial_log.h"
#include "device/drivers/hand_pair.h"
#include "device/drivers/mouse_device.h"
#include "device/drivers/recorded_device.h"
#include "device/drivers/scripted_device.h"
#include "device/factory.h"
#include "engine/tube/intubation_record.h"
#include "gui/session/operator_axes.h"
#include "gui/session/scripted_hands.h"
#include "gui/session/scripted_pairs.h"

namespace vallecula::gui {

namespace {

// The hands planned from the patient's landmarks are the only devices the factory cannot make, for it knows no patient.
// The expert is a pair where the scenario has a tube; the pairs but for it need one.
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

template <class Names>
bool among(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_scripted_pair(const DeviceName& device) {
  return device.kind == kScripted && among(kScriptedPairs, device.argument);
}

bool is_scripted_hand(const DeviceName& device) {
  return is_scripted_pair(device) || (device.kind == kScripted && among(kScriptedHands, device.argument));
}

bool is_pair_file(const DeviceName& device) {
  return device.kind == kScripted && !is_scripted_hand(device) && device::is_hand_pair(device.argument);
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
      for (const char* pair : kScriptedPairs)
        if (!among(kScriptedHands, pair)) names.push_back(std::string(kScripted) + ":" + pair);
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

bool answers_distractions(const std::string& name) { return is_scripted_pair(split(name)); }

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

void check_second_name(const std::string& name) {
  if (!name.empty() && name != kSameDevice) check_device_name(name);
}

namespace {

/// The blade's hand of a trial, or the tube's; none where it had no tube.
std::unique_ptr<device::HapticDevice> recorded_hand(const curricula::TrialLog& log, bool second) {
  if (second && !log.header.has_intubation) return nullptr;
  std::vector<device::TimedReading> readings(log.ticks.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const curricula::LogTick& tick = log.ticks[i];
    const curricula::LogPose& pose = second ? tick.intubation.hand_pose : tick.device_pose;
    const bool valid = second ? tick.intubation.hand_valid : tick.device_valid;
    readings[i] = {tick.time_s, {pose.position_m, pose.rotation_wxyz, second ? 0 : tick.buttons, valid}};
  }
  double limit_n = log.header.device_limit_n;
  if (second) limit_n = log.header.settings.at("second_device_limit_n");
  return std::make_unique<device::RecordedDevice>(std::move(readings), limit_n);
}

device::ActionPlan actions_in(const curricula::TrialLog& log) {
  std::vector<device::TimedActions> changes;
  for (const curricula::LogTick& tick : log.ticks) {
    const std::uint32_t asked = tick.buttons & engine::kAllActions;
    if (changes.empty() || changes.back().bits != asked) changes.push_back({tick.time_s, asked});
  }
  return device::ActionPlan(std::move(changes));
}

SecondHand recorded_second(const std::string& file) {
  const curricula::TrialLog log = curricula::read_trial_log(file);
  SecondHand hand{recorded_hand(log, true), {}};
  if (hand.device) hand.actions = actions_in(log);
  return hand;
}

std::unique_ptr<device::HapticDevice> scripted(const device::HandScript& script) {
  return std::make_unique<device::ScriptedDevice>(device::Trajectory(script.keyframes), script.hand, script.faults);
}

std::unique_ptr<device::HapticDevice> scripted(device::Trajectory trajectory) {
  return std::make_unique<device::ScriptedDevice>(std::move(trajectory), device::firm_hand());
}

std::unique_ptr<device::HapticDevice> from_factory(const DeviceName& name, const device::Keyframe& start) {
  std::unique_ptr<device::HapticDevice> made = device::make_device(name.kind, name.argument);
  if (auto* mouse = dynamic_cast<device::MouseDevice*>(made.get())) mouse->place(start.position_m, start.rotation_wxyz);
  return made;
}

[[noreturn]] void refuse_pair(const std::string& name, const curricula::Scenario& scenario) {
  throw std::runtime_error("device '" + name + "' is a pair of hands, and scenario '" + scenario.id +
                           "' has no tube for the second; choose a scenario with an intubation");
}

}  // namespace

device::Keyframe starting_pose(const pipeline::PatientPackage& package, const curricula::Scenario& scenario) {
  const device::Trajectory expert = scripted_hand("expert", package, scenario);
  return expert.at(expert.start_s());
}

device::Keyframe starting_tube_pose(const pipeline::PatientPackage& package,
                                    const engine::IntubationDescription& intubation) {
  const device::Trajectory expert = scripted_pair("expert", package, {}, intubation).tube;
  return expert.at(expert.start_s());
}

std::unique_ptr<device::GuardedDevice> guard_device(device::HapticDevice& device, const device::GuardSettings& settings,
                                                    const pipeline::PatientPackage& package,
                                                    const device::Keyframe& start) {
  auto guard = std::make_unique<device::GuardedDevice>(device, settings);
  if (!device.info().own_axes) return guard;
  const OperatorAxes axes = operator_axes(package);
  guard->set_view_axes({axes.right.x(), axes.right.y(), axes.right.z()}, {axes.up.x(), axes.up.y(), axes.up.z()});
  guard->begin_at(start.position_m, start.rotation_wxyz);
  return guard;
}

std::unique_ptr<device::HapticDevice> make_device(const std::string& name, const PlannedOn& planned) {
  check_device_name(name);
  const DeviceName given = split(name);
  const auto& [package, scenario, intubation] = planned;
  if (intubation != nullptr && is_scripted_pair(given))
    return scripted(scripted_pair(given.argument, package, scenario, *intubation).blade);
  if (is_scripted_hand(given)) {
    if (!among(kScriptedHands, given.argument)) refuse_pair(name, scenario);
    return scripted(scripted_hand(given.argument, package, scenario));
  }
  if (is_pair_file(given)) {
    if (intubation == nullptr) refuse_pair(name, scenario);
    return scripted(device::read_hand_pair(given.argument).blade);
  }
  if (given.kind == kRecorded) return recorded_hand(curricula::read_trial_log(given.argument), false);
  return from_factory(given, starting_pose(package, scenario));
}

device::ActionPlan recorded_actions(const std::string& name) {
  const DeviceName given = split(name);
  return given.kind == kRecorded ? actions_in(curricula::read_trial_log(given.argument)) : device::ActionPlan();
}

SecondHand make_second_hand(const std::string& name, const std::string& first, const PlannedOn& planned) {
  check_second_name(name);
  if (name == kSameDevice) return {};
  const DeviceName given = split(name.empty() ? first : name);
  const auto& [package, scenario, intubation] = planned;
  if (is_scripted_pair(given)) {
    ScriptedPair pair = scripted_pair(given.argument, package, scenario, *intubation);
    return {scripted(std::move(pair.tube)), std::move(pair.actions)};
  }
  if (is_pair_file(given)) {
    device::HandPair pair = device::read_hand_pair(given.argument);
    return {scripted(pair.tube), std::move(pair.actions)};
  }
  if (given.kind == kRecorded) {
    SecondHand hand = recorded_second(given.argument);
    if (!hand.device && !name.empty())
      throw std::runtime_error("device '" + name + "': that trial had no second hand; take one of a trial with a tube");
    return hand;
  }
  if (name.empty()) return {};
  if (is_scripted_hand(given))
    throw UnknownDevice("device '" + name + "' holds a blade; take a pair's name, a file or another device");
  return {from_factory(given, starting_tube_pose(package, *intubation)), {}};
}

}  // namespace vallecula::gui
