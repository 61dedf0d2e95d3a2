// How far two label maps agree: overlap and distances, structure by structure.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/exchange/label_image.h"

namespace vallecula::pipeline {

/// Surfaces are voxels with one of six neighbours outside, distances are between voxel centres. Structures that only
/// one of the two holds have voxel counts and no distances (NaN).
struct LabelAgreement {
  std::uint8_t label = 0;
  std::array<std::size_t, 2> voxels{};  ///< in a, in b
  std::array<double, 2> millilitres{};
  double dice = 0.0;
  double hausdorff_mm = 0.0;     ///< the largest distance from a surface to the other, of both ways
  double hausdorff_95_mm = 0.0;  ///< 95 % of a surface lie nearer than this to the other; the larger of both ways
  double mean_surface_mm = 0.0;  ///< mean over both surfaces of the distance to the other
};

struct Comparison {
  std::vector<LabelAgreement> structures;  ///< in the order of kLabelNames; those that either holds
  bool resampled = false;                  ///< b's grid was another: nearest neighbour on a's
};

/// Throws LabelMapError when the images do not overlap in space or a's axes are not at right angles.
Comparison compare_labels(const LabelImage& a, const LabelImage& b);

}  // namespace vallecula::pipeline
