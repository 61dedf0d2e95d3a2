// The axes of the operator's view in the patient, for the picture and for the hands.
#pragma once

#include "engine/types.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

struct OperatorAxes {
  engine::Vec3 right = -engine::Vec3::UnitX(), up = -engine::Vec3::UnitY();  ///< unit, patient LPS
};
/// Of an eye that looks at the mouth (in one unit, LPS), anterior up.
OperatorAxes operator_axes(const engine::Vec3& eye, const engine::Vec3& mouth);
/// Of the operator of a patient. Throws std::runtime_error naming the landmark that is missing.
OperatorAxes operator_axes(const pipeline::PatientPackage& package);

}  // namespace vallecula::gui
