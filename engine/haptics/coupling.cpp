#include "engine/haptics/coupling.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace vallecula::engine {

namespace {

// A hand on a blade turns it with no more than its force at this lever. A spring that turned without end levered a held
// blade into the gum with a hundred newtons, whatever the device could give.
constexpr double kTurningArm = 0.05;     // m (assumed: half a blade)
constexpr double kDampingShare = 0.7;    // of critical
constexpr double kVelocityFilter = 0.2;  // weight of the newest difference quotient
constexpr double kFastestHand = 2.0;     // m/s, and 20 rad/s: above it the damper takes the hand for this fast
constexpr int kPasses = 5;

double damping(double stiffness, double inertia) { return 2 * kDampingShare * std::sqrt(stiffness * inertia); }

}  // namespace

PushingSprings& PushingSprings::operator=(const PushingSprings& other) noexcept {
  count = other.count;
  std::copy_n(other.direction.begin(), count, direction.begin());
  std::copy_n(other.depth.begin(), count, depth.begin());
  std::copy_n(other.stiffness.begin(), count, stiffness.begin());
  std::copy_n(other.damping.begin(), count, damping.begin());
  std::copy_n(other.comes.begin(), count, comes.begin());
  return *this;
}

bool PushingSprings::add(const Vec6& along, double deep, double stiffness_n_m, double damping_n_s_m,
                         double way) noexcept {
  if (count == kMost) return false;
  direction[count] = along;
  depth[count] = deep;
  stiffness[count] = stiffness_n_m;
  damping[count] = damping_n_s_m;
  comes[count] = way;
  ++count;
  return true;
}

void PushingSprings::follow(const Vec6& move) noexcept {
  for (int i = 0; i < count; ++i) depth[i] -= direction[i].dot(move);
}

Vec3 PushingSprings::force() const noexcept {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < count; ++i) sum += stiffness[i] * std::max(0.0, depth[i]) * direction[i].head<3>();
  return sum;
}

Vec3 rotation_between(const Quat& from, const Quat& to) {
  Quat d = to * from.conjugate();
  if (d.w() < 0) d.coeffs() = -d.coeffs();
  const double s = d.vec().norm();
  if (s < 1e-12) return 2.0 * d.vec();
  return 2.0 * std::atan2(s, d.w()) / s * d.vec();
}

bool usable(const Pose& pose) noexcept {
  return pose.position.allFinite() && pose.rotation.coeffs().allFinite() && std::abs(pose.rotation.norm() - 1.0) < 1e-3;
}

Vec6 move_between(const Pose& from, const Pose& to) {
  Vec6 move;
  move << to.position - from.position, rotation_between(from.rotation, to.rotation);
  return move;
}

void follow_device(const Pose& device, double step_s, HandState& hand) noexcept {
  const Vec6 way = move_between(hand.device, device);
  const auto follow = [](const Vec3& quotient, double fastest, Vec3& velocity) {
    velocity += kVelocityFilter * (no_longer_than(quotient, fastest) - velocity);
  };
  follow(way.head<3>() / step_s, kFastestHand, hand.velocity.force);
  follow(way.tail<3>() / step_s, 10 * kFastestHand, hand.velocity.torque);
  hand.device = device;
}

Wrench coupling_wrench(const ProxySettings& settings, const Pose& proxy, const Pose& device, double scale) {
  Wrench w;
  w.force = scale * settings.stiffness_n_m * (device.position - proxy.position);
  w.torque = scale * settings.rotation_nm_rad * rotation_between(proxy.rotation, device.rotation);
  return w;
}

Vec6 move_coupled(const ProxySettings& settings, const HandState& hand, const Wrench& extra, const Mat6& stiffness,
                  const PushingSprings& springs, ProxyState& proxy) noexcept {
  const double h = settings.step_s;
  const double k = settings.stiffness_n_m * hand.scale, kr = settings.rotation_nm_rad * hand.scale;
  const double b = damping(k, settings.mass_kg), br = damping(kr, settings.inertia_kg_m2);

  Wrench pull = coupling_wrench(settings, proxy.pose, hand.device, hand.scale);
  const double strength = pull.force.norm();
  if (strength > hand.force_limit_n) {
    pull.force *= hand.force_limit_n / strength;
    pull.torque *= hand.force_limit_n / strength;
  }
  pull.torque = no_longer_than(pull.torque, settings.force_limit_n * kTurningArm);
  Mat6 matrix = stiffness;
  Vec6 right;
  matrix.diagonal().head<3>().array() += settings.mass_kg / (h * h) + b / h + k;
  matrix.diagonal().tail<3>().array() += settings.inertia_kg_m2 / (h * h) + br / h + kr;
  right.head<3>() = settings.mass_kg / h * proxy.velocity + b * hand.velocity.force + pull.force + extra.force;
  right.tail<3>() =
      settings.inertia_kg_m2 / h * proxy.angular_velocity + br * hand.velocity.torque + pull.torque + extra.torque;
  // Which springs push at the end of the move is found by trying (a few passes settle it).
  std::array<bool, PushingSprings::kMost> pushes;
  for (int i = 0; i < springs.count; ++i) pushes[i] = springs.depth[i] + springs.comes[i] > 0;
  Vec6 move = Vec6::Zero();
  for (int pass = 0; pass < kPasses; ++pass) {
    Mat6 with = matrix;
    Vec6 load = right;
    for (int i = 0; i < springs.count; ++i) {
      if (!pushes[i]) continue;
      with += (springs.stiffness[i] + springs.damping[i] / h) * springs.direction[i] * springs.direction[i].transpose();
      load += (springs.stiffness[i] * (springs.depth[i] + springs.comes[i]) + springs.damping[i] / h * springs.comes[i]) *
              springs.direction[i];
    }
    move = with.llt().solve(load);
    bool changed = false;
    for (int i = 0; i < springs.count; ++i) {
      const bool push = springs.depth[i] + springs.comes[i] - springs.direction[i].dot(move) > 0;
      changed |= push != pushes[i];
      pushes[i] = push;
    }
    if (!changed) break;
  }
  proxy.velocity = move.head<3>() / h;
  proxy.angular_velocity = move.tail<3>() / h;
  proxy.pull.force = pull.force - k * move.head<3>() + b * (hand.velocity.force - proxy.velocity);
  proxy.pull.torque = pull.torque - kr * move.tail<3>() + br * (hand.velocity.torque - proxy.angular_velocity);
  proxy.pose.position += move.head<3>();
  const Vec3 turn = move.tail<3>();
  const double angle = turn.norm();
  if (angle > 1e-15) {
    const Vec3 axis = turn / angle;
    proxy.pose.rotation = Quat(Eigen::AngleAxisd(angle, axis)) * proxy.pose.rotation;
    proxy.pose.rotation.normalize();
  }
  return move;
}

}  // namespace vallecula::engine
