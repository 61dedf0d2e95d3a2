// Rods for the tests: a straight, uniform one in a stiff hand and how long it is to beam theory, a usual tube; dead
// loads, planes.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "engine/tube/tube_design.h"

namespace vallecula::engine::testing {

constexpr double kEi = 4e-4;  // N m^2: about a 3.5 tube's

/// Straight, in a hand so stiff that it counts as a clamp.
inline RodDescription straight_rod(double length_m = 0.12) {
  RodDescription d;
  d.length_m = length_m;
  for (RodSection& s : d.section) s = {kEi, 0.7 * kEi, 0.0};
  d.grip_n_m = 1e6;
  d.grip_nm_rad = 1e3;
  return d;
}

/// The hand clamps the last segment, whose middle is where bending begins.
inline double free_length(const Rod& rod) { return rod.description().length_m - rod.segment_m() / 2; }

/// A spring so soft and so far drawn that it pushes a node with the same force wherever it goes.
inline RodContact dead_load(int node, const Vec3& force) {
  RodContact c;
  c.node = node;
  c.normal = force.normalized();
  c.stiffness_n_m = 1e-6;
  c.depth_m = force.norm() / c.stiffness_n_m;
  return c;
}

/// Steps with the hand and the loads standing still.
inline RodStep settle(const Rod& rod, RodState& state, const Pose& grip, std::vector<RodContact> loads, int steps) {
  RodStep r;
  for (int n = 0; n < steps; ++n) r = step(rod, state, grip, loads.data(), static_cast<int>(loads.size()), 0.001);
  return r;
}

inline Rod usual_tube() {
  const TubeDesign tube = tube_design("3.5");
  return Rod(tube_rod(tube, nullptr, usual_grip_from_tip(tube)));
}

inline Pose turned(double angle) {
  Pose p;
  p.rotation = Eigen::AngleAxisd(angle, Vec3::UnitX());
  return p;
}

inline double fastest(const RodState& s) {
  double most = 0.0;
  for (const Vec3& v : s.velocity) most = std::max(most, v.norm());
  return most;
}

/// Points along the rod against the plane n x = 0, which they must stay above by the tube's radius.
inline int plane_contacts(const Rod& rod, const RodState& s, const Vec3& normal, double offset, double friction,
                          std::array<RodContact, kTubeNodes>& contacts) {
  for (int i = 0; i < kTubeNodes; ++i) {
    RodContact& c = contacts[i];
    c = RodContact{};
    c.node = std::min(i, kTubeNodes - 2);
    c.weight = i == kTubeNodes - 1 ? 1.0 : 0.0;
    c.normal = normal;
    c.depth_m = rod.description().outer_radius_m - (normal.dot(s.position[i]) - offset);
    c.friction = friction;
  }
  return kTubeNodes;
}

inline bool same_bits(const RodState& a, const RodState& b) {
  return std::memcmp(a.position.data(), b.position.data(), sizeof a.position) == 0 &&
         std::memcmp(a.velocity.data(), b.velocity.data(), sizeof a.velocity) == 0 &&
         std::memcmp(a.rotation.data(), b.rotation.data(), sizeof a.rotation) == 0;
}

}  // namespace vallecula::engine::testing
