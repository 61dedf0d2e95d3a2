#include "gui/session/operator_axes.h"

#include <stdexcept>

namespace vallecula::gui {

OperatorAxes operator_axes(const engine::Vec3& eye, const engine::Vec3& mouth) {
  const engine::Vec3 forward = (mouth - eye).normalized();
  const engine::Vec3 anterior = -engine::Vec3::UnitY();
  OperatorAxes axes;
  axes.up = (anterior - anterior.dot(forward) * forward).normalized();
  axes.right = forward.cross(axes.up);
  return axes;
}

OperatorAxes operator_axes(const pipeline::PatientPackage& package) {
  const auto at = [&](const char* name) {
    const auto found = package.landmarks.find(name);
    if (found == package.landmarks.end())
      throw std::runtime_error("patient '" + package.name + "': it has no landmark '" + name + "'; import it again");
    return engine::Vec3(found->second[0], found->second[1], found->second[2]);
  };
  return operator_axes(at("operator_eye"), 0.5 * (at("upper_gum_midline") + at("lower_gum_midline")));
}

}  // namespace vallecula::gui
