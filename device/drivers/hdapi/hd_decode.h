// What HDAPI's numbers mean here. Pure functions.
#pragma once

#include <optional>
#include <string>

#include "device/drivers/hdapi/hd_api.h"
#include "device/haptic_device.h"
#include "device/rotation.h"

namespace vallecula::device::hdapi {

/// The fault that an error code stands for; none for success.
DeviceFault fault_of(unsigned int code) noexcept;

/// Of a loop that has been standing still for this long: servo_late beyond 50 ms, communication_lost beyond half a
/// second.
DeviceFault fault_of_standing(double for_s) noexcept;

/// "HD_COMM_ERROR"; "error 0x999" for a code that has no name here.
std::string name_of(unsigned int code);

/// What a person can do when a device cannot be opened with this error.
std::string mend_of(unsigned int code);

Calibration calibration_of(unsigned int status) noexcept;

struct Pose {
  Vector position_m{0, 0, 0};  ///< device axes, from the middle of the workspace
  /// Of the stylus: its +z runs from its tip to its back end (check), its +y up at rest.
  Rotation rotation{1, 0, 0, 0};
};

/// From the column-major transform (mm); nothing when a number is not finite or the axes are no right-handed
/// orthonormal frame (to 1 %).
std::optional<Pose> pose_of(const double (&transform)[16], const Vector& middle_mm) noexcept;

/// Hottest motor, 0 to 1; negative when no number is usable.
double warmth_of(const double* temperatures, int motors) noexcept;

}  // namespace vallecula::device::hdapi
