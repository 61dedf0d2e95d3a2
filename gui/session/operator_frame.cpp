#include "gui/session/operator_frame.h"

#include <stdexcept>

namespace vallecula::gui {

using engine::Vec3;

namespace {

constexpr double kMetres = 0.001;
constexpr double kTermSize = 0.0503;  // m, upper gum to vallecula of the term manikin

Vec3 landmark(const pipeline::PatientPackage& package, const char* name) {
  const auto found = package.landmarks.find(name);
  if (found == package.landmarks.end())
    throw std::runtime_error("patient '" + package.name + "': it has no landmark '" + name + "'; import it again");
  return Vec3(found->second[0], found->second[1], found->second[2]) * kMetres;
}

}  // namespace

OperatorFrame::OperatorFrame(const pipeline::PatientPackage& package) {
  origin = landmark(package, "glottis_centre");
  left = Vec3::UnitX();
  const Vec3 to_eye = landmark(package, "operator_eye") - origin;
  sight = (to_eye - to_eye.x() * left).normalized();
  lift = left.cross(sight);
  size = (landmark(package, "vallecula") - landmark(package, "upper_gum_midline")).norm() / kTermSize;
}

Vec3 OperatorFrame::at(double along_sight, double along_lift, double to_left) const {
  return origin + kMetres * size * (along_sight * sight + along_lift * lift + to_left * left);
}

}  // namespace vallecula::gui
