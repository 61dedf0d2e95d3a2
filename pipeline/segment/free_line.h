// What could be seen of the glottis if tongue and epiglottis were not there: straight lines through the voxels.
#pragma once

#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

/// Share, 0..1, of the glottic opening from which a straight line to `eye` (mm LPS) meets no tissue but tongue and
/// epiglottis. The first 2 mm (term) do not count: they are the cords themselves.
double free_share(const Segmentation& s, const Vector3& eye);

}  // namespace vallecula::pipeline
