// The one interface behind which every input device stands.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace vallecula::device {

/// Device pose in patient axes (LPS, m): blade tip position and tool-to-world rotation (quaternion, w first).
struct DeviceReading {
  std::array<double, 3> position_m{0, 0, 0};
  std::array<double, 4> rotation_wxyz{1, 0, 0, 0};
  std::uint32_t buttons = 0;
  bool valid = true;   ///< false: a fault holds; the pose is the last known one
};

enum class DeviceFault : std::uint8_t {
  none,
  force_exceeded,
  communication_lost,
  unplugged,
  motor_warm,
  non_finite_command
};
/// One plain sentence for a person.
const char* describe(DeviceFault fault) noexcept;

struct DeviceInfo {
  std::string kind;            ///< "scripted", "mouse", ...
  std::string model;
  double rate_hz = 1000.0;
  double peak_force_n = 0.0;   ///< 0: shows no force
};

class HapticDevice {
 public:
  virtual ~HapticDevice() = default;
  virtual DeviceInfo info() const = 0;
  /// Called once a tick by the servo thread with the tick's nominal time (s); wait-free.
  virtual DeviceReading read(double time_s) noexcept = 0;
  /// Force to show, N, world axes, already through the output chain. Called once after every read; wait-free.
  virtual void write(const std::array<double, 3>& force_n) noexcept = 0;
  virtual DeviceFault fault() const noexcept = 0;
  /// True when nothing more will come (the end of a script). A live device never finishes.
  virtual bool finished(double time_s) const noexcept { (void)time_s; return false; }
};

}  // namespace vallecula::device
