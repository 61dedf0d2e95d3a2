// A tube laid by hand on a way through a patient, for pictures and views: nothing is simulated.
#pragma once

#include "engine/snapshot.h"
#include "engine/tube/intubation.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui::window_test {

/// A tube of 3.5 mm with its stylet, and an airway of the package's landmarks: straight from the glottis to the carina,
/// the oesophagus behind it.
engine::IntubationDescription plain_intubation(const pipeline::PatientPackage& package);

/// Lays the rod along a smooth way through `way_mm` (from far beyond the tip to the hand), its tip `tip_mm` along that
/// way before the point `zero` of it; negative: beyond it, towards the hand. Sets has_intubation.
void lay_tube(engine::Snapshot& snapshot, const engine::IntubationDescription& intubation,
              const std::vector<engine::Vec3>& way_mm, std::size_t zero, double tip_mm);

/// From the carina through the glottis (point 1) and the right corner of the mouth to a hand at the patient's right.
std::vector<engine::Vec3> way_to_trachea(const pipeline::PatientPackage& package);
/// Behind the larynx into the oesophagus (its mouth is point 1).
std::vector<engine::Vec3> way_to_oesophagus(const pipeline::PatientPackage& package);

}  // namespace vallecula::gui::window_test
