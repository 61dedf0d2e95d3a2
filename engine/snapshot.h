// What the screen sees: the newest finished step, copied whole, never shared with the simulation.
#pragma once

#include "engine/tick_record.h"
#include "engine/tube/rod.h"

namespace vallecula::engine {

struct Snapshot {
  std::int64_t step = -1;        ///< -1: nothing simulated yet
  double time_s = 0.0;
  Pose device_pose;              ///< the ghost, drawn grey where it parts from the proxy
  Pose proxy_pose;
  HapticState state = HapticState::tracking;
  Vec3 model_force_n = Vec3::Zero();
  Vec3 displayed_force_n = Vec3::Zero();
  std::array<StructureLoad, kLoadedStructures> loads{};
  double glottis_visible = 0.0;  ///< newest value, 0..1
  Vec3 eye_offset_m = Vec3::Zero();  ///< of the operator's eye from SightDescription::eye, world (posture.h)
  double extension_rad = 0.0;    ///< of the head on the neck, beyond the scan's (posture.h)
  std::uint32_t faults = 0;
  std::int64_t ticks = 0;            ///< servo ticks so far
  std::int64_t deadline_misses = 0;  ///< forces written more than 1 ms after they were due
  std::int64_t overruns = 0;         ///< ticks whose simulation step was not finished in time
  double loop_rate_hz = 0.0;         ///< servo rate over the last second
  bool has_intubation = false;
  IntubationRecord intubation;
  std::array<Vec3, kTubeNodes> tube_axis{};        ///< of what the second hand holds, from the tip, m
  std::array<Quat, kTubeSegments> tube_frames{};   ///< of its segments
  std::vector<float> soft_points;    ///< x y z (m) of every tissue node in the package's order; sized once
  std::vector<Vec3> body_displacement;  ///< of the tissue's sprung bodies: translation (m), or angle (rad) in x
  std::vector<Vec3> lip_displacement;   ///< of LipDescription's points, on top of the jaw's, m
};

}  // namespace vallecula::engine
