// What a test says to the stand-in libHD.so and asks of it, through the symbols that it exports beside HDAPI's.
#pragma once

#include <dlfcn.h>

#include <array>
#include <stdexcept>
#include <string>

namespace vallecula::device::testing {

/// Device 0 is "Default PHANToM" (a Touch X: 7.9 N, workspace centre 0, 15, -5 mm), device 1 "Right Device" (a Touch:
/// 3.3 N, calibrated in its ink well). Whatever breaks HDAPI's rules counts as a violation: a device opened or closed
/// while the loop turns, the loop stopped under force, a second callback, a force outside a frame, above the peak or
/// not a number, a calibration under force.
class StandIn {
 public:
  explicit StandIn(const std::string& file) : library_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (library_ == nullptr) throw std::runtime_error(dlerror());
    call<void()>("reset")();
  }
  /// Turns of the servo loop are made by turn() instead of by a thread; before the first device is opened.
  void by_hand() const { call<void(int)>("manual")(1); }
  int turn(int turns) const { return call<int(int)>("turn")(turns); }
  /// Stopping the loop does not return until this is taken back.
  void hang(bool on) const { call<void(int)>("hang")(on); }
  void transform(int device, const std::array<double, 16>& m) const {
    call<void(int, const double*)>("transform")(device, m.data());
  }
  void position_mm(int device, double x, double y, double z) const {
    transform(device, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1});
  }
  void buttons(int device, int buttons) const { call<void(int, int)>("buttons")(device, buttons); }
  void temperature(int device, int motor, double t) const {
    call<void(int, int, double)>("temperature")(device, motor, t);
  }
  void calibration(int device, unsigned int status) const {
    call<void(int, unsigned int)>("calibration")(device, status);
  }
  void plugged(int device, bool on) const { call<void(int, int)>("plugged")(device, on); }
  void held_elsewhere(int device, bool on) const { call<void(int, int)>("held_elsewhere")(device, on); }
  /// Opening fails with this error (0: no more).
  void init_error(int device, unsigned int code) const { call<void(int, unsigned int)>("init_error")(device, code); }
  /// The servo loop does not start, with this error (0: it does).
  void start_error(unsigned int code) const { call<void(unsigned int)>("start_error")(code); }
  /// Every frame raises this error (0: no more).
  void frame_error(int device, unsigned int code) const { call<void(int, unsigned int)>("frame_error")(device, code); }
  /// One error, once; device -1: of no device.
  void error(int device, unsigned int code) const { call<void(int, unsigned int)>("error")(device, code); }
  /// What the motors give now, N.
  std::array<double, 3> given(int device) const {
    std::array<double, 3> force{};
    call<void(int, double*)>("given")(device, force.data());
    return force;
  }
  bool open(int device) const { return call<int(int)>("open")(device) != 0; }
  bool output(int device) const { return call<int(int)>("output")(device) != 0; }
  /// How often the device gave up at its peak force.
  int switched_off(int device) const { return call<int(int)>("switched_off")(device); }
  long frames(int device) const { return call<long(int)>("frames")(device); }
  bool running() const { return call<int()>("running")() != 0; }
  int callbacks() const { return call<int()>("callbacks")(); }
  /// Empty: none.
  std::string violations() const {
    const char* last = "";
    const int count = call<int(const char**)>("violations")(&last);
    return count == 0 ? "" : std::to_string(count) + ", the last: " + last;
  }

 private:
  template <class Signature>
  Signature* call(const char* name) const {
    auto* function = reinterpret_cast<Signature*>(dlsym(library_, (std::string("vallecula_standin_") + name).c_str()));
    if (function == nullptr) throw std::runtime_error(dlerror());
    return function;
  }
  void* library_;
};

}  // namespace vallecula::device::testing
