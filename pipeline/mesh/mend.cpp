#include "pipeline/mesh/mend.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "pipeline/mesh/inflate.h"
#include "pipeline/mesh/self_intersection.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

constexpr int kRounds = 16;
constexpr int kRoundsARing = 4;
constexpr int kRings = (kRounds - 1) / kRoundsARing;

/// A part of the surface about a crossing, small enough to try much on it.
struct Patch {
  Surface part;
  std::vector<int> point;                     ///< the surface's, for each of the part's
  std::vector<std::vector<int>> neighbours;  ///< empty where not all triangles of a point are in the part: it stays
};

/// Crossing triangles, those that cross each other or have a corner in common together.
std::vector<std::vector<int>> clusters_of(const Surface& s, const Pairs& pairs) {
  std::vector<int> parent(s.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& pair : pairs) {
    const int first = root(s.triangles[pair[0]][0]);
    for (const int t : pair) {
      for (const int v : s.triangles[t]) parent[root(v)] = first;
    }
  }
  std::map<int, std::vector<int>> clusters;
  for (const auto& pair : pairs) {
    auto& cluster = clusters[root(s.triangles[pair[0]][0])];
    cluster.insert(cluster.end(), pair.begin(), pair.end());
  }
  std::vector<std::vector<int>> out;
  for (auto& [at, cluster] : clusters) out.push_back(std::move(cluster));
  return out;
}

/// All triangles that reach into the box about the cluster, as far around it as points may be moved and one edge more.
Patch patch_about(const Surface& s, const std::vector<int>& cluster, const std::vector<int>& degree) {
  Point low{1e300, 1e300, 1e300};
  Point high{-1e300, -1e300, -1e300};
  double longest = 0.0;
  for (const int t : cluster) {
    const auto& c = s.triangles[t];
    for (int k = 0; k < 3; ++k) {
      longest = std::max(longest, distance(s.points[c[k]], s.points[c[(k + 1) % 3]]));
      for (int a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], s.points[c[k]][a]);
        high[a] = std::max(high[a], s.points[c[k]][a]);
      }
    }
  }
  const double reach = (kRings + 2) * longest;
  const auto inside = [&](const std::array<int, 3>& c) {
    for (int a = 0; a < 3; ++a) {
      const auto [min, max] = std::minmax({s.points[c[0]][a], s.points[c[1]][a], s.points[c[2]][a]});
      if (max < low[a] - reach || min > high[a] + reach) return false;
    }
    return true;
  };
  Patch out;
  std::map<int, int> to;
  for (const auto& c : s.triangles) {
    if (!inside(c)) continue;
    std::array<int, 3> t{};
    for (int k = 0; k < 3; ++k) {
      const auto [at, fresh] = to.emplace(c[k], static_cast<int>(out.point.size()));
      if (fresh) {
        out.point.push_back(c[k]);
        out.part.points.push_back(s.points[c[k]]);
      }
      t[k] = at->second;
    }
    out.part.triangles.push_back(t);
  }
  out.neighbours.resize(out.point.size());
  for (const auto& t : out.part.triangles) {
    for (int k = 0; k < 3; ++k) out.neighbours[t[k]].push_back(t[(k + 1) % 3]);  // closed: each neighbour once
  }
  for (std::size_t v = 0; v < out.point.size(); ++v) {
    if (static_cast<int>(out.neighbours[v].size()) < degree[out.point[v]]) out.neighbours[v].clear();
  }
  return out;
}

/// Corners of the crossing triangles and what lies within so many edges of them, without those that stay.
std::vector<int> surroundings(const Surface& s, const Pairs& pairs, const std::vector<std::vector<int>>& neighbours,
                              int rings) {
  std::vector<std::uint8_t> in(s.points.size(), 0);
  std::vector<int> out;
  const auto add = [&](int v) {
    if (in[v] != 0 || neighbours[v].empty()) return;
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

Surface smoothed_at(const Surface& s, const std::vector<int>& moving, const std::vector<std::vector<int>>& neighbours) {
  Surface out = s;
  for (const int v : moving) {
    Vector3 sum{};
    for (const int n : neighbours[v]) sum = sum + s.points[n];
    out.points[v] = 0.3 * s.points[v] + (0.7 / static_cast<double>(neighbours[v].size())) * sum;
  }
  return out;
}

/// Along the normals, by a share of the edges there.
Surface shifted_at(const Surface& s, const std::vector<int>& moving, const std::vector<std::vector<int>>& neighbours,
                   double share) {
  const auto normals = point_normals(s);
  Surface out = s;
  for (const int v : moving) {
    double edges = 0.0;
    for (const int n : neighbours[v]) edges += distance(s.points[v], s.points[n]);
    out.points[v] = s.points[v] + (share * edges / static_cast<double>(neighbours[v].size())) * normals[v];
  }
  return out;
}

/// Tries on the patch what takes the most crossings away, round by round; true when fewer are left in it.
bool mend(Patch& patch) {
  constexpr double kShift = 0.1;
  auto now = patch.part;
  auto pairs = self_intersections(now);
  const auto before = pairs.size();
  auto fewest = before;
  for (int round = 0; round < kRounds && !pairs.empty(); ++round) {
    const auto moving = surroundings(now, pairs, patch.neighbours, round / kRoundsARing);
    // A fold is smoothed away. Two sides of a thin sheet that have passed each other come apart when both move
    // outwards, two walls of a narrow gap when both move inwards.
    auto next = smoothed_at(now, moving, patch.neighbours);
    auto left = self_intersections(next);
    for (const double share : {kShift, -kShift}) {
      auto other = shifted_at(now, moving, patch.neighbours, share);
      auto other_left = self_intersections(other);
      if (other_left.size() >= left.size()) continue;
      next = std::move(other);
      left = std::move(other_left);
    }
    now = std::move(next);
    pairs = std::move(left);
    if (pairs.size() >= fewest) continue;
    fewest = pairs.size();
    patch.part = now;
  }
  return fewest < before;
}

}  // namespace

Surface mended(const Surface& surface) {
  auto pairs = self_intersections(surface);
  if (pairs.empty()) return surface;
  std::vector<int> degree(surface.points.size(), 0);
  for (const auto& t : surface.triangles) {
    for (const int v : t) ++degree[v];
  }
  Surface best = surface;
  std::size_t fewest = pairs.size();
  while (!pairs.empty()) {
    Surface now = best;
    for (const auto& cluster : clusters_of(now, pairs)) {
      auto patch = patch_about(now, cluster, degree);
      if (!mend(patch)) continue;
      for (std::size_t v = 0; v < patch.point.size(); ++v) now.points[patch.point[v]] = patch.part.points[v];
    }
    pairs = self_intersections(now);
    if (pairs.size() >= fewest) break;
    fewest = pairs.size();
    best = std::move(now);
  }
  return best;
}

}  // namespace vallecula::pipeline
