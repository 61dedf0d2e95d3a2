// One device, two tools: the hand moves one of them, the other stays where it was left.
#pragma once

#include "engine/types.h"

namespace vallecula::gui {

enum class Tool : std::uint8_t { blade = 0, tube = 1 };

class HeldTools {
 public:
  /// The hand has the blade, where the device is; the tube lies at `tube`.
  explicit HeldTools(const engine::Pose& tube) noexcept : tube_(tube) {}

  /// The hand's new pose: the tool in it moves as the device does.
  void follow(const engine::Pose& device) noexcept;
  /// The hand lets go of its tool and takes the other, where that is: nothing jumps. `device`: where it does so.
  void change(const engine::Pose& device) noexcept;

  /// The hand takes the blade, which is at `blade`, with the device where it is.
  void take_blade(const engine::Pose& blade, const engine::Pose& device) noexcept;

  Tool in_hand() const noexcept { return in_hand_; }
  const engine::Pose& blade() const noexcept { return blade_; }
  const engine::Pose& tube() const noexcept { return tube_; }
  /// Where the device would be with the tool in the hand at `tool`.
  engine::Pose device_for(const engine::Pose& tool) const noexcept;

 private:
  engine::Pose& held() noexcept { return in_hand_ == Tool::blade ? blade_ : tube_; }

  Tool in_hand_ = Tool::blade;
  engine::Pose blade_, tube_;
  engine::Pose taken_device_, taken_tool_;  ///< when the hand took hold
  bool own_ = true;                         ///< the tool is the device's pose itself: no change so far
};

}  // namespace vallecula::gui
