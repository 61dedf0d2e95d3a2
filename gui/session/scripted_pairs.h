// Two hands that need no person: laryngoscopy and tube, planned from a patient's airway.
#pragma once

#include <array>
#include <string>

#include "curricula/scenario.h"
#include "device/action_plan.h"
#include "device/trajectory.h"
#include "engine/tube/intubation.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

struct ScriptedPair {
  device::Trajectory blade, tube;  ///< `tube`: of the grip
  device::ActionPlan actions;
};

/// "expert": laryngoscopy, lift held, tube from the right corner along the blade's right side between the cords to the
/// middle of the trachea, stylet out, blade out, breaths. The others go as it does but for what their name says: tube
/// too shallow, too deep, into a main bronchus, into the oesophagus; given up after the view; never given up. In the
/// delivery room, where the heart is slow, all begin with breaths by mask until this infant's is above 100, 30 to 60 s.
constexpr std::array<const char*, 7> kScriptedPairs = {"expert",     "shallow", "deep", "mainstem",
                                                       "oesophagus", "abandon", "late"};

/// Throws std::runtime_error for any other name.
ScriptedPair scripted_pair(const std::string& kind, const pipeline::PatientPackage& package,
                           const curricula::Scenario& scenario, const engine::IntubationDescription& intubation);

}  // namespace vallecula::gui
