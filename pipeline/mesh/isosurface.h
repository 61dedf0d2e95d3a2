// The closed surface on which a field passes through zero.
#pragma once

#include "pipeline/package/patient_package.h"
#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// `field` in about mm, positive inside. What reaches the grid's border is closed there. Triangles look outwards.
/// Crossings nearer than 3 % of an edge to a voxel centre are moved away from it, so that no triangle is degenerate.
Surface isosurface(const Volume<float>& field);

}  // namespace vallecula::pipeline
