// A cap that springs back steers by speed: how far it is pushed says how fast the blade goes.
#pragma once

#include "device/drivers/spacemouse/spacemouse_report.h"
#include "device/trajectory.h"

namespace vallecula::device {

struct RateSettings {
  double max_speed_m_s = 0.06;  ///< of the tip, the cap pushed to its stop; the blade's length in 2 s
  double max_turn_rad_s = 1.0;  ///< the cap turned to its stop
  double full_counts = 350.0;   ///< reported at the stops (check: some models go further; they are held to this)
  double dead_zone = 0.06;      ///< share of full_counts that counts as hands off: a cap at rest is a few counts off
  double smoothing_s = 0.02;    ///< low-pass of the speed: reports come at 60 to 125 Hz, ticks at 1000
  double silence_s = 0.1;       ///< after so long without a report the rate is zero; a cap that is held keeps reporting
  double workspace_m = 0.4;     ///< edge of the cube the tip stays in, centred at the origin
};

/// Used by one thread, the servo's. Poses are in the device's own axes (+x right, +y up, +z towards the person).
class RateControl {
 public:
  /// Throws DeviceError when a setting is not positive and finite, or the dead zone is not below one.
  explicit RateControl(const RateSettings& settings = {});

  /// The pose at `time_s` (s): the last one moved on at the speed the cap asks for. The tip's speed never exceeds
  /// max_speed_m_s, the turn max_turn_rad_s; turns are about the device's axes through the tip. Begins at the origin,
  /// unturned. Wait-free.
  DeviceReading step(const SpaceMouseState& cap, double time_s) noexcept;
  /// The last pose, at rest; counts the time, so that nothing is caught up later. For a device that is gone.
  DeviceReading hold(double time_s) noexcept;

 private:
  double advance_clock(double time_s) noexcept;

  const RateSettings settings_;
  DeviceReading reading_;
  std::array<double, 3> speed_m_s_{0, 0, 0}, turn_rad_s_{0, 0, 0};
  std::uint32_t translation_reports_ = 0, rotation_reports_ = 0;
  double translation_silent_s_ = 0.0, rotation_silent_s_ = 0.0;
  double now_s_ = 0.0;
  bool started_ = false;
};

}  // namespace vallecula::device
