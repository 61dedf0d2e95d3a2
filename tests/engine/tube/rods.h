// Rods for the tests: a straight, uniform one in a stiff hand, dead loads, and how long it is to beam theory.
#pragma once

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

}  // namespace vallecula::engine::testing
