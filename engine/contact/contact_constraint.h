// One contact between the tool and a point of the tissue's surface, as the solver takes it.
#pragma once

#include <vector>

#include "engine/tissue/float4.h"

namespace vallecula::engine {

/// gap(du) = gap + normal . sum_i weight_i du_i >= 0, over the displacement increments du in this tick of the nodes
/// that carry the point: a surface triangle's three (the fourth weight is zero) or a tetrahedron's four. The multiplier is the magnitude of the contact force (N).
struct ContactConstraint {
  std::int32_t node[4];
  float weight[4];
  F4 normal;               ///< out of the tool into the tissue, world
  float gap = 0.0f;        ///< at the start of the tick, with the tool at its new pose, m
  float stiffness = 0.0f;  ///< of the augmented Lagrangian, N/m
  float multiplier = 0.0f; ///< N; before the step what the sphere kept of earlier ticks, after it the contact's force
  F4 slip = {0, 0, 0, 0};  ///< across the normal: how far the point is ahead of where it sticks to the tool, m, world
  F4 friction = {0, 0, 0, 0};  ///< after the step: the tool's friction on the tissue, N, world
  float grip = 0.0f;       ///< stiffness of sticking, N/m; 0: no friction
  float friction_limit = 0.0f;  ///< mu times the normal force of the last tick, N
  bool sticks = false;     ///< in this tick's system; else it slides with the limit's force
  std::int32_t triangle = -1;  ///< of the tissue's surface: says what kind of tissue is touched
  std::int32_t memory = -1;    ///< place in ContactState::memory; -1: nothing is remembered
  bool active = false;
};

}  // namespace vallecula::engine
