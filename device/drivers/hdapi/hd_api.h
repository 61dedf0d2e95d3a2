// What is used of HDAPI (OpenHaptics 3.x), the programming interface of 3D Systems' Touch family: types, numbers and
// functions under our own names. The library is the user's; nothing of it is linked or included.
#pragma once

namespace vallecula::device::hdapi {

using Handle = unsigned int;
constexpr Handle kNoDevice = 0xFFFFFFFFU;

struct ErrorInfo {
  unsigned int code = 0;
  int internal_code = 0;
  Handle device = kNoDevice;
};
constexpr int kMostErrors = 32;  // taken off the library's stack at once: one that never runs empty must not hold us

/// A callback of the library's servo loop; returns kGoOn or kDone.
using Callback = unsigned int (*)(void* data);
constexpr unsigned int kDone = 0, kGoOn = 1;
constexpr unsigned short kUsualPriority = 0x7FFF;

// State, asked for inside a frame.
constexpr unsigned int kButtons = 0x2000;      // int, one bit a button
constexpr unsigned int kTransform = 0x2052;    // 16 doubles, column by column, mm
constexpr unsigned int kJointAngles = 0x2100;  // 3 doubles, rad
// What the device is.
constexpr unsigned int kModel = 0x2501, kSerial = 0x2504;  // strings
constexpr unsigned int kUsableWorkspace = 0x2551;          // 6 doubles, mm: lowest x, y, z, highest x, y, z
constexpr unsigned int kInputDof = 0x2553, kOutputDof = 0x2554, kCalibrationStyles = 0x2555;  // ints
constexpr unsigned int kUpdateRate = 0x2600;                                                  // int, Hz
constexpr unsigned int kMaxStiffness = 0x2602;        // double, of 1: what the device holds without buzzing, N/mm
constexpr unsigned int kMaxForce = 0x2603;            // double, N
constexpr unsigned int kMaxContinuousForce = 0x2604;  // double, N
constexpr unsigned int kMotorTemperature = 0x2605;    // a double for each motor, 0 cold to 1 switched off
constexpr unsigned int kForce = 0x2700;               // 3 doubles, N, on the hand
constexpr unsigned int kForceOutput = 0x4000;         // to be enabled

constexpr unsigned int kSuccess = 0;
constexpr unsigned int kBadHandle = 0x104;
constexpr unsigned int kWarmMotors = 0x200, kExceededMaxForce = 0x201, kExceededMaxForceImpulse = 0x202,
                       kExceededMaxVelocity = 0x203, kForceError = 0x204;
constexpr unsigned int kDeviceFault = 0x300, kAlreadyInitiated = 0x301, kCommError = 0x302, kCommConfigError = 0x303,
                       kTimerError = 0x304;
constexpr unsigned int kIllegalBegin = 0x400, kIllegalEnd = 0x401, kFrameError = 0x402;
constexpr unsigned int kInvalidPriority = 0x500, kSchedulerFull = 0x501;
constexpr unsigned int kInvalidLicense = 0x600;

constexpr unsigned int kCalibrated = 0x5000, kNeedsUpdate = 0x5001, kNeedsHand = 0x5002;
constexpr unsigned int kStyleEncoderReset = 1, kStyleAutomatic = 2, kStyleInkWell = 4;

/// The library's functions, each resolved (load_library()).
struct Functions {
  Handle (*init_device)(const char* name) = nullptr;
  void (*disable_device)(Handle) = nullptr;
  void (*make_current)(Handle) = nullptr;
  void (*begin_frame)(Handle) = nullptr;
  void (*end_frame)(Handle) = nullptr;
  ErrorInfo (*get_error)() = nullptr;
  const char* (*error_text)(unsigned int code) = nullptr;
  void (*enable)(unsigned int capability) = nullptr;
  void (*disable)(unsigned int capability) = nullptr;
  void (*get_integers)(unsigned int what, int* values) = nullptr;
  void (*get_doubles)(unsigned int what, double* values) = nullptr;
  void (*set_doubles)(unsigned int what, const double* values) = nullptr;
  const char* (*get_string)(unsigned int what) = nullptr;
  unsigned int (*check_calibration)() = nullptr;
  void (*update_calibration)(unsigned int style) = nullptr;
  unsigned long (*schedule)(Callback, void* data, unsigned short priority) = nullptr;
  void (*unschedule)(unsigned long callback) = nullptr;
  void (*start_scheduler)() = nullptr;
  void (*stop_scheduler)() = nullptr;
};

}  // namespace vallecula::device::hdapi
