// Whether a patient and a scenario belong together, in words for a person.
#pragma once

#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// What speaks against a trial of this scenario on this patient, a sentence each; empty: nothing does. Its size (upper
/// gum to vallecula) against that of the scenario's infant, whether its import ever saw the glottis, and for a tube what
/// of its airway is assumed.
std::vector<std::string> misfits(const pipeline::PatientPackage& package, const curricula::Scenario& scenario);

}  // namespace vallecula::gui
