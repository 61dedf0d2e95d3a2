// Turns a volume onto the patient's axes.
#pragma once

#include "pipeline/dicom/ct_volume.h"
#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// Volumes along the patient's axes (in any order and sense, off by no more than kExactMm at the far corner) are only
/// turned, exactly; oblique or sheared ones are interpolated linearly onto the smallest enclosing grid, outside
/// becoming air, and `resampled` says so. Throws SeriesError when that grid is beyond kMostVoxels.
Hounsfield to_patient_axes(const CtVolume& volume, bool& resampled);

}  // namespace vallecula::pipeline
