#include "pipeline/mesh/tet_quality.h"

#include <algorithm>

#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {

double signed_volume(const TetMesh& mesh, const std::array<int, 4>& t) {
  const Vector3 a = mesh.points[t[0]];
  return dot(cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a), mesh.points[t[3]] - a) / 6.0;
}

std::array<double, 2> dihedral_range(const std::array<Point, 4>& p) {
  constexpr double kDegree = 57.29577951308232;
  std::array<double, 2> range{180.0, 0.0};
  constexpr int kEdges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
  for (const auto& e : kEdges) {
    const auto axis = unit(p[e[1]] - p[e[0]]);
    auto u = p[e[2]] - p[e[0]];
    auto v = p[e[3]] - p[e[0]];
    u = unit(u - dot(u, axis) * axis);
    v = unit(v - dot(v, axis) * axis);
    const double angle = kDegree * std::acos(std::clamp(dot(u, v), -1.0, 1.0));
    range[0] = std::min(range[0], angle);
    range[1] = std::max(range[1], angle);
  }
  return range;
}

TetQuality quality_of(const TetMesh& mesh) {
  TetQuality q;
  q.smallest_volume_mm3 = 1e300;
  q.shortest_edge_mm = 1e300;
  for (const auto& t : mesh.tets) {
    const double v = signed_volume(mesh, t);
    q.volume_mm3 += v;
    q.smallest_volume_mm3 = std::min(q.smallest_volume_mm3, v);
    const std::array<Point, 4> corner{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]};
    const auto range = dihedral_range(corner);
    q.smallest_dihedral_deg = std::min(q.smallest_dihedral_deg, range[0]);
    q.largest_dihedral_deg = std::max(q.largest_dihedral_deg, range[1]);
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) q.shortest_edge_mm = std::min(q.shortest_edge_mm, distance(corner[i], corner[j]));
    }
  }
  return q;
}

}  // namespace vallecula::pipeline
