#include "engine/state.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/response.h"

namespace vallecula::engine {

namespace {

constexpr double kFarthest = 1.0;        // m: device poses are clamped to this distance from the tissue
constexpr double kFastest = 2.0;         // m/s, and 20 rad/s: above it the damper takes the hand for this fast
constexpr double kVelocityFilter = 0.2;  // weight of the newest difference quotient

bool usable(const Pose& pose) {
  return pose.position.allFinite() && pose.rotation.coeffs().allFinite() && std::abs(pose.rotation.norm() - 1.0) < 1e-3;
}

/// Takes the device pose in: finite, a rotation, within reach; and estimates the hand's velocity.
std::uint32_t take_device(const Scene& scene, SceneState& state, const Pose& pose) {
  if (!usable(pose)) return kFaultDevicePose;
  Pose device = pose;
  device.rotation.normalize();
  const Vec3 way = device.position - scene.centre;
  if (way.norm() > kFarthest) device.position = scene.centre + way * (kFarthest / way.norm());
  if (!state.placed) {
    state.placed = true;
    state.proxy.pose = device;
    state.device = device;
  }
  const double h = scene.model.step_s;
  const auto limited = [](Vec3 v, double most) { return v.norm() > most ? Vec3(v * (most / v.norm())) : v; };
  const Vec3 linear = limited((device.position - state.device.position) / h, kFastest);
  const Vec3 angular = limited(rotation_between(state.device.rotation, device.rotation) / h, 10 * kFastest);
  state.device_velocity.force += kVelocityFilter * (linear - state.device_velocity.force);
  state.device_velocity.torque += kVelocityFilter * (angular - state.device_velocity.torque);
  state.device = device;
  return kFaultNone;
}

/// Force of the tissue on the tool (N, and N m about the tip) and its share by structure, from the multipliers.
void collect_tissue_load(const Scene& scene, SceneState& state, std::array<StructureLoad, kLoadedStructures>& loads) {
  state.tissue_wrench = Wrench{};
  state.tissue_stiffness.setZero();
  std::array<double, kLoadedStructures> weight{};
  for (int i = 0; i < state.contacts.count; ++i) {
    const ContactConstraint& c = state.contacts.constraints[i];
    if (!(c.multiplier > 0)) continue;
    Vec3 at = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
      at += c.weight[k] * (scene.model.rest[c.node[k]] + state.tissue.displacement[c.node[k]]);
    const Vec3 force = -c.multiplier * to_vec3(c.normal) - to_vec3(c.friction);
    state.tissue_wrench.force += force;
    const Vec3 arm = at - state.proxy.pose.position;
    state.tissue_wrench.torque += arm.cross(force);
    Eigen::Matrix<double, 6, 1> direction;
    direction << to_vec3(c.normal), arm.cross(to_vec3(c.normal));
    state.tissue_stiffness += c.stiffness / kContactAugmentation * direction * direction.transpose();
    const int tet = scene.surface.tet[c.triangle];
    const int structure = static_cast<int>(scene.description.soft.tet_structure[tet]);
    if (structure >= kLoadedStructures) continue;
    StructureLoad& load = loads[structure];
    load.force_n += force;
    load.centre_m += c.multiplier * at;
    weight[structure] += c.multiplier;
    ++load.contacts;
  }
  for (int s = 0; s < kLoadedStructures; ++s)
    if (weight[s] > 0) loads[s].centre_m /= weight[s];
}

bool tissue_finite(const SceneState& state) {
  double sum = state.tissue_wrench.force.squaredNorm() + state.tissue_wrench.torque.squaredNorm();
  for (const Vec3& u : state.tissue.displacement) sum += u.squaredNorm();
  for (const Vec3& u : state.tissue.body_displacement) sum += u.squaredNorm();
  return std::isfinite(sum);
}

void look(const Scene& scene, SceneState& state) {
  scene.sight.begin(state.sight);
  scene.sight.add(state.sight, scene.model.nodes, scene.surface.triangles,
                  [&](int i) -> Vec3 { return scene.model.rest[i] + state.tissue.displacement[i]; });
  const TriangleMesh& tool = scene.description.tool.surface;
  const Mat3 turn = state.proxy.pose.rotation.toRotationMatrix();
  scene.sight.add(state.sight, static_cast<int>(tool.points.size()), tool.triangles,
                  [&](int i) -> Vec3 { return state.proxy.pose.position + turn * tool.points[i]; });
  state.glottis_visible = scene.sight.visible(state.sight);
}

}  // namespace

SceneState::SceneState(const Scene& scene)
    : tissue(scene.model),
      contacts(scene.description.collision == Collision::aist
                   ? ContactState(scene.tree)
                   : ContactState(scene.triangles.vertices.size(), scene.triangles.most_contacts())),
      triangles(scene.triangles),
      rigid_scan(scene.tool.samples.size()),
      sight(scene.sight.make_scratch(
          std::max<std::size_t>(scene.model.rest.size(), scene.description.tool.surface.points.size()))) {}

StepStatistics step_tissue(const Scene& scene, SceneState& state, const Pose& before,
                           std::array<StructureLoad, kLoadedStructures>& loads, StageTimes& times) noexcept {
  StageClock clock;
  if (state.placed && scene.description.collision == Collision::triangles)
    find_triangle_contacts(scene.triangles, scene.surface, scene.model, state.tissue, state.proxy.pose, before,
                           scene.contact_stiffness, state.triangles, state.contacts);
  else if (state.placed)
    find_contacts(scene.tree, scene.surface, scene.description.soft.tets, scene.model, state.tissue, scene.tool,
                  state.proxy.pose, before, scene.contact_stiffness,
                  static_cast<float>(scene.description.friction), state.contacts);
  clock.add_to(times.collision_s);
  const StepStatistics statistics = respond(scene.description.response, scene.description.sphere_distances, scene.tree,
                                            scene.model, state.proxy.pose, state.tissue, state.contacts, times);
  clock = StageClock();
  collect_tissue_load(scene, state, loads);
  clock.add_to(times.response_s);
  return statistics;
}

StepResult step(const Scene& scene, SceneState& state, const StepInput& input) noexcept {
  StepResult result;
  result.step = state.step;
  const HapticSettings& settings = scene.description.haptics;
  result.faults |= take_device(scene, state, input.device);
  bool valid = input.valid && (result.faults & kFaultDevicePose) == 0;
  if (!input.valid) result.faults |= kFaultDeviceInvalid;

  const Pose before = state.proxy.pose;
  RigidContacts rigid;
  if (!state.placed) {
    valid = false;
  } else if (proxy_held(state.limit.state)) {
    state.proxy.velocity.setZero();
    state.proxy.angular_velocity.setZero();
    rigid = rigid_contacts(scene.rigid, scene.tool, state.rigid_scan, state.proxy.pose);
    // Admissible is a pose that the device could hold: what the blow of stopping drove into bone beyond that is let out.
    if (rigid.wrench.force.norm() > settings.device_limit_n)
      rigid = move_proxy(scene.proxy, scene.rigid, scene.tool, state.rigid_scan, state.proxy.pose, Wrench{}, 1.0,
                         settings.device_limit_n, Wrench{}, Mat6::Zero(), state.proxy);
  } else {
    const bool bounded = state.limit.state == HapticState::recovering;
    rigid = move_proxy(scene.proxy, scene.rigid, scene.tool, state.rigid_scan, state.device, state.device_velocity,
                       state.limit.coupling_scale, bounded ? settings.device_limit_n : 1e3, state.tissue_wrench, state.tissue_stiffness,
                       state.proxy);
  }

  StageTimes times;
  step_tissue(scene, state, before, result.loads, times);
  if (!tissue_finite(state) || !usable(state.proxy.pose)) {
    state.tissue.set_rest(scene.model);
    state.contacts.forget();
    state.tissue_wrench = Wrench{};
    state.tissue_stiffness.setZero();
    state.proxy = ProxyState{};
    state.proxy.pose = state.device;
    state.rigid_scan.begin_anew(state.device);
    result.loads = {};
    rigid = RigidContacts{};
    result.faults |= kFaultTissue;
  }
  for (int s = 0; s < kLoadedStructures; ++s)
    if (rigid.loads[s].contacts > 0) result.loads[s] = rigid.loads[s];  // rigid and soft structures never share a name
  result.model_force_n = state.tissue_wrench.force + rigid.wrench.force;
  result.model_torque_nm = state.tissue_wrench.torque + rigid.wrench.torque;

  const Vec3 pull = coupling_wrench(scene.proxy, state.proxy.pose, state.device, 1.0).force;
  judge_limit(settings, scene.model.step_s, trial_force(pull, result.model_force_n), valid, state.limit);
  if (state.step % kSightEverySteps == 0) look(scene, state);

  result.device_pose = state.device;
  result.proxy_pose = state.proxy.pose;
  result.limit = state.limit;
  result.glottis_visible = state.glottis_visible;
  ++state.step;
  return result;
}

}  // namespace vallecula::engine
