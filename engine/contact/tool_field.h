// The tool as contact sees it: its distance field, fine near the surface and coarse for pruning, and sample points on it.
#pragma once

#include <vector>

#include "engine/contact/signed_distance_grid.h"

namespace vallecula::engine {

struct ToolField {
  /// `low` and `high`: ToolDescription::tissue_low and tissue_high. Throws std::invalid_argument when the surface is not
  /// closed (naming how many edges are open), or lies outside that box.
  ToolField(const TriangleMesh& surface, const Vec3& low, const Vec3& high);

  SignedDistanceGrid fine;     ///< exact within 1.5 mm; only within the box that tissue can meet
  SignedDistanceGrid coarse;   ///< to prune by, exact within 16 mm
  double radius = 0.0;         ///< of the surface's farthest point from the tool's origin, m
  std::vector<Vec3> samples;   ///< points on the surface about 1.5 mm apart, tool frame, m
};

}  // namespace vallecula::engine
