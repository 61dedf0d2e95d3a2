// Everything about the soft body that changes from tick to tick, sized once.
#pragma once

#include <vector>

#include "engine/tissue/tissue_model.h"

namespace vallecula::engine {

/// 3x3 block, stored by columns (each with an unused lane), so that a product with a vector is three multiply-adds.
struct Block3 {
  F4 column[3] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
};

/// Rotations and stresses of a pack's four tetrahedra, filled by the element pass.
struct PackState {
  F4 quaternion[4];          ///< w x y z; warm start of the rotation
  F4 rotation[9];            ///< row major
  F4 deviatoric[9];          ///< R 2 mu (sym(R^T F) - I), row major, Pa
  F4 assembled_rotation[9];  ///< the rotation the stiffness blocks were last built with
};

/// Second level of the preconditioner (coarse_space.h).
struct CoarseState {
  std::vector<Vec3> centre;              ///< per group, m
  std::vector<Vec3> arm;                 ///< per coarse node, from its group's centre, m
  std::vector<double> base, factor;      ///< 6 groups squared, row major
  std::vector<double> vector;
  bool usable = false;
};

struct TissueState {
  explicit TissueState(const TissueModel& model);

  std::vector<Vec3> displacement;   ///< per node, m; anchored nodes follow their body
  std::vector<Vec3> velocity;       ///< per node, m/s; zero in anchored nodes
  std::vector<Vec3> body_displacement, body_velocity;  ///< per body: translation (m), or angle (rad) in x

  std::vector<PackState> packs;
  std::vector<Block3> stiffness;    ///< assembled K by block row
  std::int32_t refresh_at = 0;      ///< where the next tick's stiffness refresh begins

  CoarseState coarse;
  std::int64_t steps = 0;           ///< implicit steps taken since rest

  // Work space of a step: node vectors with the bodies' unknowns appended.
  std::vector<Float4> external;     ///< forces from outside in this tick, N; cleared by the step that used them
  std::vector<Float4> displacement_f, force, rhs, solution, residual, direction, product, preconditioned;
  std::vector<Block3> inverse_diagonal;
  std::vector<float> pressure;

  void set_rest(const TissueModel& model);
};

}  // namespace vallecula::engine
