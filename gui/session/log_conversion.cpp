#include "gui/session/log_conversion.h"

#include <cstring>

namespace vallecula::gui {

using curricula::LoggedState;
using curricula::LogTick;
using engine::HapticState;
using engine::Structure;

static_assert(static_cast<int>(HapticState::tracking) == static_cast<int>(LoggedState::tracking) &&
                  static_cast<int>(HapticState::limited) == static_cast<int>(LoggedState::limited) &&
                  static_cast<int>(HapticState::lost) == static_cast<int>(LoggedState::lost) &&
                  static_cast<int>(HapticState::recovering) == static_cast<int>(LoggedState::recovering),
              "the log and the engine number the states alike");
static_assert(static_cast<int>(Structure::tongue) == curricula::kTongue &&
                  static_cast<int>(Structure::epiglottis) == curricula::kEpiglottis &&
                  static_cast<int>(Structure::gum) == curricula::kGum &&
                  static_cast<int>(Structure::palate) == curricula::kPalate &&
                  static_cast<int>(Structure::teeth) == curricula::kTeeth &&
                  static_cast<int>(Structure::larynx) == curricula::kLarynx &&
                  engine::kLoadedStructures == static_cast<int>(curricula::kStructures),
              "the log and the engine number the structures alike");

namespace {

std::array<double, 3> array_of(const engine::Vec3& v) { return {v.x(), v.y(), v.z()}; }
engine::Vec3 vector_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

curricula::LogPose log_pose(const engine::Pose& pose) {
  return {array_of(pose.position), {pose.rotation.w(), pose.rotation.x(), pose.rotation.y(), pose.rotation.z()}};
}

engine::Pose engine_pose(const curricula::LogPose& pose) {
  const auto& q = pose.rotation_wxyz;
  return {vector_of(pose.position_m), engine::Quat(q[0], q[1], q[2], q[3])};
}

/// Compares field by field in the order of LogTick and keeps the first that differs.
class Comparison {
 public:
  void field(const std::string& name, double recorded, double recomputed) {
    // Bits, not values: 0 and -0 part ways later, and NaN must equal itself.
    if (result_.field.empty() && std::memcmp(&recorded, &recomputed, sizeof recorded) != 0) {
      result_ = {name, recorded, recomputed};
    }
  }
  template <std::size_t n>
  void field(const std::string& name, const std::array<double, n>& recorded, const std::array<double, n>& recomputed) {
    if (std::memcmp(recorded.data(), recomputed.data(), sizeof recorded) == 0) return;
    for (std::size_t i = 0; i < n; ++i) field(name + "[" + std::to_string(i) + "]", recorded[i], recomputed[i]);
  }
  void field(const std::string& name, const curricula::LogPose& recorded, const curricula::LogPose& recomputed) {
    field(name + ".position_m", recorded.position_m, recomputed.position_m);
    field(name + ".rotation_wxyz", recorded.rotation_wxyz, recomputed.rotation_wxyz);
  }
  const Difference& result() const { return result_; }

