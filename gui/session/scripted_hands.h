// Hands that need no person: trajectories planned from a patient's landmarks.
#pragma once

#include <array>
#include <string>

#include "curricula/scenario.h"
#include "device/drivers/scripted_device.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

constexpr std::array<const char*, 8> kScriptedHands = {"expert",  "novice",      "press",    "levers",
                                                       "too-far", "off-midline", "forceful", "many-tries"};

/// "expert": right corner, sweep, tip in the vallecula, lift along the handle, sight, withdrawal.
/// "novice": levers on the upper gum and presses past the device limit.
/// "press": presses the middle of the tongue's dorsum and withdraws; needs no open mouth.
/// Faults, each the expert's plan but for one thing, so that its own figure tells it (tests/gui/scripted_faults_test.cpp):
/// "levers": turns the blade about the upper gum instead of lifting. "too-far": passes the vallecula towards the
/// oesophagus. "off-midline": works at the right side of the throat. "forceful": lifts harder than the view needs, and
/// holds on for longer. "many-tries": in and out twice before.
/// Blade-tip poses in metres, LPS. Throws std::runtime_error for any other name.
device::Trajectory scripted_hand(const std::string& kind, const pipeline::PatientPackage& package,
                                 const curricula::Scenario& scenario);

/// The expert's, with the lift held until a time (s; 11.5 or later) and then a withdrawal that leaves a tube alone.
device::Trajectory expert_laryngoscopy(const pipeline::PatientPackage& package, double hold_until_s);

/// Of the expert's way what leads the blade's tip into the vallecula, before any lift, in kLeadInS.
device::Trajectory way_to_vallecula(const pipeline::PatientPackage& package);
constexpr double kLeadInS = 2.4;  ///< 2.5 times as fast as the expert goes it: no contact then comes to the device's limit

/// The package's own approach; where none was found yet and the vallecula lies clearly elsewhere before the glottis than
/// in the manikin, on which the expert's plan was made (a grown-up's lies farther off), one that brings the tip there.
pipeline::Approach usual_approach(const pipeline::PatientPackage& package);

}  // namespace vallecula::gui
