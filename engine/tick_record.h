// One servo tick as plain numbers: what the recorder writes to the trial log and `replay --verify` recomputes.
#pragma once

#include "engine/tube/intubation_record.h"
#include "engine/types.h"

namespace vallecula::engine {

/// Load on one kind of structure: the force the tool receives from it (N, world), where (force-weighted centre of
/// the contacts, m, world; zero when nothing touches), by how many contacts and, of soft tissue, over which area of its
/// surface at rest (contact/contact_area.h; 0: nothing touches, or not known, as of rigid anatomy).
struct StructureLoad {
  Vec3 force_n = Vec3::Zero();
  Vec3 centre_m = Vec3::Zero();
  std::int32_t contacts = 0;
  double area_m2 = 0.0;
};

/// Named faults of a tick, bits of TickRecord::faults.
enum Fault : std::uint32_t {
  kFaultNone = 0,
  kFaultDeviceInvalid = 1u << 0,   ///< the device reported itself unusable (unplugged, over its limit too long)
  kFaultDevicePose = 1u << 1,      ///< the device pose was not finite or not a rotation
  kFaultTissue = 1u << 2,          ///< the tissue state became non-finite; the step was undone
  kFaultForce = 1u << 3,           ///< a force was not finite; zero was sent
  kFaultOverrun = 1u << 4,         ///< the simulation had not finished its step; the force was predicted
};

struct TickRecord {
  std::int64_t tick = 0;           ///< servo tick, from 0
  double time_s = 0.0;             ///< tick * period: nominal time since the trial began
  Pose device_pose;                ///< where the hand is
  std::uint32_t buttons = 0;
  bool device_valid = true;
  std::int64_t step_fed = -1;      ///< simulation step this pose was fed to; -1: none (the simulation was busy)
  std::int64_t step_used = -1;     ///< newest finished simulation step when the force was written; -1: none yet
  Pose proxy_pose;                 ///< the tool as the scene held it after step_used
  HapticState state = HapticState::tracking;
  Vec3 model_force_n = Vec3::Zero();       ///< total force on the tool by the scene, world
  Vec3 model_torque_nm = Vec3::Zero();     ///< about the blade tip, world
  Vec3 displayed_force_n = Vec3::Zero();   ///< what the device was told, world
  std::array<StructureLoad, kLoadedStructures> loads{};  ///< by Structure
  bool has_sight = false;          ///< every 20 simulation steps
  double glottis_visible = 0.0;    ///< fraction of the glottic opening seen from the operator's eye, 0..1
  std::uint32_t faults = kFaultNone;
  bool has_intubation = false;             ///< of the scene: the same in all ticks of a trial
  IntubationRecord intubation;
};

}  // namespace vallecula::engine
