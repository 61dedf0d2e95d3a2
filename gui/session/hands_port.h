// The engine's port onto the hands: poses in, forces out.
#pragma once

#include <atomic>
#include <optional>

#include "device/action_plan.h"
#include "device/guarded_device.h"
#include "device/trajectory.h"
#include "engine/haptics/port.h"
#include "gui/session/hand_actions.h"
#include "gui/session/held_tools.h"

namespace vallecula::gui {

/// Where a script or a place to begin at has the tool.
engine::Pose pose_of(const device::Keyframe& at);

/// A pause of any device is an input in which nothing is valid, so that all that changes the engine's way is in the
/// tick's record. Whatever is given must outlive it.
class HandsPort final : public engine::HapticPort {
 public:
  /// The blade's hand alone, of which nothing is asked besides.
  explicit HandsPort(device::GuardedDevice& blade) : first_(blade) {}
  /// The blade's hand alone.
  HandsPort(device::GuardedDevice& blade, const device::ActionPlan& plan, const HandActions& actions)
      : first_(blade), plan_(&plan), actions_(&actions), holds_(actions.holds()) {}
  /// A device for each hand.
  HandsPort(device::GuardedDevice& blade, device::GuardedDevice& tube, const device::ActionPlan& plan,
            const HandActions& actions)
      : first_(blade), second_(&tube), plan_(&plan), actions_(&actions), holds_(actions.holds()) {}
  /// One device that takes blade and tube in turn, by HandActions::change_hand() or by `change_button` (a bit of the
  /// device's, 0: none); the tube lies at `tube`.
  HandsPort(device::GuardedDevice& device, const engine::Pose& tube, std::uint32_t change_button,
            const device::ActionPlan& plan, const HandActions& actions);

  /// Before the first tick: the blade goes `way` by itself, one of `ticks` equal parts in each tick in which the hands
  /// could be used; then the blade's hand has it where it is then, and moves it from there. Until then that hand feels
  /// and moves nothing.
  void lead_in(device::Trajectory way, std::int64_t ticks);
  /// Any thread: that is still so.
  bool led_in() const noexcept { return led_in_.load(std::memory_order_relaxed); }

  engine::PortInput read(double time_s) noexcept override;
  void see_tool(const engine::Pose& tool) noexcept override;
  void write(const engine::Vec3& force_n) noexcept override;
  void write_second(const engine::Vec3& force_n) noexcept override;

  /// How long scripts and records have been kept waiting by whoever held the trial, s. Any thread.
  double waited_s() const noexcept { return waited_s_.load(std::memory_order_relaxed); }
  /// Which tool the one device has; with a device for each hand the blade's. Any thread.
  Tool in_hand() const noexcept { return in_hand_.load(std::memory_order_relaxed); }

 private:
  void take_turns(const device::DeviceReading& reading, engine::PortInput& input) noexcept;
  engine::Pose back_in_place(const engine::Pose& blade) noexcept;
  void take_hold(std::uint32_t holds, const engine::Pose& device) noexcept;
  void lead(const engine::Pose& device, engine::PortInput& input) noexcept;

  device::GuardedDevice& first_;
  device::GuardedDevice* second_ = nullptr;
  HeldTools held_{engine::Pose{}};
  bool takes_turns_ = false;
  const device::ActionPlan* plan_ = nullptr;
  const HandActions* actions_ = nullptr;
  std::uint32_t change_button_ = 0, buttons_ = 0, changes_ = 0, holds_ = 0;
  std::optional<device::Trajectory> way_;  ///< that the blade is led
  std::int64_t led_ticks_ = 0, lead_ticks_ = 0;
  std::atomic<bool> led_in_{false};
  double now_s_ = 0.0;
  std::atomic<double> waited_s_{0.0};
  std::optional<engine::Pose> returns_from_;  ///< where a pause had the blade that no hand has, on its way back
  double returns_at_s_ = 0.0;                 ///< when it set out
  bool valid_ = false;                        ///< in the last tick
  std::optional<engine::Pose> seen_;          ///< where the scene holds the blade; none: there was no tick yet
  engine::Pose device_;                       ///< of the last valid tick
  std::atomic<Tool> in_hand_{Tool::blade};
};

}  // namespace vallecula::gui
