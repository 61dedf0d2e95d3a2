#include "engine/state.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/contact_area.h"
#include "engine/contact/response.h"
#include "engine/tube/secretions.h"

namespace vallecula::engine {

namespace {

constexpr double kStrongestPull = 1e3;    // N, of the coupling's spring while nothing bounds it
constexpr double kFarthest = 1.0;         // m: device poses are clamped to this distance from the tissue

/// Takes the device pose in: finite, a rotation, within reach; and estimates the hand's velocity.
std::uint32_t take_device(const Scene& scene, SceneState& state, const Pose& pose) {
  if (!usable(pose)) return kFaultDevicePose;
  const Pose device = within_reach(scene, pose);
  if (!state.placed) {
    state.placed = true;
    state.proxy.pose = state.free_pose = device;
    state.hand.device = device;
  }
  follow_device(device, scene.model.step_s, state.hand);
  return kFaultNone;
}

/// Force of the tissue on the tool (N, and N m about the tip) and its share by structure, from the multipliers.
void collect_tissue_load(const Scene& scene, SceneState& state, std::array<StructureLoad, kLoadedStructures>& loads) {
  state.tissue_wrench = Wrench{};
  state.tissue_stiffness.setZero();
  std::array<double, kLoadedStructures> weight{};
  std::array<ContactArea, kLoadedStructures> area{};
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
    if (state.contacts.of_spheres)
      area[structure].add(c, scene.tree);
    else
      area[structure].add(c, scene.triangles);
  }
  for (int s = 0; s < kLoadedStructures; ++s) loads[s].area_m2 = area[s].m2();
  for (int s = 0; s < kLoadedStructures; ++s)
    if (weight[s] > 0) loads[s].centre_m /= weight[s];
}

/// What of the neck hangs on springs has its rest along the arc about the joint.
void turn_neck(const Scene& scene, SceneState& state) {
  const NeckDescription& neck = scene.description.neck;
  if (state.posture.extension == 0.0 || neck.carried.empty()) return;
  const Mat3 turn = Eigen::AngleAxisd(kExtension * eased(state.posture.extension), neck.axis).toRotationMatrix();
  for (const NeckDescription::Carried& c : neck.carried)
    state.tissue.body_load[static_cast<std::size_t>(c.body)] +=
        scene.model.bodies[static_cast<std::size_t>(c.body)].stiffness * (turn * (c.at - neck.joint) - (c.at - neck.joint));
}

/// What anatomy and tool ask of the sprung bodies in the coming step: the tool on what is theirs, and the joints' stops.
void load_bodies(const Scene& scene, SceneState& state) {
  TissueState& tissue = state.tissue;
  std::fill(tissue.body_load.begin(), tissue.body_load.end(), Vec3::Zero());
  std::fill(tissue.body_load_stiffness.begin(), tissue.body_load_stiffness.end(), 0.0);
  if (state.placed)
    press_parts(scene.rigid, state.parts, scene.tool, state.rigid_scan, state.proxy, scene.model.step_s,
                {tissue.body_load, tissue.body_load_stiffness});
  for (std::size_t b = 0; b < scene.model.bodies.size(); ++b) {
    const SprungBody& body = scene.model.bodies[b];
    const double angle = tissue.body_displacement[b].x(), beyond = std::abs(angle) - body.stop;
    if (body.motion != SprungBody::Motion::hinge || !(body.stop > 0) || !(beyond > 0)) continue;
    const double stiffer = (SprungBody::kStopFactor - 1) * body.stiffness;
    tissue.body_load[b].x() -= std::copysign(stiffer * beyond, angle);
    tissue.body_load_stiffness[b] += stiffer;
  }
  turn_neck(scene, state);
  if (!state.intubation) return;
  for (std::size_t b = 0; b < scene.model.bodies.size(); ++b) {
    tissue.body_load[b] += state.intubation->body_load[b];
    tissue.body_load_stiffness[b] += state.intubation->body_load_stiffness[b];
  }
}

/// Of tissue, lips and tube on the tool.
Wrench soft_wrench(const SceneState& state) {
  Wrench w{state.tissue_wrench.force + state.lips.wrench.force, state.tissue_wrench.torque + state.lips.wrench.torque};
  if (!state.intubation) return w;
  w.force += state.intubation->on_blade.force;
  w.torque += state.intubation->on_blade.torque;
  return w;
}
Mat6 soft_stiffness(const SceneState& state) {
  Mat6 k = state.tissue_stiffness + state.lips.stiffness;
  if (state.intubation) k += state.intubation->on_blade_stiffness;
  return k;
}

bool tissue_finite(const SceneState& state) {
  double sum = state.tissue_wrench.force.squaredNorm() + state.tissue_wrench.torque.squaredNorm();
  for (const Vec3& u : state.tissue.displacement) sum += u.squaredNorm();
  for (const Vec3& u : state.tissue.body_displacement) sum += u.squaredNorm();
  return std::isfinite(sum);
}

/// What the second hand holds stands in the way, and what lies below the secretions' level is not seen.
void look_past_tube(const Scene& scene, SceneState& state) {
  const IntubationState& s = *state.intubation;
  if (s.placed) {
    const double radius = scene.intubation->rod(s.in_hand).description().outer_radius_m;
    scene.sight.add(state.sight, kTubeNodes * kTubeSides, scene.intubation->sleeve,
                    [&](int i) -> Vec3 { return sleeve_point(s.rod, radius, i); });
  }
  const Secretions& fluid = scene.intubation->description.secretions;
  if (s.secretions_m3 > 0)
    scene.sight.hide_below(state.sight, state.tissue.body_displacement, fluid.up,
                           fluid.up.dot(fluid.floor) + level(fluid, s.secretions_m3));
}

void look(const Scene& scene, SceneState& state) {
  scene.sight.begin(state.sight, state.tissue.body_displacement, eye_offset(scene, state));
  scene.sight.add(state.sight, scene.model.nodes, scene.surface.triangles,
                  [&](int i) -> Vec3 { return scene.model.rest[i] + state.tissue.displacement[i]; });
  const TriangleMesh& tool = scene.description.tool.surface;
  const Mat3 turn = state.proxy.pose.rotation.toRotationMatrix();
  scene.sight.add(state.sight, static_cast<int>(tool.points.size()), tool.triangles,
                  [&](int i) -> Vec3 { return state.proxy.pose.position + turn * tool.points[i]; });
  if (state.intubation) look_past_tube(scene, state);
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
      lips(scene.lips.make_state()),
      sight(scene.sight.make_scratch(
          std::max({scene.model.rest.size(), scene.description.tool.surface.points.size(),
                    scene.intubation ? std::size_t{kTubeNodes * kTubeSides} : 0}))) {
  if (scene.intubation) intubation.emplace(scene);
}

Vec3 eye_offset(const Scene& scene, const SceneState& state) noexcept {
  const SightDescription& sight = scene.description.sight;
  return kEyeMove * (eased(state.posture.right) * sight.eye_right + eased(state.posture.up) * sight.eye_up);
}

Pose within_reach(const Scene& scene, const Pose& pose) noexcept {
  Pose taken = pose;
  taken.rotation.normalize();
  const Vec3 way = taken.position - scene.centre;
  if (way.norm() > kFarthest) taken.position = scene.centre + way * (kFarthest / way.norm());
  return taken;
}

StepStatistics step_tissue(const Scene& scene, SceneState& state, const Pose& before,
                           std::array<StructureLoad, kLoadedStructures>& loads, StageTimes& times,
                           SoftContactState* tube) noexcept {
  StageClock clock;
  if (state.placed && scene.description.collision == Collision::triangles)
    find_triangle_contacts(scene.triangles, scene.surface, scene.model, state.tissue, state.proxy.pose, before,
                           scene.contact_stiffness, state.triangles, state.contacts);
  else if (state.placed)
    find_contacts(scene.tree, scene.surface, scene.description.soft.tets, scene.model, state.tissue, scene.tool,
                  state.proxy.pose, before, scene.contact_stiffness,
                  static_cast<float>(scene.description.friction), state.contacts);
  clock.add_to(times.collision_s);
  state.contacts.of_tube = tube ? tube->count : 0;
  ContactConstraint* of_tube = state.contacts.constraints.data() + state.contacts.count;
  if (tube) std::copy_n(tube->constraints.begin(), tube->count, of_tube);
  const StepStatistics statistics = respond(scene.description.response, scene.description.sphere_distances, scene.tree,
                                            scene.model, state.proxy.pose, state.tissue, state.contacts, times);
  clock = StageClock();
  if (tube) {
    std::copy_n(of_tube, tube->count, tube->constraints.begin());
    keep_soft_contacts(*tube);
  }
  collect_tissue_load(scene, state, loads);
  clock.add_to(times.response_s);
  return statistics;
}

StepResult step(const Scene& scene, SceneState& state, const StepInput& input) noexcept {
  StepResult result;
  result.step = state.step;
  const HapticSettings& settings = scene.description.haptics;
  result.faults |= take_device(scene, state, input.device);
  // Without one of its two hands a trial stands still: the other's tool is held as its own is.
  const bool paused = scene.intubation && !hands_there(input);
  bool valid = input.valid && !paused && (result.faults & kFaultDevicePose) == 0;
  if (!input.valid) result.faults |= kFaultDeviceInvalid;

  // A pause leaves both heads as they are.
  if (hands_there(input)) step(state.posture, input.actions, scene.model.step_s);

  const Pose before = state.proxy.pose;
  const bool held = paused || proxy_held(state.limit.state);
  RigidContacts rigid;
  if (!state.placed) {
    valid = false;
  } else if (held) {
    state.proxy.velocity.setZero();
    state.proxy.angular_velocity.setZero();
    rigid = rigid_contacts(scene.rigid, state.parts, scene.tool, scene.model.step_s, state.rigid_scan, state.proxy.pose);
    // Admissible is a pose that the device could hold: what the blow of stopping drove into bone beyond that is let out.
    if (rigid.wrench.force.norm() > settings.device_limit_n) {
      HandState stop;
      stop.device = state.proxy.pose;
      stop.force_limit_n = settings.device_limit_n;
      rigid = move_proxy(scene.proxy, scene.rigid, state.parts, scene.tool, state.rigid_scan, stop, Wrench{}, Mat6::Zero(),
                         state.proxy);
    }
  } else {
    state.hand.scale = state.limit.coupling_scale;
    state.hand.force_limit_n = state.limit.state == HapticState::recovering ? settings.device_limit_n : kStrongestPull;
    rigid = move_proxy(scene.proxy, scene.rigid, state.parts, scene.tool, state.rigid_scan, state.hand, soft_wrench(state),
                       soft_stiffness(state), state.proxy);
  }

  StageTimes times;
  load_bodies(scene, state);
  step_tissue(scene, state, before, result.loads, times, state.intubation ? &state.intubation->soft : nullptr);
  scene.rigid.place(state.tissue.body_displacement, state.tissue.body_velocity, state.parts);
  if (state.placed && scene.rigid.part_count() > 0)  // as they press now that the bodies have given way
    rigid = rigid_contacts(scene.rigid, state.parts, scene.tool, scene.model.step_s, state.rigid_scan, state.proxy.pose);
  if (state.placed) scene.lips.step(scene.tool, state.proxy.pose, state.tissue.body_displacement, state.lips);
  if (!tissue_finite(state) || !usable(state.proxy.pose)) {
    state.tissue.set_rest(scene.model);
    state.contacts.forget();
    state.tissue_wrench = Wrench{};
    state.tissue_stiffness.setZero();
    state.proxy = ProxyState{};
    // Not at the hand: tissue put to rest about a tool that stands in it would grip it for good.
    state.proxy.pose = state.free_pose;
    state.rigid_scan.begin_anew(state.free_pose);
    state.parts = PartPoses{};
    state.lips.set_rest();
    if (state.intubation) state.intubation->soft.forget();
    result.loads = {};
    rigid = RigidContacts{};
    result.faults |= kFaultTissue;
  }
  for (int s = 0; s < kLoadedStructures; ++s)
    if (rigid.loads[s].contacts > 0) result.loads[s] = rigid.loads[s];  // rigid and soft structures never share a name
  if (state.intubation) step_intubation(scene, state, input, result);
  const Wrench soft = soft_wrench(state);
  result.model_force_n = soft.force + rigid.wrench.force;
  result.model_torque_nm = soft.torque + rigid.wrench.torque;
  if (state.contacts.count == 0 && result.model_force_n.isZero(0)) state.free_pose = state.proxy.pose;

  const Wrench spring = coupling_wrench(scene.proxy, state.proxy.pose, state.hand.device, 1.0);
  judge_limit(settings, scene.model.step_s, trial_force(spring.force, result.model_force_n), valid, state.limit);
  if (state.step % kSightEverySteps == 0) look(scene, state);

  result.device_pose = state.hand.device;
  result.proxy_pose = state.proxy.pose;
  result.limit = state.limit;
  CouplingState& coupling = result.coupling;
  coupling.hand = state.hand;
  coupling.hand.scale = state.limit.coupling_scale;
  coupling.proxy = state.proxy;
  coupling.held = proxy_held(state.limit.state);
  if (held) coupling.proxy.pull = coupling_wrench(scene.proxy, state.proxy.pose, state.hand.device, coupling.hand.scale);
  add_tissue(soft, state.felt.feel(state.proxy.pose, soft), coupling.springs);
  for (int i = 0; i < state.rigid_scan.near.count; ++i) {
    const PushingSprings& near = state.rigid_scan.near;
    coupling.springs.add(near.direction[i], near.depth[i], near.stiffness[i], near.damping[i]);
  }
  result.glottis_visible = state.glottis_visible;
  ++state.step;
  return result;
}

}  // namespace vallecula::engine
