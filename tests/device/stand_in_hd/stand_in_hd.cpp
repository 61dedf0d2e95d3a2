// A libHD.so of our own for the tests: HDAPI's functions over devices that do not exist, with a servo loop of its own,
// their limits, and every fault on command (control.h). Built as a shared library named libHD.so; the driver loads it
// as it loads the vendor's. It knows nothing of the driver: types and numbers are written down here once more.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "tests/device/stand_in_hd/stand_in_state.h"

extern "C" void hdUnschedule(unsigned long id);

namespace stand_in {

std::recursive_mutex mutex;
State states[kCount];
std::vector<HDErrorInfo> errors;
std::vector<Scheduled> callbacks;
int violations = 0;
unsigned int start_error = 0;
std::string violation;
std::atomic<bool> running{false}, manual{false}, hangs{false};

namespace {

std::mutex loop;  // held for one turn of the servo loop
HHD current = kInvalid, next_handle = 1;
unsigned long next_callback = 1;
std::thread servo;

void violate(const char* what) {
  ++violations;
  violation = what;
}

State* of(HHD handle) {
  for (State& s : states) {
    if (s.open && s.handle == handle) return &s;
  }
  push(0x104, handle);
  return nullptr;
}
const Device& kind_of(const State* s) { return kDevices[s - states]; }

}  // namespace

void push(unsigned int code, HHD device) {
  if (errors.size() < 64) errors.push_back({code, static_cast<int>(code) & 0xFF, device});
}

/// Allocates nothing: the tests count what the driver allocates in its callback.
void turn() {
  const std::lock_guard<std::mutex> turning(loop);
  Scheduled now[8];
  std::size_t count = 0;
  {
    const Lock lock(mutex);
    count = std::min<std::size_t>(callbacks.size(), 8);
    std::copy_n(callbacks.begin(), count, now);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (now[i].call(now[i].data) != 1) hdUnschedule(now[i].id);
  }
}

}  // namespace stand_in

using namespace stand_in;

