// Hands that need no person: trajectories planned from a patient's landmarks.
#pragma once

#include <string>

#include "curricula/scenario.h"
#include "device/drivers/scripted_device.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// "expert": right corner, sweep, tip in the vallecula, lift along the handle, sight, withdrawal.
/// "novice": levers on the upper gum and presses past the device limit.
/// "press": presses the middle of the tongue's dorsum and withdraws; needs no open mouth.
/// Blade-tip poses in metres, LPS. Throws std::runtime_error for any other name.
device::Trajectory scripted_hand(const std::string& kind, const pipeline::PatientPackage& package,
                                 const curricula::Scenario& scenario);

/// The expert's, with the lift held until a time (s; 11.5 or later) and then a withdrawal that leaves a tube alone.
device::Trajectory expert_laryngoscopy(const pipeline::PatientPackage& package, double hold_until_s);

/// The package's own approach; where none was found yet and the vallecula lies clearly elsewhere before the glottis than
/// in the manikin, on which the expert's plan was made (a grown-up's lies farther off), one that brings the tip there.
pipeline::Approach usual_approach(const pipeline::PatientPackage& package);

}  // namespace vallecula::gui
