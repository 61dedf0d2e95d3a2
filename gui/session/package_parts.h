// What a package must have, or one clear message. Millimetres, LPS.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "curricula/score/mouth.h"
#include "engine/types.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

constexpr double kMetres = 0.001;  ///< the one conversion from the package's millimetres

/// Both throw std::runtime_error naming the patient and what it lacks.
engine::Vec3 landmark(const pipeline::PatientPackage& package, const char* name);
const pipeline::Surface& surface(const pipeline::PatientPackage& package, const char* name);

/// The surface's points times `scale`.
engine::TriangleMesh mesh_of(const pipeline::Surface& surface, double scale = 1.0);

/// Every landmark in metres, and "glottis_normal", a direction, as it is.
std::map<std::string, pipeline::Point> landmarks_in_metres(const pipeline::PatientPackage& package);
/// Nothing where the landmarks span no mouth.
std::optional<curricula::Mouth> mouth_of(const pipeline::PatientPackage& package);

}  // namespace vallecula::gui
