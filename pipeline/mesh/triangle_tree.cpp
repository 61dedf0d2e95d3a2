#include "pipeline/mesh/triangle_tree.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

constexpr int kLeaf = 4;

/// Where on a triangle the nearest point lies.
struct OnTriangle {
  Point point{};
  int corner = -1;  ///< it is this corner
  int edge = -1;    ///< or on the edge that begins at this corner
};

/// Ericson, Real-Time Collision Detection, 5.1.5.
OnTriangle nearest_on(const Point& p, const Point& a, const Point& b, const Point& c) {
  const auto ab = b - a;
  const auto ac = c - a;
  const auto ap = p - a;
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {a, 0, -1};
  const auto bp = p - b;
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return {b, 1, -1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + (d1 / (d1 - d3)) * ab, -1, 0};
  const auto cp = p - c;
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return {c, 2, -1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + (d2 / (d2 - d6)) * ac, -1, 2};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    return {b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b), -1, 1};
  }
  const double sum = va + vb + vc;
  return {a + (vb / sum) * ab + (vc / sum) * ac, -1, -1};
}

double to_box2(const Point& p, const Point& low, const Point& high) {
  double d2 = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double d = std::max({low[a] - p[a], p[a] - high[a], 0.0});
    d2 += d * d;
  }
  return d2;
}

std::uint64_t directed(int a, int b) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
}

}  // namespace

TriangleTree::TriangleTree(const Surface& surface) : surface_(surface) {
  const auto& triangles = surface_.triangles;
  if (triangles.empty()) return;
  std::vector<Point> centres(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& c = triangles[t];
    centres[t] = (1.0 / 3.0) * (surface_.points[c[0]] + surface_.points[c[1]] + surface_.points[c[2]]);
  }
  order_.resize(triangles.size());
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(triangles.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<int>(triangles.size()), centres);
}

void TriangleTree::build(int node, int first, int count, const std::vector<Point>& centres) {
  Point low{1e300, 1e300, 1e300};
  Point high{-1e300, -1e300, -1e300};
  Point centre_low = low;
  Point centre_high = high;
  for (int i = first; i < first + count; ++i) {
    for (const int v : surface_.triangles[order_[i]]) {
      for (int a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], surface_.points[v][a]);
        high[a] = std::max(high[a], surface_.points[v][a]);
      }
    }
    for (int a = 0; a < 3; ++a) {
      centre_low[a] = std::min(centre_low[a], centres[order_[i]][a]);
      centre_high[a] = std::max(centre_high[a], centres[order_[i]][a]);
    }
  }
  nodes_[node].low = low;
  nodes_[node].high = high;
  if (count <= kLeaf) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  int axis = 0;
  for (int a = 1; a < 3; ++a) {
    if (centre_high[a] - centre_low[a] > centre_high[axis] - centre_low[axis]) axis = a;
  }
  const int half = count / 2;
  std::nth_element(
      order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
      [&](int a, int b) { return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b; });
  const int child = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  nodes_.emplace_back();
  nodes_[node].first = child;
  build(child, first, half, centres);
  build(child + 1, first + half, count - half, centres);
}

TriangleTree::Nearest TriangleTree::nearest(const Point& p) const {
  Nearest best{p, -1, 1e300};
  if (nodes_.empty()) return best;
  std::array<std::pair<double, int>, 64> stack;
  int top = 0;
  stack[top++] = {to_box2(p, nodes_[0].low, nodes_[0].high), 0};
  while (top > 0) {
    const auto [away, at] = stack[--top];
    if (away >= best.distance2) continue;
    const auto& node = nodes_[at];
    if (node.count == 0) {
      std::array<std::pair<double, int>, 2> child;
      for (int k = 0; k < 2; ++k) {
        const auto& box = nodes_[node.first + k];
        child[k] = {to_box2(p, box.low, box.high), node.first + k};
      }
      // The nearer one is looked at first.
      if (child[0].first < child[1].first) std::swap(child[0], child[1]);
      stack[top++] = child[0];
      stack[top++] = child[1];
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const auto& c = surface_.triangles[order_[i]];
      const auto on = nearest_on(p, surface_.points[c[0]], surface_.points[c[1]], surface_.points[c[2]]);
      const auto d = p - on.point;
      const double d2 = dot(d, d);
      if (d2 < best.distance2) best = {on.point, order_[i], d2};
    }
  }
  return best;
}

SurfaceDistance::SurfaceDistance(const Surface& surface) : tree_(surface) {
  const auto& triangles = surface.triangles;
  std::vector<Vector3> normals(triangles.size());
  point_normals_.assign(surface.points.size(), Point{});
  std::unordered_map<std::uint64_t, int> owner;
  owner.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& c = triangles[t];
    const std::array<Point, 3> p{surface.points[c[0]], surface.points[c[1]], surface.points[c[2]]};
    normals[t] = unit(cross(p[1] - p[0], p[2] - p[0]));
    for (int k = 0; k < 3; ++k) {
      const double angle =
          std::acos(std::clamp(dot(unit(p[(k + 1) % 3] - p[k]), unit(p[(k + 2) % 3] - p[k])), -1.0, 1.0));
      point_normals_[c[k]] = point_normals_[c[k]] + angle * normals[t];
      owner[directed(c[k], c[(k + 1) % 3])] = static_cast<int>(t);
    }
  }
  edge_normals_.resize(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& c = triangles[t];
    for (int k = 0; k < 3; ++k) {
      const auto other = owner.find(directed(c[(k + 1) % 3], c[k]));
      edge_normals_[t][k] = other == owner.end() ? normals[t] : normals[t] + normals[other->second];
    }
  }
}

double SurfaceDistance::at(const Point& p) const {
  const auto at = tree_.nearest(p);
  if (at.triangle < 0) return 1e9;
  const auto& surface = tree_.surface();
  const auto& c = surface.triangles[at.triangle];
  const auto& a = surface.points[c[0]];
  const auto& b = surface.points[c[1]];
  const auto& d = surface.points[c[2]];
  const auto on = nearest_on(p, a, b, d);
  const Vector3 normal = on.corner >= 0 ? point_normals_[c[on.corner]]
                         : on.edge >= 0 ? edge_normals_[at.triangle][on.edge]
                                        : cross(b - a, d - a);
  return dot(p - at.point, normal) < 0.0 ? -std::sqrt(at.distance2) : std::sqrt(at.distance2);
}

}  // namespace vallecula::pipeline
