// The surfaces and the tetrahedra of a package, from a segmentation.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "pipeline/mesh/anatomy_fields.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// Keys as in kSurfaces. Every one but "glottis" (an outline, fanned) is closed, manifold and looks outwards; throws
/// std::runtime_error otherwise. None should cross itself: the quality report counts what could not be mended. Sizes are chosen for drawing: fine about mouth and airway, coarse on the scalp.
std::map<std::string, Surface> surfaces_of(const Segmentation& s, const AnatomyFields& fields,
                                           const std::function<void(double)>& progress = {});

/// The border of tongue and epiglottis together: evenly meshed, smaller triangles on the thin leaf.
struct SoftSurface {
  Surface fine;  ///< as cut from the fields
  Surface mesh;  ///< remeshed, of the same volume: what is filled
  Surface track;  ///< where the points of `mesh` lie: `fine`, further out by what flat triangles cut off
  std::function<double(const Point&)> edge_mm;
};
/// `edge_factor` 1 gives about 4,000 tetrahedra, whatever the infant's size.
SoftSurface soft_surface(const Segmentation& s, const AnatomyFields& fields, double edge_factor);

/// Fewest and most tetrahedra that can be asked for.
constexpr int kFewestTetrahedra = 1000;
constexpr int kMostTetrahedra = 100000;

/// Fills it with about `tetrahedra` (within 10 %: sizes are tried until the count is met), improves the shapes, names each
/// tetrahedron's tissue and each node's anchor and contact. Its border does not cross itself. Tries again with other sizes
/// when the mesh generator refuses the surface. Throws TetrahedralizeError.
TetMesh soft_mesh(const Segmentation& s, const AnatomyFields& fields, int tetrahedra);

}  // namespace vallecula::pipeline