 private:
  Difference result_;
};

}  // namespace

LogTick to_log(const engine::TickRecord& record) {
  LogTick tick;
  tick.tick = record.tick;
  tick.time_s = record.time_s;
  tick.device_pose = log_pose(record.device_pose);
  tick.buttons = record.buttons;
  tick.device_valid = record.device_valid;
  tick.step_fed = record.step_fed;
  tick.step_used = record.step_used;
  tick.proxy_pose = log_pose(record.proxy_pose);
  tick.state = static_cast<LoggedState>(record.state);
  tick.model_force_n = array_of(record.model_force_n);
  tick.model_torque_nm = array_of(record.model_torque_nm);
  tick.displayed_force_n = array_of(record.displayed_force_n);
  for (int i = 0; i < engine::kLoadedStructures; ++i) {
    const engine::StructureLoad& load = record.loads[i];
    tick.loads[i] = {array_of(load.force_n), array_of(load.centre_m), load.contacts};
  }
  tick.has_sight = record.has_sight;
  tick.glottis_visible = record.glottis_visible;
  tick.faults = record.faults;
  return tick;
}

engine::TickRecord from_log(const LogTick& tick) {
  engine::TickRecord record;
  record.tick = tick.tick;
  record.time_s = tick.time_s;
  record.device_pose = engine_pose(tick.device_pose);
  record.buttons = tick.buttons;
  record.device_valid = tick.device_valid;
  record.step_fed = tick.step_fed;
  record.step_used = tick.step_used;
  record.proxy_pose = engine_pose(tick.proxy_pose);
  record.state = static_cast<HapticState>(tick.state);
  record.model_force_n = vector_of(tick.model_force_n);
  record.model_torque_nm = vector_of(tick.model_torque_nm);
  record.displayed_force_n = vector_of(tick.displayed_force_n);
  for (int i = 0; i < engine::kLoadedStructures; ++i) {
    const curricula::LogLoad& load = tick.loads[i];
    record.loads[i] = {vector_of(load.force_n), vector_of(load.centre_m), load.contacts};
  }
  record.has_sight = tick.has_sight;
  record.glottis_visible = tick.glottis_visible;
  record.faults = tick.faults;
  return record;
}

std::map<std::string, double> settings_of(const engine::SceneDescription& description) {
  const engine::HapticSettings& haptics = description.haptics;
  return {{"device_limit_n", haptics.device_limit_n},
          {"coupling_stiffness_n_m", haptics.coupling_stiffness_n_m},
          {"coupling_rotation_nm_rad", haptics.coupling_rotation_nm_rad},
          {"limit_time_s", haptics.limit_time_s},
          {"force_rate_n_s", haptics.force_rate_n_s},
          {"tool_mass_kg", description.tool.mass_kg},
          {"response", static_cast<double>(description.response)},
          {"coverage", static_cast<double>(description.coverage)},
          {"collision", static_cast<double>(description.collision)},
          {"friction", description.friction},
          {"sphere_ratio", description.sphere_ratio},
          {"sphere_levels", static_cast<double>(description.sphere_levels)},
          {"step_s", description.step_s}};
}

std::map<std::string, double> settings_of(const device::GuardSettings& guard) {
  const device::OutputLimits& limits = guard.limits;
  return {{"device_force_scale", limits.force_scale},
          {"device_motion_scale", guard.map.motion_scale},
          {"device_peak_force_n", limits.peak_force_n},
          {"device_continuous_force_n", limits.continuous_force_n},
          {"device_thermal_time_s", limits.thermal_time_s},
          {"device_soft_start_s", limits.soft_start_s},
          {"device_force_rate_n_s", limits.rate_n_s},
          {"device_cutoff_hz", limits.cutoff_hz}};
}

Difference first_difference(const LogTick& recorded, const LogTick& recomputed) {
  static constexpr std::array<const char*, curricula::kStructures> kNames = {"tongue", "epiglottis", "gum",
                                                                             "palate", "teeth",      "larynx"};
  Comparison compare;
  const auto count = [](auto value) { return static_cast<double>(value); };
  compare.field("tick", count(recorded.tick), count(recomputed.tick));
  compare.field("time_s", recorded.time_s, recomputed.time_s);
  compare.field("device_pose", recorded.device_pose, recomputed.device_pose);
  compare.field("buttons", count(recorded.buttons), count(recomputed.buttons));
  compare.field("device_valid", count(recorded.device_valid), count(recomputed.device_valid));
  compare.field("step_fed", count(recorded.step_fed), count(recomputed.step_fed));
  compare.field("step_used", count(recorded.step_used), count(recomputed.step_used));
  compare.field("proxy_pose", recorded.proxy_pose, recomputed.proxy_pose);
  compare.field("state", count(recorded.state), count(recomputed.state));
  compare.field("model_force_n", recorded.model_force_n, recomputed.model_force_n);
  compare.field("model_torque_nm", recorded.model_torque_nm, recomputed.model_torque_nm);
  compare.field("displayed_force_n", recorded.displayed_force_n, recomputed.displayed_force_n);
  for (int i = 0; i < curricula::kStructures; ++i) {
    const std::string name = std::string("loads.") + kNames[i];
    compare.field(name + ".force_n", recorded.loads[i].force_n, recomputed.loads[i].force_n);
    compare.field(name + ".centre_m", recorded.loads[i].centre_m, recomputed.loads[i].centre_m);
    compare.field(name + ".contacts", count(recorded.loads[i].contacts), count(recomputed.loads[i].contacts));
  }
  compare.field("has_sight", count(recorded.has_sight), count(recomputed.has_sight));
  compare.field("glottis_visible", recorded.glottis_visible, recomputed.glottis_visible);
  compare.field("faults", count(recorded.faults), count(recomputed.faults));
  return compare.result();
}

}  // namespace vallecula::gui
