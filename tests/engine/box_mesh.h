// Structured tetrahedral blocks for tests: each cell of a grid split into six tetrahedra about its diagonal.
#pragma once

#include <map>

#include "engine/scene.h"

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

/// Closed box surface centred at `centre`.
inline TriangleMesh box_surface(const Vec3& centre, const Vec3& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back(centre + 0.5 * Vec3((i & 1) ? size.x() : -size.x(), (i & 2) ? size.y() : -size.y(),
                                              (i & 4) ? size.z() : -size.z()));
  static constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : kFaces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

/// Closed sphere about the origin: an octahedron whose faces are halved along every edge `rings` times.
inline TriangleMesh sphere_surface(double radius, int rings) {
  TriangleMesh mesh;
  mesh.points = {Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitZ()};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int ring = 0; ring < rings; ++ring) {
    std::map<std::pair<int, int>, int> middle;
    const auto halve = [&](int a, int b) {
      const auto [it, fresh] = middle.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.points.size()));
      if (fresh) mesh.points.push_back((mesh.points[a] + mesh.points[b]).normalized());
      return it->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = halve(a, b), bc = halve(b, c), ca = halve(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& p : mesh.points) p *= radius;
  return mesh;
}

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
