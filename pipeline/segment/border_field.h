// Smooth fields whose zero is a mask's border, from grey values where these agree with the mask.
#pragma once

#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {

/// `grey` (positive inside, about mm, within +-1) where its sign is the mask's: there it is finer than the voxels.
/// About the voxels where it is not, as in a structure drawn by a person, the smoothed distance from the mask's own
/// border. Blended over a voxel, so that the border has no step.
Volume<float> with_border_of(const Volume<float>& grey, const Mask& mask);

}  // namespace vallecula::pipeline
