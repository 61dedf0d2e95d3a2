#include "engine/haptics/proxy.h"

#include <algorithm>
#include <cmath>

#include <array>

#include <Eigen/Cholesky>

namespace vallecula::engine {

namespace {

// Contact stiffness of rigid anatomy a sample point: gum and palate give by a tenth of a millimetre under a newton or two
// (assumed); implicit in the proxy's step, so stable at any value.
constexpr double kRigidStiffness = 8000.0;  // N/m
// What gum and the hand's own flesh take out of a blow (assumed): without it a levered blade bounced on the gum by 10 to 20 N
// from tick to tick.
constexpr double kRigidDamping = 15.0;  // N s/m a sample point
// A hand on a blade turns it with no more than its force at this lever. A spring that turned without end levered a held
// blade into the gum with a hundred newtons, whatever the device could give.
constexpr double kTurningArm = 0.05;  // m (assumed: half a blade)
constexpr double kCouplingDamping = 0.7;    // share of critical

using Vec6 = Eigen::Matrix<double, 6, 1>;

// Points this near to rigid anatomy may come into contact within the tick.
constexpr double kRigidReach = 0.0008;  // m
constexpr int kMostRigidPoints = 256, kRigidPasses = 5;

/// Calls visit(world arm from the tip, depth, touch) for each sample point deeper than `least_depth`, which is no more than
/// kRigidReach outside.
template <class Visit>
void for_each_rigid_contact(const RigidField& rigid, const PartPoses& parts, const ToolField& tool, RigidScan& scan,
                            const Pose& pose, double least_depth, Visit visit) {
  double moved = (pose.position - scan.last.position).norm() + tool.radius * pose.rotation.angularDistance(scan.last.rotation);
  for (int p = 0; p < rigid.part_count(); ++p) moved += (parts[p].travel - scan.parts[p].travel).norm();
  scan.travel += moved;
  scan.last = pose;
  scan.parts = parts;
  const Mat3 to_world = pose.rotation.toRotationMatrix();
  for (std::size_t i = 0; i < tool.samples.size(); ++i) {
    if (scan.travel < scan.next_check[i]) continue;
    const Vec3 arm = to_world * tool.samples[i];
    const double most = scan.depth[i] + moved;
    double& known = scan.depth[i];
    known = 0.0;
    const double nearest = rigid.look(pose.position + arm, parts, kRigidReach, [&](const RigidField::Touch& touch) {
      if (static_cast<int>(touch.structure) >= kLoadedStructures) return;
      const double depth = std::min(-touch.distance, most);
      known = std::max(known, depth);
      if (depth > least_depth) visit(arm, depth, touch);
    });
    if (!(nearest < kRigidReach)) scan.next_check[i] = scan.travel + nearest - kRigidReach;
  }
}

}  // namespace

Vec3 rotation_between(const Quat& from, const Quat& to) {
  Quat d = to * from.conjugate();
  if (d.w() < 0) d.coeffs() = -d.coeffs();
  const double s = d.vec().norm();
  if (s < 1e-12) return 2.0 * d.vec();
  return 2.0 * std::atan2(s, d.w()) / s * d.vec();
}

Wrench coupling_wrench(const ProxySettings& settings, const Pose& proxy, const Pose& device, double scale) {
  Wrench w;
  w.force = scale * settings.stiffness_n_m * (device.position - proxy.position);
  w.torque = scale * settings.rotation_nm_rad * rotation_between(proxy.rotation, device.rotation);
  return w;
}

RigidContacts rigid_contacts(const RigidField& rigid, const PartPoses& parts, const ToolField& tool, RigidScan& scan,
                             const Pose& pose) noexcept {
  RigidContacts out;
  std::array<double, kLoadedStructures> weight{};
  for_each_rigid_contact(rigid, parts, tool, scan, pose, 0.0, [&](const Vec3& arm, double depth, const RigidField::Touch& touch) {
    const Vec3 force = kRigidStiffness * depth * touch.normal;
    const int structure = static_cast<int>(touch.structure);
    out.wrench.force += force;
    out.wrench.torque += arm.cross(force);
    StructureLoad& load = out.loads[structure];
    load.force_n += force;
    load.centre_m += kRigidStiffness * depth * (pose.position + arm);
    weight[structure] += kRigidStiffness * depth;
    ++load.contacts;
  });
  for (int i = 0; i < kLoadedStructures; ++i)
    if (weight[i] > 0) out.loads[i].centre_m /= weight[i];
  return out;
}

void press_parts(const RigidField& rigid, const PartPoses& parts, const ToolField& tool, RigidScan& scan,
                 const ProxyState& proxy, double step_s, const BodyLoads& bodies) noexcept {
  if (rigid.part_count() == 0) return;
  for_each_rigid_contact(rigid, parts, tool, scan, proxy.pose, 0.0,
                         [&](const Vec3& arm, double depth, const RigidField::Touch& touch) {
    if (touch.part < 0) return;
    const std::size_t body = static_cast<std::size_t>(rigid.body_of(touch.part));
    const Vec3 lever = rigid.lever(touch.part, touch.rest, touch.normal);
    const double away = touch.normal.dot(proxy.velocity + proxy.angular_velocity.cross(arm));
    bodies.load[body] -= (kRigidStiffness * depth - kRigidDamping * away) * lever;
    bodies.stiffness[body] += (kRigidStiffness + kRigidDamping / step_s) * lever.squaredNorm();
  });
}

RigidContacts move_proxy(const ProxySettings& settings, const RigidField& rigid, const PartPoses& parts,
                         const ToolField& tool, RigidScan& scan, const Pose& device, const Wrench& device_velocity, double coupling_scale, double force_limit,
                         const Wrench& tissue, const Mat6& tissue_stiffness, ProxyState& proxy) noexcept {
  const double h = settings.step_s;
  const double k = settings.stiffness_n_m * coupling_scale, kr = settings.rotation_nm_rad * coupling_scale;
  const double b = 2 * kCouplingDamping * std::sqrt(k * settings.mass_kg);
  const double br = 2 * kCouplingDamping * std::sqrt(kr * settings.inertia_kg_m2);

  Wrench pull = coupling_wrench(settings, proxy.pose, device, coupling_scale);
  const double strength = pull.force.norm();
  if (strength > force_limit) {
    pull.force *= force_limit / strength;
    pull.torque *= force_limit / strength;
  }
  const double turning = pull.torque.norm(), most_turning = settings.force_limit_n * kTurningArm;
  if (turning > most_turning) pull.torque *= most_turning / turning;
  Mat6 matrix = tissue_stiffness;
  Vec6 right;
  matrix.diagonal().head<3>().array() += settings.mass_kg / (h * h) + b / h + k;
  matrix.diagonal().tail<3>().array() += settings.inertia_kg_m2 / (h * h) + br / h + kr;
  right.head<3>() = settings.mass_kg / h * proxy.velocity + b * device_velocity.force + pull.force + tissue.force;
  right.tail<3>() = settings.inertia_kg_m2 / h * proxy.angular_velocity + br * device_velocity.torque + pull.torque + tissue.torque;
  // Springs that push only: which of them do at the end of the move is found by trying (a few passes settle it).
  std::array<Vec6, kMostRigidPoints> direction;
  std::array<double, kMostRigidPoints> depth, comes;  // comes: how far a moving part's surface comes out in this tick
  std::array<bool, kMostRigidPoints> pushes;
  int points = 0;
  for_each_rigid_contact(rigid, parts, tool, scan, proxy.pose, -kRigidReach,
                         [&](const Vec3& arm, double deep, const RigidField::Touch& touch) {
                           if (points == kMostRigidPoints) return;
                           direction[points] << touch.normal, arm.cross(touch.normal);
                           comes[points] =
                               touch.part < 0 ? 0.0 : h * touch.normal.dot(parts[touch.part].velocity_at(touch.rest));
                           depth[points] = deep + comes[points];
                           pushes[points] = depth[points] > 0;
                           ++points;
                         });
  Vec6 move = Vec6::Zero();
  for (int pass = 0; pass < kRigidPasses; ++pass) {
    Mat6 with = matrix;
    Vec6 load = right;
    for (int i = 0; i < points; ++i) {
      if (!pushes[i]) continue;
      with += (kRigidStiffness + kRigidDamping / h) * direction[i] * direction[i].transpose();
      load += (kRigidStiffness * depth[i] + kRigidDamping / h * comes[i]) * direction[i];
    }
    move = with.llt().solve(load);
    bool changed = false;
    for (int i = 0; i < points; ++i) {
      const bool push = depth[i] - direction[i].dot(move) > 0;
      changed |= push != pushes[i];
      pushes[i] = push;
    }
    if (!changed) break;
  }
  proxy.velocity = move.head<3>() / h;
  proxy.angular_velocity = move.tail<3>() / h;
  proxy.pose.position += move.head<3>();
  const Vec3 turn = move.tail<3>();
  const double angle = turn.norm();
  if (angle > 1e-15) {
    const Vec3 axis = turn / angle;
    proxy.pose.rotation = Quat(Eigen::AngleAxisd(angle, axis)) * proxy.pose.rotation;
    proxy.pose.rotation.normalize();
  }
  return rigid_contacts(rigid, parts, tool, scan, proxy.pose);
}

}  // namespace vallecula::engine
