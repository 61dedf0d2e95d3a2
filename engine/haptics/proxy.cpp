#include "engine/haptics/proxy.h"

#include <algorithm>
#include <cmath>

namespace vallecula::engine {

namespace {

// Contact stiffness of rigid anatomy a sample point: gum and palate give by a tenth of a millimetre under a newton or
// two (assumed); implicit in the proxy's step, so stable at any value.
constexpr double kRigidStiffness = 8000.0;  // N/m
// What gum and the hand's own flesh take out of a blow (assumed): without it a levered blade bounced on the gum by 10
// to 20 N from tick to tick.
constexpr double kRigidDamping = 15.0;  // N s/m a sample point
// Points this near to rigid anatomy may come into contact within the tick.
constexpr double kRigidReach = 0.0008;  // m

/// Calls visit(world arm from the tip, normal, depth, structure) for each sample point that touches, and keeps it with
/// those no more than kRigidReach outside in scan.near.
template <class Visit>
void for_each_rigid_contact(const SignedDistanceGrid& rigid, const ToolField& tool, RigidScan& scan, const Pose& pose,
                            Visit visit) {
  scan.near.clear();
  scan.travel +=
      (pose.position - scan.last.position).norm() + tool.radius * pose.rotation.angularDistance(scan.last.rotation);
  scan.last = pose;
  const Mat3 to_world = pose.rotation.toRotationMatrix();
  for (std::size_t i = 0; i < tool.samples.size(); ++i) {
    if (scan.travel < scan.next_check[i]) continue;
    const Vec3 arm = to_world * tool.samples[i];
    const Vec3 world = pose.position + arm;
    const SignedDistanceGrid::Sample s = rigid.sample(world);
    double& met = scan.met[i];
    if (!(s.distance < kRigidReach)) {
      scan.next_check[i] = scan.travel + s.distance - kRigidReach;
      met = 0.0;
      continue;
    }
    // Deeper than the field's band nothing is known of what is touched or which way is out.
    const std::uint8_t structure = rigid.class_at(world);
    if (structure >= kLoadedStructures) {
      met = RigidScan::kNotMet;
      continue;
    }
    met = std::max(0.0, std::min(met, -s.distance));
    const double depth = -s.distance - met;
    Vec6 direction;
    direction << s.gradient, arm.cross(s.gradient);
    scan.near.add(direction, depth, kRigidStiffness, kRigidDamping);
    if (depth > 0) visit(arm, s.gradient, depth, static_cast<Structure>(structure));
  }
}

}  // namespace

RigidContacts rigid_contacts(const SignedDistanceGrid& rigid, const ToolField& tool, RigidScan& scan,
                             const Pose& pose) noexcept {
  RigidContacts out;
  std::array<double, kLoadedStructures> weight{};
  for_each_rigid_contact(rigid, tool, scan, pose,
                         [&](const Vec3& arm, const Vec3& n, double depth, Structure structure) {
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
                         RigidScan& scan, const HandState& hand, const Wrench& tissue, const Mat6& tissue_stiffness,
                         ProxyState& proxy) noexcept {
  move_coupled(settings, hand, tissue, tissue_stiffness, scan.near, proxy);
  return rigid_contacts(rigid, tool, scan, proxy.pose);
}

}  // namespace vallecula::engine
