// Takes the places out of a surface where it crosses itself.
#pragma once

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// Smooths about the crossings alone, or moves them along their normals where two sheets have passed through each other,
/// wider every few rounds, as long as something is gained; triangles and everything away from the crossings stay.
/// Returns the best that was reached: ask self_intersections() for what is left.
Surface mended(const Surface& surface);

}  // namespace vallecula::pipeline
