// The axes in which scripted hands are planned.
#pragma once

#include "engine/types.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// The operator's own axes in a patient, origin at the glottis: `sight` towards the eye, `lift` across it towards the
/// tongue (the way a right lift goes: CLINICAL.md, along the handle), `left` to the patient's left. Metres, LPS.
struct OperatorFrame {
  /// Throws std::runtime_error naming a landmark that is missing.
  explicit OperatorFrame(const pipeline::PatientPackage& package);
  /// Millimetres of a term infant along sight, lift and left, scaled to this one.
  engine::Vec3 at(double along_sight, double along_lift, double to_left) const;

  engine::Vec3 origin, sight, lift, left;
  double size = 1.0;
};

}  // namespace vallecula::gui
