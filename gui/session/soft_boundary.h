// The skin of a tetrahedral mesh: the faces that belong to one tetrahedron only.
#pragma once

#include <array>
#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

struct SoftBoundary {
  std::vector<int> node;                      ///< tet-mesh node of each of its points
  std::vector<std::array<int, 3>> triangles;  ///< of its points, outward
};

/// Points and triangles in an order that depends on the mesh alone.
SoftBoundary soft_boundary(const pipeline::TetMesh& mesh);

}  // namespace vallecula::gui
