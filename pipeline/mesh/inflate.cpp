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

Surface inflated(const Surface& surface, double by_mm) {
  const auto normals = point_normals(surface);
  Surface out = surface;
  for (std::size_t i = 0; i < out.points.size(); ++i) out.points[i] = out.points[i] + by_mm * normals[i];
  return out;
}

double inflation_to(const Surface& surface, double volume_mm3) {
  double by = 0.0;
  for (int round = 0; round < 3; ++round) {
    const auto f = facts_of(inflated(surface, by));
    by += (volume_mm3 - f.volume_mm3) / f.area_mm2;
  }
  return by;
}

}  // namespace vallecula::pipeline