extern "C" {

HHD hdInitDevice(const char* name) {
  const Lock lock(mutex);
  if (running) violate("a device opened while the loop turns");
  int which = -1;
  for (int i = 0; i < kCount; ++i) {
    if (name != nullptr && std::strcmp(name, kDevices[i].name) == 0) which = i;
  }
  if (which < 0) {  // so the default, a null name, on a Linux whose set-up calls it otherwise
    push(0x303, kInvalid);
    return kInvalid;
  }
  State& s = states[which];
  if (s.open) {
    push(0x301, kInvalid);
    return kInvalid;
  }
  if (s.init_error != 0 || !s.plugged) {
    push(s.init_error != 0 ? s.init_error : 0x302, kInvalid);
    return kInvalid;
  }
  if (std::strtod(kDevices[which].set_up, nullptr) != kDevices[which].peak_n) {
    push(0x303, kInvalid);
    return kInvalid;
  }
  s.open = true;
  s.output = false;
  s.motors_on = true;
  s.in_frame = false;
  s.turns_at_limit = 0;
  s.handle = next_handle++;
  current = s.handle;
  return s.handle;
}

void hdDisableDevice(HHD handle) {
  const Lock lock(mutex);
  if (running) violate("a device closed while the loop turns");
  if (State* s = of(handle)) {
    s->open = false;
    std::fill(s->given, s->given + 3, 0.0);
  }
}

void hdMakeCurrentDevice(HHD handle) {
  const Lock lock(mutex);
  if (of(handle) != nullptr) current = handle;
}

void hdBeginFrame(HHD handle) {
  const Lock lock(mutex);
  State* s = of(handle);
  if (s == nullptr) return;
  current = handle;
  if (s->in_frame) push(0x400, handle);
  s->in_frame = true;
  ++s->frames;
  std::fill(s->asked, s->asked + 3, 0.0);
  if (!s->plugged) push(0x302, handle);
  if (s->frame_error != 0) push(s->frame_error, handle);
  for (const double t : s->temperature) {
    if (t < 1.0) continue;
    s->motors_on = false;
    push(0x200, handle);
    break;
  }
  s->told = std::any_of(errors.begin(), errors.end(), [&](const HDErrorInfo& e) { return e.hHD == handle; });
}

#ifndef STAND_IN_LACKS_FUNCTIONS
void hdEndFrame(HHD handle) {
  const Lock lock(mutex);
  State* s = of(handle);
  if (s == nullptr) return;
  if (!s->in_frame) push(0x401, handle);
  s->in_frame = false;
  const double peak = kind_of(s).peak_n;
  double norm = std::sqrt(s->asked[0] * s->asked[0] + s->asked[1] * s->asked[1] + s->asked[2] * s->asked[2]);
  if (!std::isfinite(norm)) {
    violate("a force that is not a number");
    norm = 0.0;
    std::fill(s->asked, s->asked + 3, 0.0);
  }
  if (norm > peak * (1.0 + 1e-12)) violate("a force above the device's peak");
  if (norm > 0.0 && s->told) violate("a force in a frame that began with an error");
  s->turns_at_limit = norm >= kAtLimitShare * peak ? s->turns_at_limit + 1 : 0;
  if (s->turns_at_limit > kLimitTurns && s->motors_on) {
    s->motors_on = false;
    ++s->switched_off;
    push(0x201, handle);
  }
  const bool gives = s->output && s->motors_on && s->plugged;
  const double share = norm > peak ? peak / norm : 1.0;
  for (int a = 0; a < 3; ++a) s->given[a] = gives ? share * s->asked[a] : 0.0;
}

unsigned int hdCheckCalibration() {
  const Lock lock(mutex);
  const State* s = of(current);
  return s == nullptr ? 0x5002 : s->calibration;
}
#endif

HDErrorInfo hdGetError() {
  const Lock lock(mutex);
  if (errors.empty()) return {0, 0, kInvalid};
  const HDErrorInfo newest = errors.back();
  errors.pop_back();
  return newest;
}

const char* hdGetErrorString(unsigned int code) { return code == 0x302 ? "communication error" : "an error"; }

void hdEnable(unsigned int capability) {
  const Lock lock(mutex);
  State* s = of(current);
  if (s == nullptr || capability != 0x4000) return;
  s->output = true;
  const bool cool = std::all_of(s->temperature, s->temperature + 3, [](double t) { return t < 1.0; });
  if (cool) s->motors_on = true;
  s->turns_at_limit = 0;
}

void hdDisable(unsigned int capability) {
  const Lock lock(mutex);
  State* s = of(current);
  if (s != nullptr && capability == 0x4000) {
    s->output = false;
    std::fill(s->given, s->given + 3, 0.0);
  }
}

void hdGetIntegerv(unsigned int what, int* values) {
  const Lock lock(mutex);
  State* s = of(current);
  if (s == nullptr) return;
  switch (what) {
    case 0x2000:
      if (!s->in_frame) push(0x402, current);
      values[0] = s->buttons;
      return;
    case 0x2553:
      values[0] = 6;
      return;
    case 0x2554:
      values[0] = 3;
      return;
    case 0x2555:
      values[0] = kind_of(s).styles;
      return;
    case 0x2600:
      values[0] = 1000;
      return;
    default:
      push(0x100, current);
  }
}

void hdGetDoublev(unsigned int what, double* values) {
  const Lock lock(mutex);
  State* s = of(current);
  if (s == nullptr) return;
  const double joints[3] = {0.1, 0.5, -0.3}, parked[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -110, -35, 1},
               none[3] = {0, 0, 0};
  if ((what == 0x2052 || what == 0x2100) && !s->in_frame) push(0x402, current);
  switch (what) {
    case 0x2052:
      return copy(s->held_elsewhere ? parked : s->transform, 16, values);
    case 0x2100:
      return copy(s->held_elsewhere ? none : joints, 3, values);
    case 0x2551:
      return copy(kind_of(s).box_mm, 6, values);
    case 0x2602:
      values[0] = kind_of(s).stiffness_n_mm;
      return;
    case 0x2603:
      values[0] = kind_of(s).peak_n;
      return;
    case 0x2604:
      values[0] = kind_of(s).continuous_n;
      return;
    case 0x2605:
      return copy(s->temperature, 3, values);
    default:
      push(0x100, current);
  }
}

void hdSetDoublev(unsigned int what, const double* values) {
  const Lock lock(mutex);
  State* s = of(current);
  if (s == nullptr) return;
  if (what != 0x2700) return push(0x100, current);
  if (!s->in_frame) {
    violate("a force outside a frame");
    return push(0x402, current);
  }
  copy(values, 3, s->asked);
}

const char* hdGetString(unsigned int what) {
  const Lock lock(mutex);
  const State* s = of(current);
  if (s == nullptr) return nullptr;
  if (what == 0x2501) return kind_of(s).model;
  if (what == 0x2504) return kind_of(s).serial;
  push(0x100, current);
  return nullptr;
}

void hdUpdateCalibration(unsigned int style) {
  const Lock lock(mutex);
  State* s = of(current);
  if (s == nullptr) return;
  if ((kind_of(s).styles & static_cast<int>(style)) == 0) return push(0x101, current);
  for (const double f : s->given) {
    if (f != 0.0) violate("calibrated while a force was shown");
  }
  if (s->calibration == 0x5001) s->calibration = 0x5000;
}

unsigned long hdScheduleAsynchronous(unsigned int (*call)(void*), void* data, unsigned short) {
  const Lock lock(mutex);
  if (!callbacks.empty()) violate("a second callback: two loops drive the devices");
  callbacks.push_back({next_callback, call, data});
  return next_callback++;
}

void hdUnschedule(unsigned long id) {
  const Lock lock(mutex);
  callbacks.erase(std::remove_if(callbacks.begin(), callbacks.end(), [&](const Scheduled& c) { return c.id == id; }),
                  callbacks.end());
}

void hdStartScheduler() {
  {
    const Lock lock(mutex);
    if (start_error != 0) return push(start_error, kInvalid);
  }
  if (running.exchange(true)) return;
  if (manual) return;
  servo = std::thread([] {
    auto next = std::chrono::steady_clock::now();
    while (running) {
      turn();
      next = std::max(next + std::chrono::milliseconds(1), std::chrono::steady_clock::now());
      std::this_thread::sleep_until(next);
    }
  });
}

void hdStopScheduler() {
  while (hangs) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  running = false;
  if (servo.joinable()) servo.join();
  const std::lock_guard<std::mutex> turning(loop);  // a turn made by hand ends first
  const Lock lock(mutex);
  for (const State& s : states) {
    for (const double f : s.given) {
      if (s.open && f != 0.0) violate("the loop stopped while a force was shown");
    }
  }
}

}  // extern "C"
