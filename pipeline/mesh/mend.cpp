#include "pipeline/mesh/mend.h"

#include "pipeline/mesh/self_intersection.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

/// Corners of the crossing triangles and what lies within so many edges of them.
std::vector<int> surroundings(const Surface& s, const std::vector<std::array<int, 2>>& pairs,
                              const std::vector<std::vector<int>>& neighbours, int rings) {
  std::vector<std::uint8_t> in(s.points.size(), 0);
  std::vector<int> out;
  const auto add = [&](int v) {
    if (in[v] != 0) return;
    in[v] = 1;
    out.push_back(v);
  };
  for (const auto& pair : pairs) {
    for (const int t : pair) {
      for (const int v : s.triangles[t]) add(v);
    }
  }
  std::size_t first = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t last = out.size();
    for (; first < last; ++first) {
      for (const int n : neighbours[out[first]]) add(n);
    }
  }
  return out;
}

}  // namespace

Surface mended(const Surface& surface) {
  auto pairs = self_intersections(surface);
  if (pairs.empty()) return surface;
  std::vector<std::vector<int>> neighbours(surface.points.size());
  for (const auto& t : surface.triangles) {
    for (int k = 0; k < 3; ++k) neighbours[t[k]].push_back(t[(k + 1) % 3]);  // closed: each neighbour once
  }
  Surface best = surface;
  std::size_t fewest = pairs.size();
  Surface now = surface;
  constexpr int kRounds = 16;
  constexpr int kRoundsARing = 4;
  for (int round = 0; round < kRounds && !pairs.empty(); ++round) {
    const auto moving = surroundings(now, pairs, neighbours, round / kRoundsARing);
    std::vector<Point> moved;
    for (const int v : moving) {
      Vector3 sum{};
      for (const int n : neighbours[v]) sum = sum + now.points[n];
      moved.push_back(0.3 * now.points[v] + (0.7 / static_cast<double>(neighbours[v].size())) * sum);
    }
    for (std::size_t i = 0; i < moving.size(); ++i) now.points[moving[i]] = moved[i];
    pairs = self_intersections(now);
    if (pairs.size() < fewest) {
      fewest = pairs.size();
      best = now;
    }
  }
  return best;
}

}  // namespace vallecula::pipeline
