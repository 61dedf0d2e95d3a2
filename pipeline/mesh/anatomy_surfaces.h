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
                                           const std::function<void(const std::string&, double)>& progress = {});

/// Fewest and most tetrahedra that can be asked for.
constexpr int kFewestTetrahedra = 1000;
constexpr int kMostTetrahedra = 100000;

/// Fills it with about `tetrahedra` (within 10 %: sizes are tried until the count is met), improves the shapes, names each
/// tetrahedron's tissue and each node's anchor and contact. Its border does not cross itself: where structures given by a
/// person are so rough that it would, the border is smoothed there; otherwise it tries again with other sizes. Throws
/// TetrahedralizeError; when the border cannot be helped, with the structure and the place in the scan's frame.
TetMesh soft_mesh(const Segmentation& s, const AnatomyFields& fields, int tetrahedra);

}  // namespace vallecula::pipeline
