// Better shaped tetrahedra by moving points.
#pragma once

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// Moves inner points freely and the first `surface_points` along `surface`, always so that the worst tetrahedron at
/// the moved point gets better, worst first, until nothing is gained. Connections stay; no tetrahedron is turned over.
/// With `slide` off the surface's points stay where they are. (Freitag and Ollivier-Gooch 1997, by direct search.) Quality: smallest sine of a dihedral angle, signed.
void optimize_points(TetMesh& mesh, std::size_t surface_points, const Surface& surface, int rounds,
                     bool slide = true);

}  // namespace vallecula::pipeline
