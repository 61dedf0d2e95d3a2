#include "gui/session/fault_report.h"

#include <cstdio>

namespace vallecula::gui {

namespace {

void append(std::string& row, const engine::Vec3& v) {
  for (const double value : {v.x(), v.y(), v.z()}) {
    char text[40];
    std::snprintf(text, sizeof text, ",%.9g", value);
    row += text;
  }
}

void append(std::string& row, const engine::Pose& pose) {
  append(row, pose.position);
  append(row, pose.rotation.vec());
  char text[40];
  std::snprintf(text, sizeof text, ",%.9g", pose.rotation.w());
  row += text;
}

const char* name_of(engine::HapticState state) {
  switch (state) {
    case engine::HapticState::tracking:
      return "tracking";
    case engine::HapticState::limited:
      return "limited";
    case engine::HapticState::lost:
      return "lost";
    case engine::HapticState::recovering:
      break;
  }
  return "recovering";
}

std::string names_of(std::uint32_t faults) {
  std::string names;
  for (const auto& [bit, name] : {std::pair{engine::kFaultDeviceInvalid, "device_unusable"},
                                  {engine::kFaultDevicePose, "device_pose"},
                                  {engine::kFaultTissue, "tissue"},
                                  {engine::kFaultForce, "force"},
                                  {engine::kFaultOverrun, "step_late"}})
    if ((faults & bit) != 0) names += (names.empty() ? "" : " ") + std::string(name);
  return names;
}

}  // namespace

std::string fault_words(std::uint32_t faults) {
  if ((faults & engine::kFaultDevicePose) != 0)
    return "the device sent a pose that is no position and rotation; no force was shown";
  if ((faults & engine::kFaultTissue) != 0)
    return "the tissue's motion was no longer finite; it was put back to rest and no force was shown";
  if ((faults & engine::kFaultForce) != 0) return "a force was not finite; none was shown";
  return "";
}

std::string fault_sentence(const std::vector<engine::TickRecord>& ticks, const std::string& file_name) {
  char when[40];
  std::snprintf(when, sizeof when, "%.3f s", ticks.back().time_s);
  return "at " + std::string(when) + " " + fault_words(ticks.back().faults) + " (the " + std::to_string(ticks.size()) +
         " ticks up to it are in " + file_name + ")";
}

std::string pause_words(device::GuardState state, device::DeviceFault fault, bool recorded) {
  if (state == device::GuardState::paused && recorded)
    return "The recorded hand was paused here; it goes on by itself.";
  if (state == device::GuardState::paused) return device::describe(fault);
  if (state == device::GuardState::confirming && fault == device::DeviceFault::frozen)
    return "The trial is let go. To go on press Enter or a button of the device, or hold the grey blade on the steel "
           "one for half a second.";
  if (state == device::GuardState::confirming)
    return "The device is back. To go on press Enter or a button of the device, or hold the grey blade on the steel "
           "one for half a second.";
  return "";
}

std::string fault_csv(const std::vector<engine::TickRecord>& ticks) {
  std::string out =
      "tick,time_s,faults,state,device_valid,step_fed,step_used,device_x_m,device_y_m,device_z_m,device_qx,device_qy,"
      "device_qz,"
      "device_qw,proxy_x_m,proxy_y_m,proxy_z_m,proxy_qx,proxy_qy,proxy_qz,proxy_qw,model_x_n,model_y_n,model_z_n,model_"
      "x_nm,"
      "model_y_nm,model_z_nm,displayed_x_n,displayed_y_n,displayed_z_n\n";
  for (const engine::TickRecord& tick : ticks) {
    char text[80];
    std::snprintf(text, sizeof text, "%lld,%.6f,", static_cast<long long>(tick.tick), tick.time_s);
    std::string row = text + names_of(tick.faults) + "," + name_of(tick.state) + (tick.device_valid ? ",1," : ",0,") +
                      std::to_string(tick.step_fed) + "," + std::to_string(tick.step_used);
    append(row, tick.device_pose);
    append(row, tick.proxy_pose);
    append(row, tick.model_force_n);
    append(row, tick.model_torque_nm);
    append(row, tick.displayed_force_n);
    out += row + "\n";
  }
  return out;
}

}  // namespace vallecula::gui
