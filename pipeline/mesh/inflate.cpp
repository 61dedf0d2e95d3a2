#include "pipeline/mesh/inflate.h"

#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {

std::vector<Point> point_normals(const Surface& surface) {
  std::vector<Point> normals(surface.points.size(), Point{});
  for (const auto& t : surface.triangles) {
    const auto n = cross(surface.points[t[1]] - surface.points[t[0]], surface.points[t[2]] - surface.points[t[0]]);
    for (const int v : t) normals[v] = normals[v] + n;
  }
  for (auto& n : normals) n = unit(n);
  return normals;
}

Surface inflated(const Surface& surface, double by_mm, const InflationShare& share) {
  const auto normals = point_normals(surface);
  Surface out = surface;
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    const double by = share ? by_mm * share(surface.points[i]) : by_mm;
    out.points[i] = out.points[i] + by * normals[i];
  }
  return out;
}

double inflation_to(const Surface& surface, double volume_mm3, const InflationShare& share) {
  double by = 0.0;
  // Only a part of the area may move: each round leaves that part's share of what was still missing.
  for (int round = 0; round < 8; ++round) {
    const auto f = size_of(inflated(surface, by, share));
    by += (volume_mm3 - f.volume_mm3) / f.area_mm2;
  }
  return by;
}

}  // namespace vallecula::pipeline
