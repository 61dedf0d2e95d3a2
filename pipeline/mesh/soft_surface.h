// The border of tongue and epiglottis together, as it is filled with tetrahedra.
#pragma once

#include <functional>

#include "pipeline/mesh/anatomy_fields.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// The field that passes through zero at the border, about mm, positive inside; on a lattice finer than the triangles.
Volume<float> soft_field(const Segmentation& s, const AnatomyFields& fields);

struct SoftSurface {
  Surface fine;   ///< as cut from the field
  Surface mesh;   ///< remeshed, of the same volume, smaller triangles on the thin leaf: what is filled
  Surface track;  ///< where the points of `mesh` lie: `fine`, further out by what flat triangles cut off
  std::function<double(const Point&)> edge_mm;
};
/// `edge_factor` 1 gives about 4,000 tetrahedra, whatever the infant's size.
SoftSurface soft_surface(const Segmentation& s, const Volume<float>& field, double edge_factor);

/// Where the mesh crosses itself: the middle of a triangle of each pair, mm.
std::vector<Point> crossings(const SoftSurface& soft);

/// Takes out of the field, about these places only, what is too small for triangles of the size there: steps, fins and
/// slits of a border drawn by voxels.
void smooth_about(const std::vector<Point>& places, const SoftSurface& soft, Volume<float>& field);

}  // namespace vallecula::pipeline
