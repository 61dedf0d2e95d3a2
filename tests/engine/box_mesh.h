// Structured tetrahedral blocks for tests: each cell of a grid split into six tetrahedra about its diagonal.
#pragma once

#include "engine/scene.h"
#include "engine/tool/shapes.h"

namespace vallecula::engine::testing {

/// Block [0, size] with `cells` cells along each axis; one material; nodes with z = 0 fixed (anchored to a fixed body).
inline SoftBodyDescription box_body(const Vec3& size, const std::array<int, 3>& cells, const TissueMaterial& material) {
  SoftBodyDescription soft;
  const int nx = cells[0] + 1, ny = cells[1] + 1, nz = cells[2] + 1;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        soft.nodes.emplace_back(size.x() * i / cells[0], size.y() * j / cells[1], size.z() * k / cells[2]);
  const auto at = [&](int i, int j, int k) { return (k * ny + j) * nx + i; };
  static constexpr int kPaths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i)
        for (int p = 0; p < 6; ++p) {
          int c[3] = {i, j, k};
          std::array<int, 4> tet;
          tet[0] = at(c[0], c[1], c[2]);
          for (int s = 0; s < 3; ++s) {
            ++c[kPaths[p][s]];
            tet[s + 1] = at(c[0], c[1], c[2]);
          }
          if (p >= 3) std::swap(tet[2], tet[3]);  // odd permutations turn the tetrahedron inside out
          soft.tets.push_back(tet);
        }
  soft.materials = {material};
  soft.tet_material.assign(soft.tets.size(), 0);
  soft.tet_structure.assign(soft.tets.size(), Structure::tongue);
  soft.node_anchor.assign(soft.nodes.size(), -1);
  soft.bodies = {SprungBody{}};
  for (std::size_t i = 0; i < soft.nodes.size(); ++i)
    if (soft.nodes[i].z() == 0) soft.node_anchor[i] = 0;
  return soft;
}

using engine::box_surface;
using engine::sphere_surface;

/// A block of tissue with a plate for a tool, no rigid anatomy, a glottis beneath it: the least scene that steps.
inline SceneDescription block_scene(double young_pa = 6000.0, double poisson = 0.45) {
  SceneDescription d;
  d.soft = box_body(Vec3(0.03, 0.03, 0.015), {10, 10, 5}, {young_pa, poisson, 1040.0});
  d.tool.surface = box_surface(Vec3(0, 0, 0.0015), Vec3(0.06, 0.06, 0.003));  // its lower face at the pose
  d.sight.eye = Vec3(0.015, 0.015, 0.3);
  d.sight.glottis_outline = {Vec3(0.014, 0.014, -0.01), Vec3(0.016, 0.014, -0.01), Vec3(0.015, 0.017, -0.01)};
  return d;
}

}  // namespace vallecula::engine::testing
