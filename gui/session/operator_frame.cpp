#include "gui/session/operator_frame.h"

#include "gui/session/package_parts.h"

namespace vallecula::gui {

using engine::Vec3;

namespace {

constexpr double kTermSizeM = 0.0503;  // m, upper gum to vallecula of the term manikin

}  // namespace

OperatorFrame::OperatorFrame(const pipeline::PatientPackage& package) {
  origin = kMetres * landmark(package, "glottis_centre");
  left = Vec3::UnitX();
  const Vec3 to_eye = kMetres * landmark(package, "operator_eye") - origin;
  sight = (to_eye - to_eye.x() * left).normalized();
  lift = left.cross(sight);
  size =
      (kMetres * landmark(package, "vallecula") - kMetres * landmark(package, "upper_gum_midline")).norm() / kTermSizeM;
}

Vec3 OperatorFrame::at(double along_sight, double along_lift, double to_left) const {
  return origin + kMetres * size * (along_sight * sight + along_lift * lift + to_left * left);
}

}  // namespace vallecula::gui
