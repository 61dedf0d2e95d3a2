#include "engine/tool/shapes.h"

#include <cmath>
#include <map>
#include <stdexcept>

namespace vallecula::engine {

TriangleMesh box_surface(const Vec3& centre, const Vec3& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back(centre + 0.5 * Vec3((i & 1) ? size.x() : -size.x(), (i & 2) ? size.y() : -size.y(),
                                              (i & 4) ? size.z() : -size.z()));
  static constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : kFaces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

TriangleMesh sphere_surface(double radius, int rings) {
  TriangleMesh mesh;
  mesh.points = {Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitZ()};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int ring = 0; ring < rings; ++ring) {
    std::map<std::pair<int, int>, int> middle;
    const auto halve = [&](int a, int b) {
      const auto [it, fresh] = middle.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.points.size()));
      if (fresh) mesh.points.push_back((mesh.points[a] + mesh.points[b]).normalized());
      return it->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = halve(a, b), bc = halve(b, c), ca = halve(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& p : mesh.points) p *= radius;
  return mesh;
}

TriangleMesh paddle_surface(const Vec3& size) {
  constexpr int kHalfEnd = 24, kEdge = 12;  // parts of each round end and of each round edge, seen over half a turn
  constexpr double kPi = 3.14159265358979323846;
  const double r = size.z() / 2, straight = (size.x() - size.y()) / 2;
  if (!(r > 0) || !(size.y() > size.z()) || !(straight >= 0) || !std::isfinite(size.x()))
    throw std::invalid_argument("paddle: it must be at least as long as wide, and wider than thick");
  TriangleMesh mesh;
  constexpr int kRing = 2 * (kHalfEnd + 1);
  for (int e = 0; e <= kEdge; ++e) {  // from the lower face's rim round the edge to the upper face's
    const double tilt = kPi * (double(e) / kEdge - 0.5);
    const double end = size.y() / 2 - r + r * std::cos(tilt);
    for (int i = 0; i < kRing; ++i) {
      const bool front = i <= kHalfEnd;
      const double angle = kPi * ((front ? i : i - 1) / double(kHalfEnd) - 0.5);
      mesh.points.emplace_back((front ? straight : -straight) + end * std::cos(angle), end * std::sin(angle),
                               r * std::sin(tilt));
    }
  }
  for (int e = 0; e < kEdge; ++e)
    for (int i = 0; i < kRing; ++i) {
      const int a = e * kRing + i, b = e * kRing + (i + 1) % kRing;
      mesh.triangles.push_back({a, b, b + kRing});
      mesh.triangles.push_back({a, b + kRing, a + kRing});
    }
  constexpr int kTop = kEdge * kRing;
  for (int i = 1; i + 1 < kRing; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({kTop, kTop + i, kTop + i + 1});
  }
  return mesh;
}

}  // namespace vallecula::engine
