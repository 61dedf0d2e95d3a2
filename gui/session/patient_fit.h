// Whether a patient and a scenario belong together, in words for a person.
#pragma once

#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// Weight (kg) of the manikin that is as large as this patient, from upper gum to vallecula; lengths go with the
/// weight's cube root. A package holds no weight of its own.
double weight_as_large(const pipeline::PatientPackage& package);

/// A patient as large as an infant of this weight (kg) is no more than 15 % larger or smaller than the scenario's.
bool fits(const curricula::Scenario& scenario, double weight_kg);

/// What speaks against a trial of this scenario on this patient, a sentence each; empty: nothing does. Its size (upper
/// gum to vallecula) against that of the scenario's infant, whether its import ever saw the glottis, and for a tube
/// what of its airway is assumed.
std::vector<std::string> misfits(const pipeline::PatientPackage& package, const curricula::Scenario& scenario);

}  // namespace vallecula::gui
