// The volume of a body that is known at the voxels' centres.
#pragma once

#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// Volume of the voxels whose centres lie where `field` is positive, mm^3: counted, as a label's is. A surface cut from the
/// field holds less where samples lie far apart (3 mm between slices), for it runs straight from one to the next where the
/// body is round: a hundredth of an adult's airway.
template <class Field>
double sampled_volume(const Grid& grid, const Field& field) {
  std::size_t inside = 0;
  for (std::size_t i = 0; i < grid.count(); ++i) inside += field(grid.position(i)) > 0.0 ? 1 : 0;
  return static_cast<double>(inside) * grid.voxel_mm3();
}

}  // namespace vallecula::pipeline
