// The soft body as the solver sees it: element data in packs of eight, the sparsity of its stiffness, masses, anchors.
// Fixed during a trial; what changes is TissueState.
//
// Elasticity: corotational tetrahedra whose volume is averaged at the nodes (Bonet and Burton 1998), since plain linear
// tetrahedra lock as nu nears 0.5. Per material and node n
//   energy = sum_t V_t mu |sym(R^T F) - 1|^2 + 1/2 sum_n lambda V_n (Jn - 1)^2,
//   Jn = sum_{t at n} (V_t/4) det F_t / V_n.
// The volumetric part measures det F (as the fixed corotated energy of Stomakhin et al. 2012 does), not the trace of the
// corotated strain: by the trace a tongue pressed by a third of its thickness loses 8 % of its volume without knowing.
//
// Beyond a band the whole body keeps its volume: a muscle is a bag of water, nu below 0.5 is what the elements can bear.
// A uniform pressure over the nearly incompressible tissue holds the loss of the whole at kVolumeBand; small presses never
// meet it.
#pragma once

#include <vector>

#include "engine/scene.h"
#include "engine/tissue/lanes.h"

namespace vallecula::engine {

struct TetPack {
  std::int32_t node[4][kLanes];      ///< [corner][lane]
  std::int32_t pressure[4][kLanes];  ///< [corner][lane]: index of the (node, material) pair whose pressure the corner feels
  std::int32_t tet[kLanes];          ///< index in the description; -1 in lanes that only pad the last pack
  F8 gradient[4][3];                 ///< rest shape gradients [corner][axis], 1/m
  F8 volume;                         ///< m^3; zero in padding lanes
  F8 mu, lambda;                     ///< Pa
  F8 guarded;                        ///< 1 in tissue that is kept from being squashed, 0 in stiff leaves: they bend
  F8 tolerance;                      ///< change of rotation and cofactor (squared norm) that renews the stiffness
};

struct TissueModel {
  TissueModel(const SoftBodyDescription& soft, double step_s, bool hold_volume = true);

  int nodes = 0;
  int tets = 0;
  double step_s = 0.001;
  std::vector<Vec3> rest;               ///< per node, m
  std::vector<float> mass;              ///< lumped, kg, per node
  std::vector<TetPack> packs;           ///< tetrahedra of which a node can move
  std::vector<float> pressure_lambda;   ///< per (node, material) pair, Pa
  std::vector<float> pressure_inverse_volume;
  std::vector<float> pressure_held;     ///< per pair: 1 where the material takes part in the volume hold, else 0
  double held_volume = 0.0;             ///< at rest, of what takes part, m^3; 0: the volume is not held
  double held_lambda = 0.0;             ///< mean of its lambda, Pa

  /// Block rows of the stiffness: row i has blocks row_start[i] .. row_start[i+1]; column indices ascend. Nodes fastened
  /// to a fixed body have no row, and no one's row has them. Blocks are stored in pairs (tissue_state.h), so that rows
  /// begin and end at even indices; a block that only pads has its own row's column.
  std::vector<std::int32_t> row_start, column, diagonal;
  std::vector<std::array<std::int32_t, 16>> tet_block;  ///< per pack and lane: block of (corner i, corner j) at 4 i + j, or -1
  std::vector<std::int32_t> moving;     ///< nodes with a row, ascending

  std::vector<SprungBody> bodies;
  std::vector<std::int8_t> anchor;          ///< per node, -1 free
  struct AnchoredNode {
    std::int32_t node, body;
    F4 arm;                                 ///< hinge: displacement of the node per radian, m/rad
  };
  std::vector<AnchoredNode> anchored;       ///< to bodies that move
  std::vector<std::int32_t> fixed_nodes;    ///< anchored to bodies that do not

  /// Coarse space of the preconditioner (coarse_space.h): free nodes of the stiff tissue in groups of neighbours. Empty
  /// for a body of one material.
  struct CoarseNode {
    std::int32_t node, group;
  };
  std::vector<CoarseNode> coarse_nodes;
  std::vector<std::int32_t> coarse_index;  ///< per node: its place in coarse_nodes, -1 none
  std::vector<std::int32_t> coarse_count;  ///< per group: nodes
  int coarse_groups = 0;

  /// Rayleigh damping, D = alpha M + beta K: light, so that a released tongue settles within about 0.2 s (assumed).
  static constexpr float kMassDamping = 4.0f;        // 1/s
  static constexpr float kStiffnessDamping = 0.0005f;  // s

  /// Share of the whole volume that may be lost before the pressure answers: more than the presses that the law is held
  /// to against the continuum lose, less than the hundredth that a tongue may.
  static constexpr double kVolumeBand = 0.007;
  static constexpr double kHeldFromPoisson = 0.4;  ///< tissue that is more compressible is meant to lose volume

  /// A tetrahedron of the softest tissue gets new stiffness blocks once it has turned by 4 degrees or been strained by 7
  /// hundredths (squared norm of both changes); stiffer tissue sooner, in inverse proportion: blocks that lag behind a
  /// turning cartilage make its steps unstable (seen on a leaf of 200 kPa on muscle of 6 kPa).
  static constexpr double kRefreshTolerance = 5e-3;

  /// True for nodes fastened to a body that never moves.
  bool fixed(int node) const {
    return anchor[node] >= 0 && bodies[anchor[node]].motion == SprungBody::Motion::fixed;
  }

 private:
  void build_coarse_space(const SoftBodyDescription& soft);
};

}  // namespace vallecula::engine
