// Takes the places out of a surface where it crosses itself.
#pragma once

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// Smooths about the crossings alone, wider every few rounds, until none is left or nothing more is gained; triangles
/// and everything away from the crossings stay. (Folds of a few triangles are what remeshing leaves; two sheets pushed
/// through each other may stay.) Returns the best that was reached: ask self_intersections() for what is left.
Surface mended(const Surface& surface);

}  // namespace vallecula::pipeline
