// Turns a sorted stack of slices onto the patient's axes.
#pragma once

#include <vector>

#include "pipeline/dicom/slice.h"

namespace vallecula::pipeline {

/// Slices sorted along their normal, evenly spaced, of one geometry. Stacks along the patient's axes (in any order and
/// sense) are only turned; oblique or tilted ones are interpolated linearly onto the smallest enclosing grid, outside
/// becoming air, and `resampled` says so.
Hounsfield to_patient_axes(const std::vector<Slice>& slices, bool& resampled);

}  // namespace vallecula::pipeline
