#include "engine/aist/thinned_areas.h"

#include <cmath>
#include <map>

namespace vallecula::engine {

std::vector<float> thinned_areas(const SphereTree& tree, const SoftSurface& surface, const std::vector<Vec3>& nodes,
                                 double spacing_m) {
  std::vector<std::int32_t> order;  // vertices first: they carry the force
  std::vector<Vec3> point(tree.spheres.size(), Vec3::Zero());
  for (const bool vertices : {true, false})
    for (std::size_t s = 0; s < tree.spheres.size(); ++s) {
      const InnerSphere& sphere = tree.spheres[s];
      if (sphere.core || (sphere.standoff == 0.0) != vertices) continue;
      for (int k = 0; k < 3; ++k) point[s] += sphere.surface_weight[k] * nodes[surface.triangles[sphere.triangle][k]];
      order.push_back(static_cast<std::int32_t>(s));
    }
  using Cell = std::array<long long, 3>;
  std::map<Cell, std::vector<std::int32_t>> taken;
  const auto cell_of = [spacing_m](const Vec3& p) {
    return Cell{std::llround(p.x() / spacing_m), std::llround(p.y() / spacing_m), std::llround(p.z() / spacing_m)};
  };
  const auto nearest_taken = [&](std::int32_t s) {
    std::int32_t nearest = -1;
    double nearest_m = spacing_m;
    const Cell at = cell_of(point[s]);
    for (int n = 0; n < 27; ++n) {
      const auto cell = taken.find(Cell{at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1});
      if (cell == taken.end()) continue;
      for (std::int32_t t : cell->second) {
        const double away = (point[t] - point[s]).norm();
        if (away >= nearest_m) continue;
        nearest_m = away;
        nearest = t;
      }
    }
    return nearest;
  };
  std::vector<float> area(tree.spheres.size(), 0.0f);
  for (std::int32_t s : order) {
    const InnerSphere& sphere = tree.spheres[s];
    const std::int32_t other = sphere.standoff == 0.0 ? -1 : nearest_taken(s);
    area[other < 0 ? s : other] += static_cast<float>(sphere.area);
    if (other < 0) taken[cell_of(point[s])].push_back(s);
  }
  for (std::size_t s = 0; s < area.size(); ++s)
    if (!tree.spheres[s].touchable) area[s] = 0.0f;
  return area;
}

}  // namespace vallecula::engine
