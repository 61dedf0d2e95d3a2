// What the stand-in's devices are and how they stand; between its HDAPI side and its control side.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

namespace stand_in {

using HHD = unsigned int;
constexpr HHD kInvalid = 0xFFFFFFFFU;
struct HDErrorInfo {
  unsigned int errorCode;
  int internalErrorCode;
  HHD hHD;
};

struct Device {
  const char* name;
  const char* model;
  const char* serial;
  const char* set_up;  ///< what its configuration file holds: peak force, N; read as the vendor does, with the locale
  double peak_n, continuous_n, stiffness_n_mm, box_mm[6];
  int styles;
};
constexpr Device kDevices[] = {
    {"Default PHANToM", "Touch X", "TX-0042", "7.9", 7.9, 1.75, 2.35, {-180, -105, -70, 180, 135, 60}, 2},
    {"Right Device", "Touch", "T-0007", "3.3", 3.3, 0.88, 1.02, {-210, -110, -85, 210, 205, 130}, 4},
};
constexpr int kCount = 2;
constexpr int kLimitTurns = 200;        // asked for its peak for longer than this, a device switches its motors off
constexpr double kAtLimitShare = 0.99;  // from here on it counts as its peak

struct State {
  bool plugged = true, open = false, in_frame = false, output = false, motors_on = true, held_elsewhere = false,
       told = false;  // told: an error of it was there to be taken when the frame began
  double transform[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  int buttons = 0;
  double temperature[3] = {0.1, 0.1, 0.1};
  unsigned int calibration = 0x5000;
  unsigned int init_error = 0, frame_error = 0;
  double asked[3] = {0, 0, 0}, given[3] = {0, 0, 0};
  int turns_at_limit = 0, switched_off = 0;
  long frames = 0;
  HHD handle = kInvalid;
};

struct Scheduled {
  unsigned long id;
  unsigned int (*call)(void*);
  void* data;
};

extern std::recursive_mutex mutex;  // over all below
extern State states[kCount];
extern std::vector<HDErrorInfo> errors;
extern std::vector<Scheduled> callbacks;
extern int violations;
extern unsigned int start_error;  ///< with which the loop does not start; 0: it does
extern std::string violation;
extern std::atomic<bool> running, manual, hangs;

using Lock = std::lock_guard<std::recursive_mutex>;

void push(unsigned int code, HHD device);
/// One turn of the servo loop.
void turn();

inline void copy(const double* from, int count, double* to) {
  for (int i = 0; i < count; ++i) to[i] = from[i];
}

}  // namespace stand_in
