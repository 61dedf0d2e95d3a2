#include "engine/tool/miller_blade.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vallecula::engine {

namespace {

constexpr int kStations = 44;
constexpr double kBend = 0.012;      // length of the bent tip, m
constexpr double kWebStart = 0.004, kWebFull = 0.022;  // along the blade, m
constexpr double kChamfer = 0.0003;  // rounds the edges so that they slide; a sharp edge has no normal

/// Cross-section of the blade in (y, z), counter-clockwise seen against +x, as a fan about its first point (the inner
/// corner of the L, from which every other point can be seen).
std::vector<Eigen::Vector2d> cross_section(double half_width, double t, double web) {
  const double c = kChamfer, left = -half_width, right = half_width, inner = left + t, bottom = -t - web;
  return {{inner, -t},        {right - c, -t},     {right, -t + c},   {right, -c},         {right - c, 0},
          {left + c, 0},      {left, -c},          {left, bottom + c}, {left + c, bottom}, {inner - c, bottom},
          {inner, bottom + c}};
}

}  // namespace

MillerBlade miller_blade(const std::string& name) {
  MillerBlade blade;
  if (name == "miller-00") {
    blade.length = 0.065;
    blade.width = 0.0090;
    blade.web_height = 0.0030;
  } else if (name == "miller-0") {
    blade.length = 0.075;
  } else if (name == "miller-1") {
    blade.length = 0.102;
    blade.width = 0.0115;
    blade.web_height = 0.0040;
  } else if (name == "miller-2") {
    blade.length = 0.155;
    blade.width = 0.0130;
    blade.web_height = 0.0060;
  } else if (name == "miller-3") {
    blade.length = 0.195;
    blade.width = 0.0140;
    blade.web_height = 0.0070;
  } else {
    throw std::invalid_argument("blade '" + name + "' is not known; there are miller-00, miller-0, miller-1, miller-2 and miller-3");
  }
  return blade;
}

TriangleMesh blade_surface(const MillerBlade& b) {
  if (!(b.length > 2 * kWebFull) || !(b.width > 4 * b.thickness) || !(b.thickness > 3 * kChamfer) || !(b.web_height > 0))
    throw std::invalid_argument("blade: its dimensions do not make a blade");
  TriangleMesh mesh;
  const double radius = b.width / 2;
  int ring = 0;
  for (int s = 0; s < kStations; ++s) {
    // Stations crowd at the tip, where the outline is round.
    const double x = b.length * std::pow(double(s) / (kStations - 1), 1.7);
    const double from_round = std::max(0.0, radius - x);
    const double half_width = std::max(0.45 * radius, std::sqrt(std::max(0.0, radius * radius - from_round * from_round)));
    const double grow = std::clamp((x - kWebStart) / (kWebFull - kWebStart), 0.0, 1.0);
    const double web = 3 * kChamfer + b.web_height * grow * grow * (3 - 2 * grow);
    const double to_tip = std::max(0.0, 1.0 - x / kBend);
    const double z = -b.tip_lift * (1.0 - to_tip * to_tip);
    const auto section = cross_section(half_width, b.thickness, web);
    ring = static_cast<int>(section.size());
    for (const auto& p : section) mesh.points.emplace_back(x, p.x(), p.y() + z);
  }
  for (int s = 0; s + 1 < kStations; ++s)
    for (int i = 0; i < ring; ++i) {
      const int a = s * ring + i, c = s * ring + (i + 1) % ring, d = a + ring, e = c + ring;
      mesh.triangles.push_back({a, d, c});
      mesh.triangles.push_back({c, d, e});
    }
  const int last = (kStations - 1) * ring;
  for (int i = 1; i + 1 < ring; ++i) {
    mesh.triangles.push_back({0, i, i + 1});
    mesh.triangles.push_back({last, last + i + 1, last + i});
  }
  double volume = 0.0;
  for (const auto& t : mesh.triangles) volume += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6;
  if (volume < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace vallecula::engine
