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

/// Calls visit(world arm from the tip, normal, depth, structure) for each sample point deeper than `least_depth`, which is
/// no more than kRigidReach outside.
template <class Visit>
void for_each_rigid_contact(const SignedDistanceGrid& rigid, const ToolField& tool, RigidScan& scan, const Pose& pose,
                            double least_depth, Visit visit) {
  const double moved = (pose.position - scan.last.position).norm() + tool.radius * pose.rotation.angularDistance(scan.last.rotation);
  scan.travel += moved;
  scan.last = pose;
  const Mat3 to_world = pose.rotation.toRotationMatrix();
  for (std::size_t i = 0; i < tool.samples.size(); ++i) {
    if (scan.travel < scan.next_check[i]) continue;
    const Vec3 arm = to_world * tool.samples[i];
    const Vec3 world = pose.position + arm;
    const SignedDistanceGrid::Sample s = rigid.sample(world);
    double& known = scan.depth[i];
    if (!(s.distance < kRigidReach)) {
      scan.next_check[i] = scan.travel + s.distance - kRigidReach;
      known = 0.0;
      continue;
    }
    // Deeper than the field's band nothing is known of what is touched or which way is out.
    const std::uint8_t structure = rigid.class_at(world);
    if (structure >= kLoadedStructures) {
      known = 0.0;
      continue;
    }
    const double depth = std::min(-s.distance, known + moved);
    known = std::max(0.0, depth);
    if (!(depth > least_depth)) continue;
    visit(arm, s.gradient, depth, static_cast<Structure>(structure));
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

RigidContacts rigid_contacts(const SignedDistanceGrid& rigid, const ToolField& tool, RigidScan& scan,
                             const Pose& pose) noexcept {
  RigidContacts out;
  std::array<double, kLoadedStructures> weight{};
  for_each_rigid_contact(rigid, tool, scan, pose, 0.0, [&](const Vec3& arm, const Vec3& n, double depth, Structure structure) {
    const Vec3 force = kRigidStiffness * depth * n;
    out.wrench.force += force;
    out.wrench.torque += arm.cross(force);
    StructureLoad& load = out.loads[static_cast<int>(structure)];
    load.force_n += force;
    load.centre_m += kRigidStiffness * depth * (pose.position + arm);
    weight[static_cast<int>(structure)] += kRigidStiffness * depth;
    ++load.contacts;
  });
  for (int i = 0; i < kLoadedStructures; ++i)
    if (weight[i] > 0) out.loads[i].centre_m /= weight[i];
  return out;
}

RigidContacts move_proxy(const ProxySettings& settings, const SignedDistanceGrid& rigid, const ToolField& tool,
                         RigidScan& scan, const Pose& device, const Wrench& device_velocity, double coupling_scale, double force_limit,
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
  std::array<double, kMostRigidPoints> depth;
  std::array<bool, kMostRigidPoints> pushes;
  int points = 0;
  for_each_rigid_contact(rigid, tool, scan, proxy.pose, -kRigidReach,
                         [&](const Vec3& arm, const Vec3& n, double deep, Structure) {
                           if (points == kMostRigidPoints) return;
                           direction[points] << n, arm.cross(n);
                           depth[points] = deep;
                           pushes[points] = deep > 0;
                           ++points;
                         });
  Vec6 move = Vec6::Zero();
  for (int pass = 0; pass < kRigidPasses; ++pass) {
    Mat6 with = matrix;
    Vec6 load = right;
    for (int i = 0; i < points; ++i) {
      if (!pushes[i]) continue;
      with += (kRigidStiffness + kRigidDamping / h) * direction[i] * direction[i].transpose();
      load += kRigidStiffness * depth[i] * direction[i];
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
  return rigid_contacts(rigid, tool, scan, proxy.pose);
}

}  // namespace vallecula::engine
