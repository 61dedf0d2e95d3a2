// Figures of a tetrahedral mesh.
#pragma once

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

struct TetQuality {
  double volume_mm3 = 0.0;
  double smallest_volume_mm3 = 0.0;  ///< signed
  double smallest_dihedral_deg = 180.0;
  double largest_dihedral_deg = 0.0;
  double shortest_edge_mm = 0.0;
};

double signed_volume(const TetMesh& mesh, const std::array<int, 4>& tet);
/// Smallest and largest of the six angles between faces, degrees.
std::array<double, 2> dihedral_range(const std::array<Point, 4>& corner);
TetQuality quality_of(const TetMesh& mesh);

}  // namespace vallecula::pipeline
