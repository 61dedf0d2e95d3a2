#include "gui/session/log_conversion.h"

#include <cstring>

namespace vallecula::gui {

using curricula::LoggedInHand;
using curricula::LoggedPlace;
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
static_assert(static_cast<int>(engine::InHand::tube_with_stylet) == static_cast<int>(LoggedInHand::tube_with_stylet) &&
                  static_cast<int>(engine::InHand::tube) == static_cast<int>(LoggedInHand::tube) &&
                  static_cast<int>(engine::InHand::catheter) == static_cast<int>(LoggedInHand::catheter),
              "the log and the engine number alike what is in the hand");
static_assert(static_cast<int>(engine::TipPlace::outside) == static_cast<int>(LoggedPlace::outside) &&
                  static_cast<int>(engine::TipPlace::mouth) == static_cast<int>(LoggedPlace::mouth) &&
                  static_cast<int>(engine::TipPlace::larynx) == static_cast<int>(LoggedPlace::larynx) &&
                  static_cast<int>(engine::TipPlace::trachea) == static_cast<int>(LoggedPlace::trachea) &&
                  static_cast<int>(engine::TipPlace::main_bronchus) == static_cast<int>(LoggedPlace::main_bronchus) &&
                  static_cast<int>(engine::TipPlace::oesophagus) == static_cast<int>(LoggedPlace::oesophagus),
              "the log and the engine number the places alike");
static_assert(static_cast<int>(engine::AirwayPart::vestibule) == curricula::kTubeVestibule &&
                  static_cast<int>(engine::AirwayPart::cords) == curricula::kTubeCords &&
                  static_cast<int>(engine::AirwayPart::subglottis) == curricula::kTubeSubglottis &&
                  static_cast<int>(engine::AirwayPart::cricoid) == curricula::kTubeCricoid &&
                  static_cast<int>(engine::AirwayPart::trachea) == curricula::kTubeTrachea &&
                  static_cast<int>(engine::AirwayPart::main_bronchus) == curricula::kTubeBronchus &&
                  static_cast<int>(engine::AirwayPart::oesophagus) == curricula::kTubeOesophagus &&
                  static_cast<int>(engine::kLoadPharynx) == curricula::kTubePharynx &&
                  static_cast<int>(engine::kLoadTongue) == curricula::kTubeTongue &&
                  static_cast<int>(engine::kLoadEpiglottis) == curricula::kTubeEpiglottis &&
                  static_cast<int>(engine::kLoadBlade) == curricula::kTubeBlade &&
                  static_cast<int>(engine::kTubeLoads) == static_cast<int>(curricula::kTubeLoads),
              "the log and the engine number the tube's loads alike");

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

curricula::LogIntubation log_intubation(const engine::IntubationRecord& record) {
  curricula::LogIntubation i;
  i.hand_pose = log_pose(record.hand_pose);
  i.hand_valid = record.hand_valid;
  i.in_hand = static_cast<LoggedInHand>(record.in_hand);
  i.tip_m = array_of(record.tip_m);
  i.tip_direction = array_of(record.tip_direction);
  i.place = static_cast<LoggedPlace>(record.place);
  i.side = record.side;
  i.past_cords_m = record.past_cords_m;
  i.at_mouth_m = record.at_mouth_m;
  i.buckled_m = record.buckled_m;
  i.model_force_n = array_of(record.model_force_n);
  i.displayed_force_n = array_of(record.displayed_force_n);
  i.loads_n = record.loads_n;
  i.tip_load_n = record.tip_load_n;
  i.tip_against = record.tip_against;
  i.glottis_opening = record.glottis_opening;
  i.spasm = record.spasm;
  i.secretions_ml = record.secretions_ml;
  i.sao2 = record.sao2;
  i.spo2 = record.spo2;
  i.heart_per_min = record.heart_per_min;
  i.detector_yellow = record.detector_yellow;
  i.breaths_given = record.breaths_given;
  i.given_per_min = record.given_per_min;
  i.faults = record.faults;
  return i;
}

engine::IntubationRecord engine_intubation(const curricula::LogIntubation& i) {
  engine::IntubationRecord record;
  record.hand_pose = engine_pose(i.hand_pose);
  record.hand_valid = i.hand_valid;
  record.in_hand = static_cast<engine::InHand>(i.in_hand);
  record.tip_m = vector_of(i.tip_m);
  record.tip_direction = vector_of(i.tip_direction);
  record.place = static_cast<engine::TipPlace>(i.place);
  record.side = i.side;
  record.past_cords_m = i.past_cords_m;
  record.at_mouth_m = i.at_mouth_m;
  record.buckled_m = i.buckled_m;
  record.model_force_n = vector_of(i.model_force_n);
  record.displayed_force_n = vector_of(i.displayed_force_n);
  record.loads_n = i.loads_n;
  record.tip_load_n = i.tip_load_n;
  record.tip_against = i.tip_against;
  record.glottis_opening = i.glottis_opening;
  record.spasm = i.spasm;
  record.secretions_ml = i.secretions_ml;
  record.sao2 = i.sao2;
  record.spo2 = i.spo2;
  record.heart_per_min = i.heart_per_min;
  record.detector_yellow = i.detector_yellow;
  record.breaths_given = i.breaths_given;
  record.given_per_min = i.given_per_min;
  record.faults = i.faults;
  return record;
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
  void field(const std::string& name, const curricula::LogIntubation& recorded,
             const curricula::LogIntubation& recomputed) {
    const auto each = [&](const char* part, auto a, auto b) {
      field(name + part, static_cast<double>(a), static_cast<double>(b));
    };
    field(name + ".hand_pose", recorded.hand_pose, recomputed.hand_pose);
    each(".hand_valid", recorded.hand_valid, recomputed.hand_valid);
    each(".in_hand", recorded.in_hand, recomputed.in_hand);
    field(name + ".tip_m", recorded.tip_m, recomputed.tip_m);
    field(name + ".tip_direction", recorded.tip_direction, recomputed.tip_direction);
    each(".place", recorded.place, recomputed.place);
    each(".side", recorded.side, recomputed.side);
    each(".past_cords_m", recorded.past_cords_m, recomputed.past_cords_m);
    each(".at_mouth_m", recorded.at_mouth_m, recomputed.at_mouth_m);
    each(".buckled_m", recorded.buckled_m, recomputed.buckled_m);
    field(name + ".model_force_n", recorded.model_force_n, recomputed.model_force_n);
    field(name + ".displayed_force_n", recorded.displayed_force_n, recomputed.displayed_force_n);
    field(name + ".loads_n", recorded.loads_n, recomputed.loads_n);
    each(".tip_load_n", recorded.tip_load_n, recomputed.tip_load_n);
    each(".tip_against", recorded.tip_against, recomputed.tip_against);
    each(".glottis_opening", recorded.glottis_opening, recomputed.glottis_opening);
    each(".spasm", recorded.spasm, recomputed.spasm);
    each(".secretions_ml", recorded.secretions_ml, recomputed.secretions_ml);
    each(".sao2", recorded.sao2, recomputed.sao2);
    each(".spo2", recorded.spo2, recomputed.spo2);
    each(".heart_per_min", recorded.heart_per_min, recomputed.heart_per_min);
    each(".detector_yellow", recorded.detector_yellow, recomputed.detector_yellow);
    each(".breaths_given", recorded.breaths_given, recomputed.breaths_given);
    each(".given_per_min", recorded.given_per_min, recomputed.given_per_min);
    each(".faults", recorded.faults, recomputed.faults);
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
    tick.loads[i] = {array_of(load.force_n), array_of(load.centre_m), load.contacts, load.area_m2};
  }
  tick.has_areas = true;
  tick.has_sight = record.has_sight;
  tick.glottis_visible = record.glottis_visible;
  tick.faults = record.faults;
  tick.has_intubation = record.has_intubation;
  if (record.has_intubation) tick.intubation = log_intubation(record.intubation);
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
    record.loads[i] = {vector_of(load.force_n), vector_of(load.centre_m), load.contacts, load.area_m2};
  }
  record.has_sight = tick.has_sight;
  record.glottis_visible = tick.glottis_visible;
  record.faults = tick.faults;
  record.has_intubation = tick.has_intubation;
  if (tick.has_intubation) record.intubation = engine_intubation(tick.intubation);
  return record;
}

