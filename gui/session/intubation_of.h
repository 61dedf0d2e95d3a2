// The second half of a scenario in a patient: tube, airway, cords, infant, secretions, as the engine takes them.
#pragma once

#include "curricula/scenario.h"
#include "engine/tube/intubation.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// SI units, LPS axes. `scenario.intubation` must be set. The device's limit stays the default: the hands set it. Throws
/// std::runtime_error with one message when the patient lacks what it needs, or when the tube does not go between its
/// gums.
engine::IntubationDescription intubation_of(const pipeline::PatientPackage& package, const curricula::Scenario& scenario);

}  // namespace vallecula::gui
