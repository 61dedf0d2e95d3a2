// From a device's own axes to the patient's and back: motion one way, force the other, power the same on both sides.
#pragma once

#include "device/haptic_device.h"

namespace vallecula::device {

constexpr double kLeastMotionScale = 0.2, kMostMotionScale = 3.0;

/// How one device stands and is held; kept per device.
struct MapSettings {
  double motion_scale = 1.0;  ///< way of the tool over way of the hand
  /// How far the device is turned about its up axis against the person, rad, anticlockwise seen from above, -pi to pi.
  double turned_rad = 0.0;
  /// The same for the other hand: the device stands mirrored (turned the other way) and its first two buttons change
  /// places. Motion is not mirrored: right stays right.
  bool left_handed = false;
};

/// tip = offset + scale * view * device position;  tool rotation = view * device rotation * grip. `view` takes the
/// device's right, up and towards-the-person to those of the operator's view; offset and grip are set by centre().
class WorkspaceMap {
 public:
  /// Throws std::invalid_argument when a setting is out of its range.
  explicit WorkspaceMap(const MapSettings& settings);

  /// Directions of the operator's view in the patient's axes (unit, at right angles). The tool stands still only if
  /// centre() follows.
  void set_view_axes(const std::array<double, 3>& right, const std::array<double, 3>& up) noexcept;
  /// From here on this reading of the device is the tool at this pose. The rotations are normalised.
  void centre(const DeviceReading& device, const std::array<double, 3>& position_m,
              const std::array<double, 4>& rotation_wxyz) noexcept;

  DeviceReading to_patient(const DeviceReading& device) const noexcept;
  /// The transpose of the motion's map, so that force times velocity is the same on both sides, N.
  std::array<double, 3> force_to_device(const std::array<double, 3>& force_n) const noexcept;

 private:
  double scale_;
  bool swaps_buttons_;
  std::array<double, 4> turned_;
  std::array<double, 4> view_{1, 0, 0, 0};
  std::array<double, 3> offset_{0, 0, 0};
  std::array<double, 4> grip_{1, 0, 0, 0};
};

}  // namespace vallecula::device
