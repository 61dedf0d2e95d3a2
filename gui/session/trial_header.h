// What a trial's log says of who, where and with what before its first tick, as far as patient, scenario and scene decide it.
#pragma once

#include "curricula/scenario.h"
#include "curricula/trial_log.h"
#include "engine/scene.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// Of this build. The caller adds where package and curriculum are, the hands and how the trial runs.
curricula::LogHeader header_of(const pipeline::PatientPackage& package, const curricula::Scenario& scenario,
                               const engine::SceneDescription& scene);

}  // namespace vallecula::gui
