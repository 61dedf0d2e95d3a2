#include "pipeline/mesh/lattice.h"

#include <algorithm>
#include <unordered_map>

#include "pipeline/mesh/triangle_tree.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

/// Points by cells of a coarse grid, to ask for neighbours.
class Buckets {
 public:
  explicit Buckets(double size) : size_(size) {}
  void add(const Point& p) { cells_[key(cell(p))].push_back(p); }
  bool any_within(const Point& p, double radius) const {
    const auto c = cell(p);
    const int reach = static_cast<int>(std::ceil(radius / size_));
    for (int z = -reach; z <= reach; ++z) {
      for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
          const auto found = cells_.find(key({c[0] + x, c[1] + y, c[2] + z}));
          if (found == cells_.end()) continue;
          for (const auto& q : found->second) {
            if (distance(p, q) < radius) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  std::array<int, 3> cell(const Point& p) const {
    return {static_cast<int>(std::floor(p[0] / size_)), static_cast<int>(std::floor(p[1] / size_)),
            static_cast<int>(std::floor(p[2] / size_))};
  }
  static std::uint64_t key(const std::array<int, 3>& c) {
    std::uint64_t k = 0;
    for (const int v : c) k = (k << 21) | (static_cast<std::uint64_t>(v + (1 << 20)) & 0x1fffff);
    return k;
  }
  double size_;
  std::unordered_map<std::uint64_t, std::vector<Point>> cells_;
};

}  // namespace

std::vector<Point> lattice_inside(const Surface& surface, const std::function<double(const Point&)>& edge_mm) {
  const SurfaceDistance border(surface);
  Point low = surface.points.front();
  Point high = low;
  double finest = 1e300;
  double coarsest = 0.0;
  for (const auto& p : surface.points) {
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
    finest = std::min(finest, edge_mm(p));
    coarsest = std::max(coarsest, edge_mm(p));
  }
  // Inner places may want longer edges than any of the surface's.
  for (double z = low[2]; z <= high[2]; z += finest) {
    for (double y = low[1]; y <= high[1]; y += finest) {
      for (double x = low[0]; x <= high[0]; x += finest) coarsest = std::max(coarsest, edge_mm({x, y, z}));
    }
  }
  std::vector<Point> points;
  Buckets taken(coarsest);
  for (double level = coarsest;; level /= 1.5) {
    const double side = 1.1 * level;  // cube of the lattice whose mean edge is `level`
    for (int half = 0; half < 2; ++half) {
      for (double z = low[2] + 0.5 * half * side; z <= high[2]; z += side) {
        for (double y = low[1] + 0.5 * half * side; y <= high[1]; y += side) {
          for (double x = low[0] + 0.5 * half * side; x <= high[0]; x += side) {
            const Point p{x, y, z};
            const double wanted = edge_mm(p);
            if (wanted > level * 1.001 * 1.5 || (wanted < level / 1.5 && level > finest)) continue;
            if (-border.at(p) < 0.6 * wanted || taken.any_within(p, 0.8 * wanted)) continue;
            points.push_back(p);
            taken.add(p);
          }
        }
      }
    }
    if (level <= finest) return points;
  }
}

}  // namespace vallecula::pipeline
