#include "engine/contact/tool_field.h"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "engine/mesh/triangle_bvh.h"

namespace vallecula::engine {

namespace {

constexpr double kFineSpacing = 0.00025, kFineBand = 0.0015;
constexpr double kFineTolerance = 0.00003;  // what an edge may bend the field within a cell before it is sampled more finely
constexpr double kCoarseSpacing = 0.002, kCoarseBand = 0.016;
constexpr double kSampleSpacing = 0.0015;

SignedDistanceGrid field(const TriangleMesh& mesh, double spacing, double band, const Vec3& least, const Vec3& most,
                         double tolerance = std::numeric_limits<double>::infinity()) {
  Vec3 low = mesh.points.front(), high = low;
  for (const Vec3& p : mesh.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 margin = Vec3::Constant(band + spacing);
  return SignedDistanceGrid(mesh, (low - margin).cwiseMax(least), (high + margin).cwiseMin(most), spacing, band, {}, tolerance);
}

TriangleMesh checked(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (!mesh.points[i].allFinite()) throw std::invalid_argument("tool: point " + std::to_string(i) + " is not finite");
  const int open = count_open_edges(mesh);
  if (mesh.triangles.empty() || open > 0)
    throw std::invalid_argument("tool: its surface is not closed (" + std::to_string(open) + " open edges)");
  return mesh;
}

}  // namespace

ToolField::ToolField(const TriangleMesh& surface, const Vec3& low, const Vec3& high)
    : fine(field(checked(surface), kFineSpacing, kFineBand, low, high, kFineTolerance)),
      coarse(field(surface, kCoarseSpacing, kCoarseBand, Vec3::Constant(-1e3), Vec3::Constant(1e3))) {
  for (const Vec3& p : surface.points) radius = std::max(radius, p.norm());
  std::set<std::array<long long, 3>> taken;  // one sample a cell of the sample spacing
  for (const auto& t : surface.triangles) {
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int parts = std::max(1, static_cast<int>(std::ceil(longest / (0.5 * kSampleSpacing))));
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; i + j <= parts; ++j) {
        const Vec3 p = a + (b - a) * (double(i) / parts) + (c - a) * (double(j) / parts);
        const Vec3 cell = p / kSampleSpacing;
        if (taken.insert({std::llround(cell.x()), std::llround(cell.y()), std::llround(cell.z())}).second)
          samples.push_back(p);
      }
  }
}

}  // namespace vallecula::engine
