// The one interface behind which every input device stands.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace vallecula::device {

/// Pose of the tool: position of its tip and tool-to-world rotation (quaternion, w first). Metres; in the patient's
/// axes (LPS), or in the device's own where DeviceInfo::own_axes says so.
struct DeviceReading {
  std::array<double, 3> position_m{0, 0, 0};
  std::array<double, 4> rotation_wxyz{1, 0, 0, 0};
  std::uint32_t buttons = 0;
  bool valid =
      true;  ///< false: a fault holds; the pose is the hand's where it is still sensed, else the last known one
};

enum class DeviceFault : std::uint8_t {
  none,
  force_exceeded,
  communication_lost,
  unplugged,
  motor_warm,
  non_finite_command,
  servo_late,      ///< the driver's own loop, or whoever commands it, missed its deadline for too long
  not_calibrated,  ///< it works, but does not know where it stands
  driver_error,    ///< the driver reports an error that has no name here
  frozen           ///< none of the device's: somebody holds the trial
};
/// One plain sentence for a person.
const char* describe(DeviceFault fault) noexcept;
/// Its name in a file, as it is written here: "force_exceeded".
const char* name_of(DeviceFault fault) noexcept;
/// The fault of that name; none for any other.
DeviceFault fault_named(const std::string& name) noexcept;

/// Whether a device knows where it stands. No force is shown before it does.
enum class Calibration : std::uint8_t { not_needed, good, needs_update, needs_hand };

struct DeviceInfo {
  std::string kind;  ///< "scripted", "mouse", "touch", ...
  std::string model;
  std::string serial;               ///< empty: it has none
  std::string driver;               ///< through what it is driven: "libHD.so", "libusb", "hidapi"; empty: ourselves
  double rate_hz = 1000.0;          ///< of its own reports
  double peak_force_n = 0.0;        ///< 0: shows no force
  double continuous_force_n = 0.0;  ///< what it bears for long; 0: as its peak
  std::array<double, 3> workspace_m{0, 0, 0};  ///< width, height, depth; zero: unbounded
  int sensed_dof = 6;
  int actuated_dof = 0;
  /// Readings and forces are in the device's axes (+x right, +y up, +z towards the person, origin in the middle of its
  /// workspace) and a WorkspaceMap carries them to the patient's; false: they are in the patient's already.
  bool own_axes = false;
  double max_stiffness_n_m = 0.0;  ///< what it displays without buzzing; 0: it does not tell
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
  virtual Calibration calibration() const noexcept { return Calibration::not_needed; }
  /// 0 cold to 1 where the device switches off; negative: it does not tell.
  virtual double motor_warmth() const noexcept { return -1.0; }
  /// True where a fault that is over needs no hand to confirm it (a record of one that had).
  virtual bool confirms_itself() const noexcept { return false; }
  /// True where all it does is laid down beforehand over the time it is read at: that time stands while somebody holds
  /// the trial, and nobody has to take hold again.
  virtual bool plays_back() const noexcept { return false; }
  /// True when nothing more will come (the end of a script). A live device never finishes.
  virtual bool finished(double time_s) const noexcept {
    (void)time_s;
    return false;
  }
};

}  // namespace vallecula::device
