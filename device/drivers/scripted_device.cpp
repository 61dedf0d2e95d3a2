#include "device/drivers/scripted_device.h"

#include <algorithm>
#include <random>
#include <string>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

constexpr double kTremorLowHz = 8.0, kTremorHighHz = 12.0;  // physiological hand tremor

void require(double value, double low, double high, const char* name) {
  if (!(value >= low && value <= high)) {
    throw DeviceError(std::string("scripted device: ") + name + " = " + std::to_string(value) + "; expected " +
                      std::to_string(low) + " to " + std::to_string(high));
  }
}

/// 53 bits of the generator, 0 <= u < 1. The standard's distributions differ between libraries, the generator does not.
double uniform(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11) * 0x1.0p-53; }

}  // namespace

ScriptedDevice::ScriptedDevice(Trajectory trajectory, const HandSettings& hand)
    : trajectory_(std::move(trajectory)), hand_(hand) {
  require(hand.stiffness_n_m, 1.0, 1e5, "stiffness_n_m");
  require(hand.damping_n_s_m, 2.0, 1e5, "damping_n_s_m");
  require(hand.tremor_amplitude_m, 0.0, 0.01, "tremor_amplitude_m");
  require(hand.device_limit_n, 0.1, 100.0, "device_limit_n");
  require(hand.limit_time_s, 0.0, 3600.0, "limit_time_s");
  require(hand.recovery_time_s, 0.0, 3600.0, "recovery_time_s");
  std::mt19937_64 generator(hand.tremor_seed);
  for (auto& axis : waves_) {
    for (Wave& wave : axis) {
      wave.omega_rad_s = 2.0 * M_PI * (kTremorLowHz + (kTremorHighHz - kTremorLowHz) * uniform(generator));
      wave.phase_rad = 2.0 * M_PI * uniform(generator);
    }
  }
  const Keyframe first = trajectory_.at(trajectory_.start_s());
  last_.position_m = first.position_m;
  last_.rotation_wxyz = first.rotation_wxyz;
}

DeviceInfo ScriptedDevice::info() const {
  DeviceInfo info;
  info.kind = "scripted";
  info.model = "scripted hand";
  info.peak_force_n = hand_.device_limit_n;
  info.actuated_dof = 3;
  return info;
}

std::array<double, 3> ScriptedDevice::tremor(double time_s) const noexcept {
  Vector offset{0, 0, 0};
  if (hand_.tremor_amplitude_m == 0.0) return offset;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Wave& wave : waves_[axis]) offset[axis] += std::sin(wave.omega_rad_s * time_s + wave.phase_rad);
  }
  return scale(offset, hand_.tremor_amplitude_m / kTremorWaves);
}

void ScriptedDevice::enter_fault(DeviceFault fault) noexcept {
  if (fault_.exchange(fault, std::memory_order_relaxed) == DeviceFault::none) {
    fault_count_.fetch_add(1, std::memory_order_relaxed);
  }
  fault_since_s_ = now_s_;
  at_limit_since_s_ = -1.0;
  given_ = {0, 0, 0};
}

DeviceReading ScriptedDevice::read(double time_s) noexcept {
  const double elapsed_s = started_ ? std::max(0.0, time_s - now_s_) : 0.0;
  now_s_ = time_s;
  started_ = true;

  // damping * dx/dt + stiffness * x = force, integrated exactly over the tick for a constant force.
  const double share = 1.0 - std::exp(-elapsed_s * hand_.stiffness_n_m / hand_.damping_n_s_m);
  yield_ = add(yield_, scale(subtract(scale(given_, 1.0 / hand_.stiffness_n_m), yield_), share));

  if (fault() != DeviceFault::none && now_s_ - fault_since_s_ >= hand_.recovery_time_s &&
      commanded_n_ < kDemandGoneShare * hand_.device_limit_n) {
    fault_.store(DeviceFault::none, std::memory_order_relaxed);
  }
  if (fault() != DeviceFault::none) {
    last_.valid = false;
    return last_;
  }
  const Keyframe intended = trajectory_.at(time_s);
  last_.position_m = add(add(intended.position_m, tremor(time_s)), yield_);
  last_.rotation_wxyz = intended.rotation_wxyz;
  last_.valid = true;
  return last_;
}

void ScriptedDevice::write(const std::array<double, 3>& force_n) noexcept {
  const double magnitude = length(force_n);
  if (!std::isfinite(magnitude)) {
    commanded_n_ = 0.0;
    enter_fault(DeviceFault::non_finite_command);
    return;
  }
  commanded_n_ = magnitude;
  if (fault() != DeviceFault::none) return;  // the motors are off

  given_ = magnitude > hand_.device_limit_n ? scale(force_n, hand_.device_limit_n / magnitude) : force_n;
  if (magnitude < kAtLimitShare * hand_.device_limit_n) {
    at_limit_since_s_ = -1.0;
  } else if (at_limit_since_s_ < 0.0) {
    at_limit_since_s_ = now_s_;
  } else if (now_s_ - at_limit_since_s_ > hand_.limit_time_s) {
    enter_fault(DeviceFault::force_exceeded);
  }
}

}  // namespace vallecula::device