std::map<std::string, double> settings_of(const engine::IntubationDescription& intubation) {
  const engine::TubeDesign& tube = intubation.tube;
  const engine::Stylet none{};
  const engine::Stylet& stylet = intubation.stylet ? *intubation.stylet : none;
  const engine::Glottis& glottis = intubation.glottis;
  const engine::InfantDescription& infant = intubation.infant;
  return {{"tube_inner_diameter_m", tube.inner_diameter},
          {"tube_outer_diameter_m", tube.outer_diameter},
          {"tube_length_m", tube.length},
          {"tube_cord_mark_m", tube.cord_mark_from_tip},
          {"tube_bend_radius_m", tube.bend_radius},
          {"tube_young_pa", tube.young_pa},
          {"stylet_diameter_m", intubation.stylet ? stylet.diameter : 0.0},
          {"stylet_bend_from_tip_m", intubation.stylet ? stylet.bend_from_tip : 0.0},
          {"stylet_bend_rad", intubation.stylet ? stylet.bend_rad : 0.0},
          {"catheter_outer_m", intubation.catheter_outer_m},
          {curricula::kCordsToCarina, cords_to_carina_m(intubation.course)},
          {"glottis_length_m", glottis.length_m},
          {"glottis_closure_s", glottis.closure_s},
          {"glottis_spasm_s", glottis.spasm_s},
          {"infant_weight_kg", infant.weight_kg},
          {"infant_gestation_weeks", infant.gestation_weeks},
          {"infant_seed", static_cast<double>(infant.seed)},
          {"infant_added_oxygen", infant.added_oxygen},
          {"infant_course", static_cast<double>(infant.course)},
          {"infant_breathes", intubation.breathes ? 1.0 : 0.0},
          {"secretions_m3", intubation.secretions.volume_m3},
          {"laryngeal_pressure_n", intubation.press_n},
          {"second_device_limit_n", intubation.device_limit_n}};
}

std::map<std::string, double> settings_of(const engine::SceneDescription& description) {
  const engine::HapticSettings& haptics = description.haptics;
  std::map<std::string, double> settings = {{"device_limit_n", haptics.device_limit_n},
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
  if (description.intubation) settings.merge(settings_of(*description.intubation));
  return settings;
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
    if (recorded.has_areas) compare.field(name + ".area_m2", recorded.loads[i].area_m2, recomputed.loads[i].area_m2);
  }
  compare.field("has_sight", count(recorded.has_sight), count(recomputed.has_sight));
  compare.field("glottis_visible", recorded.glottis_visible, recomputed.glottis_visible);
  compare.field("faults", count(recorded.faults), count(recomputed.faults));
  compare.field("has_intubation", count(recorded.has_intubation), count(recomputed.has_intubation));
  if (recorded.has_intubation) compare.field("intubation", recorded.intubation, recomputed.intubation);
  return compare.result();
}

}  // namespace vallecula::gui
