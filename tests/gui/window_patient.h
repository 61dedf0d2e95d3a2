// A coarse head of a few smooth shapes, made in memory: enough for views and pages to be tested without an import.
#pragma once

#include "engine/snapshot.h"
#include "engine/types.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui::window_test {

/// Skin, open mouth, throat, windpipe, tongue and epiglottis near ANATOMY's places; mm, LPS.
pipeline::PatientPackage coarse_patient();

/// A straight closed blade in the tool frame, m: 80 x 10 x 2 mm, tip at the origin.
engine::TriangleMesh plain_blade();

/// A snapshot with the tongue pushed along the lift direction by `lift_mm` and the blade `into` the mouth: 0 before the
/// lips, 1 in the vallecula.
engine::Snapshot lifted_snapshot(const pipeline::PatientPackage& package, double into, double lift_mm);

}  // namespace vallecula::gui::window_test
