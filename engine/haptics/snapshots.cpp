#include "engine/haptics/snapshots.h"

#include <algorithm>

namespace vallecula::engine {

void size_snapshot(const Scene& scene, Snapshot& s) {
  s.soft_points.assign(3 * scene.model.nodes, 0.0f);
  s.body_displacement.assign(scene.model.bodies.size(), Vec3::Zero());
  s.lip_displacement.assign(scene.description.lips.surface.points.size(), Vec3::Zero());
}

void fill_snapshot(const Scene& scene, const SceneState& state, const StepResult& result, Snapshot& s) noexcept {
  s.step = result.step;
  s.time_s = static_cast<double>(result.step) * scene.model.step_s;
  s.device_pose = result.device_pose;
  s.proxy_pose = result.proxy_pose;
  s.state = result.limit.state;
  s.model_force_n = result.model_force_n;
  s.loads = result.loads;
  s.glottis_visible = result.glottis_visible;
  s.eye_offset_m = eye_offset(scene, state);
  s.extension_rad = kExtension * eased(state.posture.extension);
  s.faults = result.faults;
  std::copy(state.tissue.body_displacement.begin(), state.tissue.body_displacement.end(), s.body_displacement.begin());
  s.has_intubation = state.intubation.has_value();
  if (s.has_intubation) {
    s.intubation = result.intubation;
    s.tube_axis = state.intubation->rod.position;
    s.tube_frames = state.intubation->rod.rotation;
  }
  std::copy(state.lips.displacement.begin(), state.lips.displacement.end(), s.lip_displacement.begin());
  for (int i = 0; i < scene.model.nodes; ++i)
    for (int a = 0; a < 3; ++a)
      s.soft_points[3 * i + a] = static_cast<float>(scene.model.rest[i][a] + state.tissue.displacement[i][a]);
}

Snapshot snapshot_at_start(const Scene& scene, const StepInput& hands) {
  Snapshot s;
  size_snapshot(scene, s);
  SceneState state(scene);
  fill_snapshot(scene, state, step(scene, state, hands), s);
  return s;
}

}  // namespace vallecula::engine
