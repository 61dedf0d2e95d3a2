#include "gui/session/held_tools.h"

namespace vallecula::gui {

using engine::Pose;

void HeldTools::follow(const Pose& device) noexcept {
  Pose& tool = held();
  if (own_) {
    tool = device;
    return;
  }
  tool.position = taken_tool_.position + (device.position - taken_device_.position);
  tool.rotation = ((device.rotation * taken_device_.rotation.conjugate()) * taken_tool_.rotation).normalized();
}

void HeldTools::change(const Pose& device) noexcept {
  in_hand_ = in_hand_ == Tool::blade ? Tool::tube : Tool::blade;
  taken_device_ = device;
  taken_tool_ = held();
  own_ = false;
}

void HeldTools::take_blade(const Pose& blade, const Pose& device) noexcept {
  in_hand_ = Tool::blade;
  blade_ = taken_tool_ = blade;
  taken_device_ = device;
  own_ = false;
}

Pose HeldTools::device_for(const Pose& tool) const noexcept {
  if (own_) return tool;
  Pose device;
  device.position = taken_device_.position + (tool.position - taken_tool_.position);
  device.rotation = ((tool.rotation * taken_tool_.rotation.conjugate()) * taken_device_.rotation).normalized();
  return device;
}

}  // namespace vallecula::gui
