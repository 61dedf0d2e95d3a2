// Geometry of a tetrahedral body at rest: volumes, shape gradients and its surface.
#pragma once

#include <vector>

#include "engine/scene.h"
#include "engine/types.h"

namespace vallecula::engine {

/// Signed volume of a tetrahedron, m^3; positive when d lies on the side of (b-a) x (c-a).
double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Gradients of the four linear shape functions (columns), 1/m.
Eigen::Matrix<double, 3, 4> shape_gradients(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Boundary faces, outward, with the tetrahedron each belongs to.
struct SoftSurface {
  std::vector<std::array<int, 3>> triangles;  ///< indices into the body's nodes
  std::vector<int> tet;                       ///< per triangle
};
SoftSurface extract_surface(const std::vector<std::array<int, 4>>& tets);

/// Throws std::invalid_argument naming the first node, tet or material that cannot be simulated.
void check_soft_body(const SoftBodyDescription& soft);

}  // namespace vallecula::engine
