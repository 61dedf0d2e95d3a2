#include "engine/mesh/soft_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

namespace vallecula::engine {

double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a) / 6.0;
}

Eigen::Matrix<double, 3, 4> shape_gradients(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Mat3 edges;
  edges << b - a, c - a, d - a;
  const Mat3 inverse = edges.inverse();  // rows: gradients of the functions of b, c and d
  Eigen::Matrix<double, 3, 4> gradients;
  gradients.rightCols<3>() = inverse.transpose();
  gradients.col(0) = -(gradients.col(1) + gradients.col(2) + gradients.col(3));
  return gradients;
}

SoftSurface extract_surface(const std::vector<std::array<int, 4>>& tets) {
  static constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};  // outward for positive tets
  std::map<std::array<int, 3>, std::pair<int, int>> faces;                           // sorted corners -> tet, face
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      std::array<int, 3> key = {tets[t][kFaces[f][0]], tets[t][kFaces[f][1]], tets[t][kFaces[f][2]]};
      std::sort(key.begin(), key.end());
      const auto [it, fresh] = faces.try_emplace(key, static_cast<int>(t), f);
      if (!fresh) it->second.first = -1;  // shared by two tetrahedra: inside
    }
  SoftSurface surface;
  for (const auto& [key, owner] : faces) {
    if (owner.first < 0) continue;
    const auto& tet = tets[owner.first];
    const auto& face = kFaces[owner.second];
    surface.triangles.push_back({tet[face[0]], tet[face[1]], tet[face[2]]});
    surface.tet.push_back(owner.first);
  }
  return surface;
}

void check_soft_body(const SoftBodyDescription& soft) {
  const auto fail = [](const std::string& what) { throw std::invalid_argument("soft body: " + what); };
  const int nodes = static_cast<int>(soft.nodes.size());
  if (soft.tets.empty()) fail("it has no tetrahedra");
  if (soft.tet_material.size() != soft.tets.size() || soft.tet_structure.size() != soft.tets.size())
    fail("a material and a structure are needed for each tetrahedron");
  if (soft.node_anchor.size() != soft.nodes.size()) fail("an anchor is needed for each node");
  for (int i = 0; i < nodes; ++i) {
    if (!soft.nodes[i].allFinite()) fail("node " + std::to_string(i) + " is not finite");
    if (soft.node_anchor[i] >= static_cast<int>(soft.bodies.size()))
      fail("node " + std::to_string(i) + " is anchored to body " + std::to_string(soft.node_anchor[i]) +
           ", which does not exist");
  }
  for (std::size_t m = 0; m < soft.materials.size(); ++m) {
    const TissueMaterial& material = soft.materials[m];
    const std::string name = "material " + std::to_string(m);
    if (!(material.young_pa > 0) || !std::isfinite(material.young_pa))
      fail(name + ": Young's modulus " + std::to_string(material.young_pa) + " Pa; it must be above 0");
    if (!(material.poisson >= 0 && material.poisson < 0.5))
      fail(name + ": Poisson's ratio " + std::to_string(material.poisson) + "; it must be 0 or more and below 0.5");
    if (!(material.density_kg_m3 > 0) || !std::isfinite(material.density_kg_m3))
      fail(name + ": density " + std::to_string(material.density_kg_m3) + " kg/m3; it must be above 0");
  }
  std::vector<char> used(soft.nodes.size(), 0);
  for (std::size_t t = 0; t < soft.tets.size(); ++t) {
    for (int v : soft.tets[t]) {
      if (v < 0 || v >= nodes)
        fail("tetrahedron " + std::to_string(t) + " names node " + std::to_string(v) + " of " + std::to_string(nodes));
      used[v] = 1;
    }
    if (soft.tet_material[t] >= soft.materials.size())
      fail("tetrahedron " + std::to_string(t) + " names material " + std::to_string(soft.tet_material[t]));
    const auto& k = soft.tets[t];
    const double volume = tet_volume(soft.nodes[k[0]], soft.nodes[k[1]], soft.nodes[k[2]], soft.nodes[k[3]]);
    if (!(volume > 0))
      fail("tetrahedron " + std::to_string(t) + " has the volume " + std::to_string(volume * 1e9) +
           " mm3; it must be above 0 (inverted or flat)");
  }
  for (int i = 0; i < nodes; ++i)
    if (!used[i]) fail("node " + std::to_string(i) + " belongs to no tetrahedron");
}

}  // namespace vallecula::engine
