#include "device/workspace_map.h"

#include <stdexcept>
#include <string>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

double within(double value, double low, double high, const char* name) {
  if (!(value >= low && value <= high)) {
    throw std::invalid_argument(std::string("workspace map: ") + name + " = " + std::to_string(value) + "; expected " +
                                std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

std::uint32_t first_two_exchanged(std::uint32_t buttons) noexcept {
  return (buttons & ~3u) | (buttons & 1u) << 1 | (buttons & 2u) >> 1;
}

}  // namespace

WorkspaceMap::WorkspaceMap(const MapSettings& settings)
    : scale_(within(settings.motion_scale, kLeastMotionScale, kMostMotionScale, "motion_scale")), swaps_buttons_(settings.left_handed) {
  const double turned = within(settings.turned_rad, -M_PI, M_PI, "turned_rad");
  turned_ = about_axis({0, 1, 0}, settings.left_handed ? -turned : turned);
  set_view_axes({-1, 0, 0}, {0, -1, 0});  // somebody who stands at the head and looks down the body
}

void WorkspaceMap::set_view_axes(const std::array<double, 3>& right, const std::array<double, 3>& up) noexcept {
  view_ = multiply(from_axes(right, up, cross(right, up)), turned_);
}

void WorkspaceMap::centre(const DeviceReading& device, const std::array<double, 3>& position_m,
                          const std::array<double, 4>& rotation_wxyz) noexcept {
  offset_ = subtract(position_m, scale(rotate(view_, device.position_m), scale_));
  grip_ = normalised(multiply(inverse(multiply(view_, normalised(device.rotation_wxyz))), normalised(rotation_wxyz)));
}

DeviceReading WorkspaceMap::to_patient(const DeviceReading& device) const noexcept {
  DeviceReading tool = device;
  tool.position_m = add(offset_, scale(rotate(view_, device.position_m), scale_));
  tool.rotation_wxyz = multiply(multiply(view_, device.rotation_wxyz), grip_);
  if (swaps_buttons_) tool.buttons = first_two_exchanged(device.buttons);
  return tool;
}

std::array<double, 3> WorkspaceMap::force_to_device(const std::array<double, 3>& force_n) const noexcept {
  return scale(rotate(inverse(view_), force_n), scale_);
}

}  // namespace vallecula::device
