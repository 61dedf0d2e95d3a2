#include "pipeline/mesh/surface_check.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

constexpr double kDegree = 57.29577951308232;

std::uint64_t directed_edge(int a, int b) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
}

int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Number of fans around each point is one: walking over shared edges from any triangle of the point must visit all of
/// them.
bool single_fans(const Surface& s, const std::unordered_map<std::uint64_t, int>& owner) {
  std::vector<int> degree(s.points.size(), 0);
  std::vector<int> start(s.points.size(), -1);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    for (const int v : s.triangles[t]) {
      ++degree[v];
      start[v] = static_cast<int>(t);
    }
  }
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    if (start[v] < 0) continue;
    int t = start[v];
    int visited = 0;
    do {
      const auto& tri = s.triangles[t];
      const int k = tri[0] == static_cast<int>(v) ? 0 : tri[1] == static_cast<int>(v) ? 1 : 2;
      const auto next = owner.find(directed_edge(static_cast<int>(v), tri[(k + 2) % 3]));
      if (next == owner.end()) return false;
      t = next->second;
      ++visited;
    } while (t != start[v] && visited <= degree[v]);
    if (visited != degree[v]) return false;
  }
  return true;
}

std::vector<int> part_of_triangles(const Surface& s, int& parts) {
  std::vector<int> parent(s.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& t : s.triangles) {
    for (int k = 1; k < 3; ++k) parent[root_of(parent, t[k])] = root_of(parent, t[0]);
  }
  std::unordered_map<int, int> number;
  std::vector<int> part(s.triangles.size());
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    part[t] = number.emplace(root_of(parent, s.triangles[t][0]), static_cast<int>(number.size())).first->second;
  }
  parts = static_cast<int>(number.size());
  return part;
}

}  // namespace

SurfaceSize size_of(const Surface& s) {
  SurfaceSize size;
  for (const auto& t : s.triangles) {
    const Vector3 a = s.points[t[0]];
    const Vector3 b = s.points[t[1]];
    const Vector3 c = s.points[t[2]];
    size.area_mm2 += 0.5 * norm(cross(b - a, c - a));
    size.volume_mm3 += dot(a, cross(b, c)) / 6.0;
  }
  return size;
}

SurfaceFacts facts_of(const Surface& s) {
  SurfaceFacts f;
  const auto size = size_of(s);
  f.volume_mm3 = size.volume_mm3;
  f.area_mm2 = size.area_mm2;
  const auto note = [&](bool& flag, const std::string& words) {
    flag = false;
    if (f.fault.empty()) f.fault = words;
  };
  for (const auto& p : s.points) {
    for (const double v : p) {
      if (!std::isfinite(v) && f.finite) note(f.finite, "a point is not finite");
    }
  }
  if (s.triangles.empty()) note(f.closed, "it has no triangles");
  std::unordered_map<std::uint64_t, int> owner;
  owner.reserve(s.triangles.size() * 3);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto& tri = s.triangles[t];
    const Vector3 a = s.points[tri[0]];
    const Vector3 b = s.points[tri[1]];
    const Vector3 c = s.points[tri[2]];
    const std::array<Vector3, 3> p{a, b, c};
    for (int k = 0; k < 3; ++k) {
      const auto u = unit(p[(k + 1) % 3] - p[k]);
      const auto v = unit(p[(k + 2) % 3] - p[k]);
      f.smallest_angle_deg = std::min(f.smallest_angle_deg, kDegree * std::acos(std::clamp(dot(u, v), -1.0, 1.0)));
      if (tri[k] == tri[(k + 1) % 3]) note(f.manifold, "a triangle names a point twice");
      if (!owner.emplace(directed_edge(tri[k], tri[(k + 1) % 3]), static_cast<int>(t)).second) {
        note(f.manifold, "an edge has more than two triangles, or two that look to opposite sides");
      }
    }
  }
  for (const auto& [edge, triangle] : owner) {
    (void)triangle;
    if (owner.count((edge << 32) | (edge >> 32)) == 0) {
      note(f.closed, "it is open");
      break;
    }
  }
  if (f.closed && f.manifold && !single_fans(s, owner)) note(f.manifold, "two sheets touch in a point");
  part_of_triangles(s, f.parts);
  return f;
}

void require_solid(const Surface& surface, const std::string& what) {
  const auto f = facts_of(surface);
  if (!f.fault.empty()) throw std::runtime_error("the surface of " + what + " cannot be used: " + f.fault);
  // 1e-9 of the cube on the same area: only a sheet folded onto itself is that thin
  if (!(f.volume_mm3 > 1e-9 * std::pow(f.area_mm2 / 6.0, 1.5))) {
    throw std::runtime_error("the surface of " + what + " cannot be used: it is flat or looks inwards");
  }
}

Surface largest_part(const Surface& s) {
  int parts = 0;
  const auto part = part_of_triangles(s, parts);
  if (parts <= 1) return s;
  std::vector<double> volume(parts, 0.0);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto& tri = s.triangles[t];
    volume[part[t]] += dot(s.points[tri[0]], cross(s.points[tri[1]], s.points[tri[2]]));
  }
  const int best = static_cast<int>(std::max_element(volume.begin(), volume.end()) - volume.begin());
  Surface out;
  std::vector<int> to(s.points.size(), -1);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    if (part[t] != best) continue;
    std::array<int, 3> tri{};
    for (int k = 0; k < 3; ++k) {
      int& n = to[s.triangles[t][k]];
      if (n < 0) {
        n = static_cast<int>(out.points.size());
        out.points.push_back(s.points[s.triangles[t][k]]);
      }
      tri[k] = n;
    }
    out.triangles.push_back(tri);
    if (!s.tissue.empty()) out.tissue.push_back(s.tissue[t]);
  }
  return out;
}

}  // namespace vallecula::pipeline
