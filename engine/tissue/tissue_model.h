// The soft body as the solver sees it: element data in packs of four, the sparsity of its stiffness, masses, anchors.
// Fixed during a trial; what changes is TissueState.
//
// Elasticity: corotational linear tetrahedra (Mueller and Gross 2004) with the volumetric part averaged at the nodes
// (Bonet and Burton 1998), since plain linear tetrahedra lock as nu nears 0.5. Per material and node n
//   energy = sum_t V_t mu |sym(R^T F) - I|^2 + 1/2 sum_n lambda V_n theta_n^2,
//   theta_n = sum_{t at n} (V_t/4) tr(R^T F - I) / V_n.
#pragma once

#include <vector>

#include "engine/scene.h"
#include "engine/tissue/float4.h"

namespace vallecula::engine {

struct TetPack {
  std::int32_t node[4][4];      ///< [corner][lane]
  std::int32_t pressure[4][4];  ///< [corner][lane]: index of the (node, material) pair whose pressure the corner feels
  F4 gradient[4][3];            ///< rest shape gradients [corner][axis], 1/m
  F4 volume;                    ///< m^3; zero in lanes that only pad the last pack
  F4 mu, lambda;                ///< Pa
};

struct TissueModel {
  explicit TissueModel(const SoftBodyDescription& soft, double step_s);

  int nodes = 0;
  int tets = 0;
  double step_s = 0.001;
  std::vector<Vec3> rest;               ///< per node, m
  std::vector<float> mass;              ///< lumped, kg, per node
  std::vector<TetPack> packs;
  std::vector<float> pressure_lambda;   ///< per (node, material) pair, Pa
  std::vector<float> pressure_inverse_volume;

  /// Block rows of the stiffness: row i has blocks row_start[i] .. row_start[i+1]; column indices ascend.
  std::vector<std::int32_t> row_start, column, diagonal;
  std::vector<std::array<std::int32_t, 16>> tet_block;  ///< per tet: block index of (corner i, corner j) at 4 i + j

  std::vector<SprungBody> bodies;
  std::vector<std::int8_t> anchor;          ///< per node, -1 free
  struct AnchoredNode {
    std::int32_t node, body;
    F4 arm;                                 ///< hinge: displacement of the node per radian, m/rad
  };
  std::vector<AnchoredNode> anchored;

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

 private:
  void build_coarse_space(const SoftBodyDescription& soft);
};

}  // namespace vallecula::engine
