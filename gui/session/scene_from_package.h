// Patient package + scenario -> the engine's scene. The one place where millimetres become metres.
#pragma once

#include "curricula/scenario.h"
#include "engine/scene.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// SI units, LPS axes. Throws std::runtime_error when the package lacks what a scene needs.
engine::SceneDescription scene_from_package(const pipeline::PatientPackage& package, const curricula::Scenario& scenario);

}  // namespace vallecula::gui
