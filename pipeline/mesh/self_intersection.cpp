#include "pipeline/mesh/self_intersection.h"

#include <algorithm>
#include <cmath>

#include "pipeline/mesh/triangle_tree.h"
#include "pipeline/parallel.h"

namespace vallecula::pipeline {
namespace {

__extension__ using Wide = __int128;
/// On a grid of 2^40 steps: a difference fits 41 bits, a determinant of three of them 126.
using Whole = std::array<std::int64_t, 3>;

int sign_of(Wide v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

Whole minus(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Side of the plane abc on which d lies.
int side(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  const auto u = minus(b, a);
  const auto v = minus(c, a);
  const auto w = minus(d, a);
  {
    // In floating point first: the differences are exact in it, so only the products and sums are rounded.
    const std::array<double, 3> m{static_cast<double>(v[1]) * w[2] - static_cast<double>(v[2]) * w[1],
                                  static_cast<double>(v[2]) * w[0] - static_cast<double>(v[0]) * w[2],
                                  static_cast<double>(v[0]) * w[1] - static_cast<double>(v[1]) * w[0]};
    const std::array<double, 3> size{
        std::abs(static_cast<double>(v[1]) * w[2]) + std::abs(static_cast<double>(v[2]) * w[1]),
        std::abs(static_cast<double>(v[2]) * w[0]) + std::abs(static_cast<double>(v[0]) * w[2]),
        std::abs(static_cast<double>(v[0]) * w[1]) + std::abs(static_cast<double>(v[1]) * w[0])};
    double determinant = 0.0;
    double bound = 0.0;
    for (int k = 0; k < 3; ++k) {
      determinant += u[k] * m[k];
      bound += std::abs(static_cast<double>(u[k])) * size[k];
    }
    if (std::abs(determinant) > 1e-14 * bound) return determinant > 0.0 ? 1 : -1;
  }
  const auto minor = [&](int i, int j) { return static_cast<Wide>(v[i]) * w[j] - static_cast<Wide>(v[j]) * w[i]; };
  return sign_of(u[0] * minor(1, 2) + u[1] * minor(2, 0) + u[2] * minor(0, 1));
}

/// Side of the line ab on which c lies, seen along an axis.
int side_2d(const Whole& a, const Whole& b, const Whole& c, int axis) {
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  return sign_of(static_cast<Wide>(b[i] - a[i]) * (c[j] - a[j]) - static_cast<Wide>(b[j] - a[j]) * (c[i] - a[i]));
}

/// c lies on the line ab: is it between the two?
bool between(const Whole& a, const Whole& b, const Whole& c) {
  for (int k = 0; k < 3; ++k) {
    if (c[k] < std::min(a[k], b[k]) || c[k] > std::max(a[k], b[k])) return false;
  }
  return true;
}

bool segments_meet(const Whole& a, const Whole& b, const Whole& c, const Whole& d, int axis) {
  const int s0 = side_2d(a, b, c, axis);
  const int s1 = side_2d(a, b, d, axis);
  const int s2 = side_2d(c, d, a, axis);
  const int s3 = side_2d(c, d, b, axis);
  if (s0 * s1 < 0 && s2 * s3 < 0) return true;
  return (s0 == 0 && between(a, b, c)) || (s1 == 0 && between(a, b, d)) || (s2 == 0 && between(c, d, a)) ||
         (s3 == 0 && between(c, d, b));
}

using Triangle = std::array<Whole, 3>;

/// The axis along which the triangle is seen largest; -1 when it has no area.
int facing(const Triangle& t) {
  const auto u = minus(t[1], t[0]);
  const auto v = minus(t[2], t[0]);
  int best = -1;
  Wide largest = 0;
  for (int k = 0; k < 3; ++k) {
    Wide n = static_cast<Wide>(u[(k + 1) % 3]) * v[(k + 2) % 3] - static_cast<Wide>(u[(k + 2) % 3]) * v[(k + 1) % 3];
    if (n < 0) n = -n;
    if (n <= largest) continue;
    largest = n;
    best = k;
  }
  return best;
}

/// Segment pq and closed triangle have a point in common.
bool meets(const Whole& p, const Whole& q, const Triangle& t) {
  const int sp = side(t[0], t[1], t[2], p);
  const int sq = side(t[0], t[1], t[2], q);
  if (sp * sq > 0) return false;
  if (sp == 0 && sq == 0) {
    const int axis = facing(t);
    for (int k = 0; k < 3; ++k) {
      if (segments_meet(p, q, t[k], t[(k + 1) % 3], axis)) return true;
    }
    const int s = side_2d(t[0], t[1], p, axis);
    return s != 0 && s == side_2d(t[1], t[2], p, axis) && s == side_2d(t[2], t[0], p, axis);
  }
  const int s0 = side(p, q, t[0], t[1]);
  const int s1 = side(p, q, t[1], t[2]);
  const int s2 = side(p, q, t[2], t[0]);
  return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

/// Two triangles with area, by the numbers and places of their corners.
bool intersect(const std::array<int, 3>& a, const Triangle& pa, const std::array<int, 3>& b, const Triangle& pb) {
  std::array<int, 3> ia{};  // common corners first
  std::array<int, 3> ib{};
  int common = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a[i] != b[j]) continue;
      if (common < 3) {
        ia[common] = i;
        ib[common] = j;
      }
      ++common;
    }
  }
  if (common >= 3) return true;
  if (common == 2) {
    const int other_a = 3 - ia[0] - ia[1];
    const int other_b = 3 - ib[0] - ib[1];
    if (side(pa[0], pa[1], pa[2], pb[other_b]) != 0) return false;
    const int axis = facing(pa);
    return side_2d(pa[ia[0]], pa[ia[1]], pa[other_a], axis) == side_2d(pa[ia[0]], pa[ia[1]], pb[other_b], axis);
  }
  if (common == 1) {
    // What they share beyond the corner ends on one of the edges opposite to it.
    return meets(pa[(ia[0] + 1) % 3], pa[(ia[0] + 2) % 3], pb) || meets(pb[(ib[0] + 1) % 3], pb[(ib[0] + 2) % 3], pa);
  }
  for (int k = 0; k < 3; ++k) {
    if (meets(pa[k], pa[(k + 1) % 3], pb) || meets(pb[k], pb[(k + 1) % 3], pa)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::array<int, 2>> self_intersections(const Surface& surface) {
  std::vector<std::array<int, 2>> found;
  if (surface.triangles.empty()) return found;
  Point low = surface.points.front();
  Point high = low;
  for (const auto& p : surface.points) {
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-9});
  const double steps_per_mm = static_cast<double>(std::int64_t{1} << 40) / extent;
  std::vector<Whole> points(surface.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int a = 0; a < 3; ++a) points[i][a] = std::llround((surface.points[i][a] - low[a]) * steps_per_mm);
  }
  const int count = static_cast<int>(surface.triangles.size());
  const auto corners = [&](int t) {
    const auto& c = surface.triangles[t];
    return Triangle{points[c[0]], points[c[1]], points[c[2]]};
  };
  std::vector<std::uint8_t> flat(surface.triangles.size(), 0);
  for (int t = 0; t < count; ++t) {
    flat[t] = facing(corners(t)) < 0 ? 1 : 0;
    if (flat[t] != 0) found.push_back({t, t});
  }
  const TriangleTree tree(surface);
  constexpr int kChunk = 512;
  std::vector<std::vector<std::array<int, 2>>> pairs((count + kChunk - 1) / kChunk);
  const double hair = 2.0 / steps_per_mm;  // the rounding may bring boxes to touch that did not
  parallel_for(static_cast<int>(pairs.size()), [&](int chunk) {
    for (int t = chunk * kChunk; t < std::min(count, (chunk + 1) * kChunk); ++t) {
      if (flat[t] != 0) continue;
      const auto& c = surface.triangles[t];
      Point from{};
      Point to{};
      for (int a = 0; a < 3; ++a) {
        const auto range = std::minmax({surface.points[c[0]][a], surface.points[c[1]][a], surface.points[c[2]][a]});
        from[a] = range.first - hair;
        to[a] = range.second + hair;
      }
      const auto mine = corners(t);
      tree.for_each_in(from, to, [&](int other) {
        if (other <= t || flat[other] != 0) return;
        if (intersect(c, mine, surface.triangles[other], corners(other))) pairs[chunk].push_back({t, other});
      });
    }
  });
  for (const auto& some : pairs) found.insert(found.end(), some.begin(), some.end());
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace vallecula::pipeline
