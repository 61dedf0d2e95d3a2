#include "device/drivers/hdapi/hd_decode.h"

#include <algorithm>
#include <cstdio>

namespace vallecula::device::hdapi {
namespace {

struct Named {
  unsigned int code;
  const char* name;
  DeviceFault fault;
};
constexpr DeviceFault kForceFault = DeviceFault::force_exceeded, kLost = DeviceFault::communication_lost;
constexpr Named kErrors[] = {{kSuccess, "HD_SUCCESS", DeviceFault::none},
                             {0x100, "HD_INVALID_ENUM", DeviceFault::driver_error},
                             {0x101, "HD_INVALID_VALUE", DeviceFault::driver_error},
                             {0x102, "HD_INVALID_OPERATION", DeviceFault::driver_error},
                             {0x103, "HD_INVALID_INPUT_TYPE", DeviceFault::driver_error},
                             {kBadHandle, "HD_BAD_HANDLE", DeviceFault::driver_error},
                             {kWarmMotors, "HD_WARM_MOTORS", DeviceFault::motor_warm},
                             {kExceededMaxForce, "HD_EXCEEDED_MAX_FORCE", kForceFault},
                             {kExceededMaxForceImpulse, "HD_EXCEEDED_MAX_FORCE_IMPULSE", kForceFault},
                             {kExceededMaxVelocity, "HD_EXCEEDED_MAX_VELOCITY", kForceFault},
                             {kForceError, "HD_FORCE_ERROR", DeviceFault::driver_error},
                             {kDeviceFault, "HD_DEVICE_FAULT", kLost},
                             {kAlreadyInitiated, "HD_DEVICE_ALREADY_INITIATED", DeviceFault::driver_error},
                             {kCommError, "HD_COMM_ERROR", kLost},
                             {kCommConfigError, "HD_COMM_CONFIG_ERROR", kLost},
                             {kTimerError, "HD_TIMER_ERROR", DeviceFault::servo_late},
                             {kIllegalBegin, "HD_ILLEGAL_BEGIN", DeviceFault::driver_error},
                             {kIllegalEnd, "HD_ILLEGAL_END", DeviceFault::driver_error},
                             {kFrameError, "HD_FRAME_ERROR", DeviceFault::driver_error},
                             {kInvalidPriority, "HD_INVALID_PRIORITY", DeviceFault::driver_error},
                             {kSchedulerFull, "HD_SCHEDULER_FULL", DeviceFault::driver_error},
                             {kInvalidLicense, "HD_INVALID_LICENSE", DeviceFault::driver_error}};

const Named* find(unsigned int code) noexcept {
  const auto* found =
      std::find_if(std::begin(kErrors), std::end(kErrors), [&](const Named& e) { return e.code == code; });
  return found == std::end(kErrors) ? nullptr : found;
}

}  // namespace

DeviceFault fault_of(unsigned int code) noexcept {
  const Named* known = find(code);
  return known != nullptr ? known->fault : DeviceFault::driver_error;
}

DeviceFault fault_of_standing(double for_s) noexcept {
  if (for_s > 0.5) return DeviceFault::communication_lost;
  return for_s > 0.05 ? DeviceFault::servo_late : DeviceFault::none;
}

std::string name_of(unsigned int code) {
  if (const Named* known = find(code)) return known->name;
  char text[32];
  std::snprintf(text, sizeof text, "error 0x%x", code);
  return text;
}

std::string mend_of(unsigned int code) {
  switch (code) {
    case kAlreadyInitiated:
    case kTimerError:
      return "Another program, or this one, has it open already: close the other and try again";
    case kInvalidLicense:
      return "The library asks for a licence: install OpenHaptics' licence as 3D Systems describes";
    case kCommConfigError:
      return "No device of that name is set up: run the vendor's Touch setup program, pair the device, and give the "
             "name it shows (touch:NAME)";
    default:
      return "Check the device's cable and power; close other programs that use it; for the permission copy "
             "packaging/60-vallecula.rules to /etc/udev/rules.d and plug the device in again; pair it in the vendor's "
             "Touch setup program";
  }
}

Calibration calibration_of(unsigned int status) noexcept {
  switch (status) {
    case kCalibrated:
      return Calibration::good;
    case kNeedsUpdate:
      return Calibration::needs_update;
    default:
      return Calibration::needs_hand;  // an unknown status: no force
  }
}

std::optional<Pose> pose_of(const double (&m)[16], const Vector& middle_mm) noexcept {
  for (const double v : m) {
    if (!std::isfinite(v)) return std::nullopt;
  }
  const Vector x{m[0], m[1], m[2]}, y{m[4], m[5], m[6]}, z{m[8], m[9], m[10]};
  constexpr double kLoose = 0.01;
  if (std::abs(length(x) - 1.0) > kLoose || std::abs(length(y) - 1.0) > kLoose || std::abs(length(z) - 1.0) > kLoose ||
      length(subtract(cross(x, y), z)) > 2.0 * kLoose) {
    return std::nullopt;
  }
  return Pose{scale(subtract({m[12], m[13], m[14]}, middle_mm), 1e-3), from_axes(x, y, z)};
}

double warmth_of(const double* temperatures, int motors) noexcept {
  double warmth = -1.0;
  for (int i = 0; i < motors; ++i) {
    if (std::isfinite(temperatures[i])) warmth = std::max(warmth, std::clamp(temperatures[i], 0.0, 1.0));
  }
  return warmth;
}

}  // namespace vallecula::device::hdapi
