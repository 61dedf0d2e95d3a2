#include "gui/session/soft_boundary.h"

#include <algorithm>
#include <map>

namespace vallecula::gui {

SoftBoundary soft_boundary(const pipeline::TetMesh& mesh) {
  // A face that belongs to one tetrahedron only is boundary; the order of its corners faces outward.
  std::map<std::array<int, 3>, std::array<int, 3>> open;
  for (const auto& t : mesh.tets) {
    const std::array<std::array<int, 3>, 4> faces{
        {{t[0], t[2], t[1]}, {t[0], t[1], t[3]}, {t[1], t[2], t[3]}, {t[0], t[3], t[2]}}};
    for (const auto& face : faces) {
      auto key = face;
      std::sort(key.begin(), key.end());
      const auto [found, fresh] = open.emplace(key, face);
      if (!fresh) open.erase(found);
    }
  }
  SoftBoundary boundary;
  std::vector<int> point_of(mesh.points.size(), -1);
  for (const auto& [key, face] : open) {
    std::array<int, 3> triangle{};
    for (int corner = 0; corner < 3; ++corner) {
      int& point = point_of[face[corner]];
      if (point < 0) {
        point = static_cast<int>(boundary.node.size());
        boundary.node.push_back(face[corner]);
      }
      triangle[corner] = point;
    }
    boundary.triangles.push_back(triangle);
  }
  return boundary;
}

}  // namespace vallecula::gui
