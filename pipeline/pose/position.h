// A patient scanned with a closed mouth or a head that is not extended, put into the position of an intubation.
#pragma once

#include <functional>

#include "pipeline/pose/aim.h"

namespace vallecula::pipeline {

/// What was done, for tests and for the report.
struct PositionFacts {
  Aim aim;
  double smallest_jacobian = 1.0;  ///< of the map of any tetrahedron of tissue: where it is negative tissue is folded
  double folded_mm3 = 0.0;         ///< how much is
  double lower_volume_ratio = 1.0;  ///< tongue and lower lip
  double overlap_mm3 = 0.0;
  double bared_mm3 = 0.0;  ///< a mask's strips taken off the face
};

/// Moves all of `s` when its mouth is closed or its head not extended, and says so in its pose and findings; else leaves
/// every bit of it. Throws std::runtime_error when the moved patient would not be whole.
PositionFacts put_into_position(Segmentation& s, const std::function<void(double)>& progress = {});

/// All lengths by `factor` about the origin, said in the pose. Grey values stay.
void scale_lengths(Segmentation& s, double factor);

}  // namespace vallecula::pipeline
