#include "pipeline/exchange/placement.h"

#include <algorithm>

namespace vallecula::pipeline {

double Placement::voxel_mm3() const { return std::abs(dot(cross(step[0], step[1]), step[2])); }

Placement placement_of(const Grid& grid) {
  Placement place;
  place.size = grid.size;
  place.origin = grid.origin;
  for (int a = 0; a < 3; ++a) {
    place.step[a] = {};
    place.step[a][a] = grid.spacing[a];
  }
  return place;
}

std::array<Vector3, 3> index_rows(const Placement& place) {
  const double d = dot(cross(place.step[0], place.step[1]), place.step[2]);
  return {(1.0 / d) * cross(place.step[1], place.step[2]), (1.0 / d) * cross(place.step[2], place.step[0]),
          (1.0 / d) * cross(place.step[0], place.step[1])};
}

bool same_place(const Placement& a, const Placement& b) {
  if (a.size != b.size) return false;
  const auto spacing = a.spacing();
  const double close = 0.01 * std::min({spacing[0], spacing[1], spacing[2]});
  for (int corner = 0; corner < 8; ++corner) {
    const double i = (corner & 1) != 0 ? a.size[0] - 1 : 0;
    const double j = (corner & 2) != 0 ? a.size[1] - 1 : 0;
    const double k = (corner & 4) != 0 ? a.size[2] - 1 : 0;
    if (distance(a.position(i, j, k), b.position(i, j, k)) > close) return false;
  }
  return true;
}

}  // namespace vallecula::pipeline
