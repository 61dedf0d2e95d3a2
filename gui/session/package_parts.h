// What a package must have, or one clear message. Millimetres, LPS.
#pragma once

#include "engine/types.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// Both throw std::runtime_error naming the patient and what it lacks.
engine::Vec3 landmark(const pipeline::PatientPackage& package, const char* name);
const pipeline::Surface& surface(const pipeline::PatientPackage& package, const char* name);

/// The surface's points times `scale`.
engine::TriangleMesh mesh_of(const pipeline::Surface& surface, double scale = 1.0);

}  // namespace vallecula::gui
