// How grainy a series is.
#pragma once

#include "pipeline/segment/head.h"

namespace vallecula::pipeline {

/// Standard deviation of the noise in soft tissue, HU, from the differences over a few voxels.
double noise_of(const Hounsfield& hu, const Mask& body, const Thresholds& t);

}  // namespace vallecula::pipeline
