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
  std::int32_t sphere = -1;
  bool active = false;
};

}  // namespace vallecula::engine
