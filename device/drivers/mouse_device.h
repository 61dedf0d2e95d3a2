// Mouse and keyboard as a hand: the window says how far things moved, the servo thread gets a smooth 1 kHz pose.
#pragma once

#include <atomic>

#include "device/latest_value.h"
#include "device/trajectory.h"

namespace vallecula::device {

struct MouseSettings {
  double max_speed_m_s = 0.25;  ///< of the blade tip; a brisk hand
  double max_turn_rad_s = 3.0;
  double smoothing_s = 0.02;      ///< time constant of each of two low-passes: mouse steps at 60 Hz leave no trace
  double lift_speed_m_s = 0.012;  ///< while the lift key is held
  double lift_range_m = 0.025;    ///< ANATOMY: the glottis is in full view by 15 mm
  /// ANATOMY: the blade comes level as it rises, by 10 degrees in 14 mm as in the scripted expert's lift. Raised as it
  /// lies its outer end presses on the gum long before the glottis is seen.
  double lift_levels_rad_m = 12.0;
  double lift_force_share = 0.75;  ///< of the device limit: the key lifts no further against it (assumed)
  /// Without a force told for so long the key lifts no further: the window stands, and what it told last is old. Some
  /// frames of a slow machine.
  double feel_age_s = 0.3;
  double workspace_m = 0.20;  ///< the target stays this near to where the tool was placed
};

/// Setters: one thread, the window's. read, write: one thread, the servo's. Both wait-free. Shows no force: the window
/// draws it instead.
class MouseDevice final : public HapticDevice {
 public:
  /// Throws DeviceError when a setting is not positive and finite.
  explicit MouseDevice(const MouseSettings& settings = {});

  // --- the window's thread -------------------------------------------------------------------------------------------
  /// Puts the tool there at once, without lift, and makes it the middle of the workspace. Call before a trial starts
  /// and at a reset. Ignored unless all numbers are finite.
  void place(const std::array<double, 3>& position_m, const std::array<double, 4>& rotation_wxyz) noexcept;
  /// World directions of the picture (unit vectors): to its right, to its top, and into it.
  void set_view_axes(const std::array<double, 3>& right, const std::array<double, 3>& up,
                     const std::array<double, 3>& forward) noexcept;
  /// Tip in the plane of the picture, m (mouse).
  void move(double right_m, double up_m) noexcept;
  /// Tip into the picture, m (wheel).
  void advance(double forward_m) noexcept;
  /// Turns about the tool's own axes through the tip, rad: pitch about +y (raises or lowers the handle), yaw about +z,
  /// roll about +x (the blade's length).
  void turn(double pitch_rad, double yaw_rad, double roll_rad) noexcept;
  /// Lift along the handle (tool +z), the blade coming level: +1 while the lift key is held, -1 while the lower key is,
  /// 0 when both are free; the tool then stays lifted as far as it came.
  void set_lift(double direction) noexcept;
  /// The force on the blade and the device limit, N: a hand would feel it, so the key lifts the slower the harder the
  /// tissue pulls. Told once, it is to be told again within feel_age_s for as long as the key shall lift; never told,
  /// there is no tissue, and the key lifts at its full speed. Ignored unless finite, and the limit positive.
  void feel(double force_n, double device_limit_n) noexcept;
  void set_buttons(std::uint32_t buttons) noexcept;

  // --- the servo's thread --------------------------------------------------------------------------------------------
  DeviceReading read(double time_s) noexcept override;
  void write(const std::array<double, 3>& force_n) noexcept override;

  // --- any thread ----------------------------------------------------------------------------------------------------
  DeviceInfo info() const override;
  DeviceFault fault() const noexcept override { return DeviceFault::none; }
  /// How far the tool is lifted now, m.
  double lift_m() const noexcept { return lift_shown_.load(std::memory_order_relaxed); }

 private:
  struct Target {
    std::array<double, 3> position_m{0, 0, 0};
    std::array<double, 4> rotation_wxyz{1, 0, 0, 0};
    double lift_direction = 0.0, lift_share = 1.0;
    std::uint32_t felt = 0;  ///< counts feel(); 0: nobody tells forces
    std::uint32_t buttons = 0;
    std::uint32_t placement = 0;  ///< counts place(): the servo then jumps instead of following
  };
  struct Stage {
    std::array<double, 3> position_m{0, 0, 0};
    std::array<double, 4> rotation_wxyz{1, 0, 0, 0};
  };
  void shift(const std::array<double, 3>& direction, double distance_m) noexcept;

  const MouseSettings settings_;
  // Window's side.
  Target target_;
  std::array<double, 3> centre_{0, 0, 0}, right_{1, 0, 0}, up_{0, -1, 0}, forward_{0, 0, -1};
  LatestValue<Target> handed_;
  // Servo's side.
  Stage limited_, smooth_, out_;  ///< follows the target at bounded speed; then two low-passes
  double lift_ = 0.0, smooth_lift_ = 0.0;
  std::uint32_t placement_ = 0, felt_ = 0;
  double now_s_ = 0.0, since_felt_s_ = 0.0;
  bool started_ = false;
  std::atomic<double> lift_shown_{0.0};
};

}  // namespace vallecula::device
