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

/// Calls visit(world arm from the tip, depth, touch) for each sample point that is pressed in, and keeps it with those no
/// more than kRigidReach outside in scan.near.
template <class Visit>
void for_each_rigid_contact(const RigidField& rigid, const PartPoses& parts, const ToolField& tool, double step_s,
                            RigidScan& scan, const Pose& pose, Visit visit) {
  double moved =
      (pose.position - scan.last.position).norm() + tool.radius * pose.rotation.angularDistance(scan.last.rotation);
  for (int p = 0; p < rigid.part_count(); ++p) moved += (parts[p].travel - scan.parts[p].travel).norm();
  scan.near.clear();
  scan.travel += moved;
  scan.last = pose;
  scan.parts = parts;
  const Mat3 to_world = pose.rotation.toRotationMatrix();
  for (std::size_t i = 0; i < tool.samples.size(); ++i) {
    if (scan.travel < scan.next_check[i]) continue;
    const Vec3 arm = to_world * tool.samples[i];
    const auto met_by = [&](int part) -> double& { return scan.met[i][static_cast<std::size_t>(part + 1)]; };
    const double nearest = rigid.look(
        pose.position + arm, parts, kRigidReach,
        [&](const RigidField::Touch& touch) {
          double& met = met_by(touch.part);
          std::uint8_t& in = scan.pressed_in[i][static_cast<std::size_t>(touch.part + 1)];
          const bool resists = static_cast<int>(touch.structure) < kLoadedStructures;
          if (!resists && in == RigidScan::kNothing) {
            met = RigidScan::kNotMet;
            return;
          }
          RigidField::Touch felt = touch;
          if (!resists) felt.structure = static_cast<Structure>(in);
          met = std::max(0.0, std::min(met, -touch.distance));
          const double depth = -touch.distance - met;
          in = depth > 0 ? static_cast<std::uint8_t>(felt.structure) : RigidScan::kNothing;
          Vec6 direction;
          direction << touch.normal, arm.cross(touch.normal);
          const double comes =
              touch.part < 0 ? 0.0 : step_s * touch.normal.dot(parts[touch.part].velocity_at(touch.rest));
          // What does not fit among the springs that stop the tool is not counted among those that load it either.
          if (scan.near.add(direction, depth, kRigidStiffness, kRigidDamping, comes) && depth > 0) visit(arm, depth, felt);
        },
        [&](int part, double distance) {
          met_by(part) = distance < 0 ? RigidScan::kNotMet : 0.0;
          scan.pressed_in[i][static_cast<std::size_t>(part + 1)] = RigidScan::kNothing;
        });
    if (!(nearest < kRigidReach)) scan.next_check[i] = scan.travel + nearest - kRigidReach;
  }
}

}  // namespace

RigidContacts rigid_contacts(const RigidField& rigid, const PartPoses& parts, const ToolField& tool, double step_s,
                             RigidScan& scan, const Pose& pose) noexcept {
  RigidContacts out;
  std::array<double, kLoadedStructures> weight{};
  for_each_rigid_contact(rigid, parts, tool, step_s, scan, pose,
                         [&](const Vec3& arm, double depth, const RigidField::Touch& touch) {
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
  for_each_rigid_contact(rigid, parts, tool, step_s, scan, proxy.pose,
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
                         const ToolField& tool, RigidScan& scan, const HandState& hand, const Wrench& soft,
                         const Mat6& soft_stiffness, ProxyState& proxy) noexcept {
  move_coupled(settings, hand, soft, soft_stiffness, scan.near, proxy);
  return rigid_contacts(rigid, parts, tool, settings.step_s, scan, proxy.pose);
}

}  // namespace vallecula::engine
