// Everything about the soft body that changes from tick to tick, sized once.
#pragma once

#include <cstring>
#include <vector>

#include "engine/tissue/tissue_model.h"

namespace vallecula::engine {

/// 3x3 block, stored by columns (each with an unused lane), so that a product with a vector is three multiply-adds.
struct Block3 {
  F4 column[3] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
};

/// Two 3x3 blocks side by side: lanes 0-2 of each column are the first's, 4-6 the second's; lanes 3 and 7 are zero.
struct BlockPair {
  F8 column[3] = {};
  Block3 block(int half) const {
    Block3 b;
    for (int k = 0; k < 3; ++k) b.column[k] = half == 0 ? low_half(column[k]) : high_half(column[k]);
    return b;
  }
  void add(int half, int k, F4 to_column) {
    char* at = reinterpret_cast<char*>(&column[k]) + sizeof(F4) * static_cast<std::size_t>(half);
    F4 own;
    std::memcpy(&own, at, sizeof own);
    own += to_column;
    std::memcpy(at, &own, sizeof own);
  }
};

/// Rotations and stresses of a pack's tetrahedra, filled by the element pass.
struct PackState {
  F8 quaternion[4];   ///< w x y z; warm start of the rotation
  F8 rotation[9];     ///< row major
  F8 cofactor[9];     ///< of F: d(det F)/dF, row major
  F8 deviatoric[9];   ///< R 2 mu (sym(R^T F) - 1), row major, Pa
  F8 pressure;        ///< lambda (Jn - 1), mean of the corners, and the barrier, Pa
  F8 barrier;         ///< pressure of a tetrahedron squashed below the least volume, Pa
  F8 hardening;       ///< the barrier's share of cubic growth
};

/// What a pack's stiffness blocks were last built with.
struct PackAssembly {
  F8 rotation[9];
  F8 cofactor[9];
  F8 pressure;        ///< its size, Pa
  F8 hardening;
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

  double held_pressure = 0.0;       ///< of the volume hold, summed over time, Pa; negative presses outwards

  bool tangled = false;             ///< turned inside out somewhere: the plain law until it is whole again

  /// What rigid contacts ask of the bodies in this tick: load (N, or N m in x) and how it falls as the body gives way (N/m or
  /// N m/rad). Whoever finds the contacts sets both anew each tick.
  std::vector<Vec3> body_load;
  std::vector<double> body_load_stiffness;

  double fastest_m = 0.0;           ///< the farthest way of a node in the last step, m

  std::vector<PackState> packs;
  std::vector<PackAssembly> assembly;
  std::vector<BlockPair> stiffness; ///< assembled K by block row, two blocks an entry
  std::int32_t refresh_at = 0;      ///< where the next tick's stiffness refresh begins

  /// Inverses of the system's diagonal blocks (the preconditioner), kept between ticks; `stale` marks nodes whose block
  /// has changed.
  std::vector<Block3> inverse_diagonal;
  std::vector<char> stale;
  std::vector<Block3> contact_diagonal;      ///< work space: diagonal blocks of the nodes in contact
  std::vector<std::int32_t> contact_nodes;   ///< the first contact_node_count are this tick's
  std::vector<char> in_contact;
  std::int32_t contact_node_count = 0;

  CoarseState coarse;
  std::int64_t steps = 0;           ///< implicit steps taken since rest

  // Work space of a step: node vectors with the bodies' unknowns appended, an even number of entries.
  std::vector<Float4> external;     ///< forces from outside in this tick, N; cleared by the step that used them
  std::vector<Float4> displacement_f, force, rhs, solution, residual, direction, product, preconditioned;
  std::vector<float> pressure;

  Block3 stiffness_block(std::int32_t b) const { return stiffness[b / 2].block(b % 2); }
  void set_rest(const TissueModel& model);
};

}  // namespace vallecula::engine
