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

/// Whether the hand is still sensed while the fault holds.
bool senses(DeviceFault fault) noexcept {
  return fault != DeviceFault::communication_lost && fault != DeviceFault::unplugged &&
         fault != DeviceFault::not_calibrated && fault != DeviceFault::driver_error;
}

}  // namespace

ScriptedDevice::ScriptedDevice(Trajectory trajectory, const HandSettings& hand, std::vector<InjectedFault> faults)
    : trajectory_(std::move(trajectory)), hand_(hand), faults_(std::move(faults)) {
  require(hand.stiffness_n_m, 1.0, 1e5, "stiffness_n_m");
  require(hand.damping_n_s_m, 2.0, 1e5, "damping_n_s_m");
  require(hand.tremor_amplitude_m, 0.0, 0.01, "tremor_amplitude_m");
  require(hand.max_force_n, 0.1, 1000.0, "max_force_n");
  require(hand.device_limit_n, 0.1, 100.0, "device_limit_n");
  require(hand.limit_time_s, 0.0, 3600.0, "limit_time_s");
  require(hand.recovery_time_s, 0.0, 3600.0, "recovery_time_s");
  for (const InjectedFault& f : faults_) {
    require(f.from_s, 0.0, 1e6, "a fault's time");
    require(f.for_s, 0.0, 1e6, "a fault's duration");
  }
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

DeviceFault ScriptedDevice::injected(double time_s) const noexcept {
  for (const InjectedFault& f : faults_)
    if (time_s >= f.from_s && time_s < f.from_s + f.for_s) return f.fault;
  return DeviceFault::none;
}

int ScriptedDevice::faults_too_late() const noexcept {
  return static_cast<int>(std::count_if(faults_.begin(), faults_.end(),
                                        [this](const InjectedFault& f) { return f.from_s > trajectory_.end_s(); }));
}

void ScriptedDevice::give_way(double elapsed_s) noexcept {
  const double bent_n = hand_.stiffness_n_m * length(yield_);
  if (bent_n >= hand_.max_force_n && length(given_) > hand_.max_force_n) {
    // The hand holds with all it has, and the rest moves it: damping * dx/dt = force - max_force.
    const Vector held = scale(yield_, hand_.max_force_n / length(yield_));
    yield_ = add(yield_, scale(subtract(given_, held), elapsed_s / hand_.damping_n_s_m));
    return;
  }
  // damping * dx/dt + stiffness * x = force, integrated exactly over the tick for a constant force.
  const double share = 1.0 - std::exp(-elapsed_s * hand_.stiffness_n_m / hand_.damping_n_s_m);
  yield_ = add(yield_, scale(subtract(scale(given_, 1.0 / hand_.stiffness_n_m), yield_), share));
}

DeviceReading ScriptedDevice::read(double time_s) noexcept {
  const double elapsed_s = started_ ? std::max(0.0, time_s - now_s_) : 0.0;
  now_s_ = time_s;
  started_ = true;
  give_way(elapsed_s);

  const DeviceFault now = injected(time_s);
  if (now != DeviceFault::none) {
    if (fault() != now) enter_fault(now);
    injected_ = true;
  } else if (injected_ || (fault() != DeviceFault::none && now_s_ - fault_since_s_ >= hand_.recovery_time_s &&
                           commanded_n_ < kDemandGoneShare * hand_.device_limit_n)) {
    fault_.store(DeviceFault::none, std::memory_order_relaxed);
    injected_ = false;
  }
  last_.valid = fault() == DeviceFault::none;
  if (!senses(fault())) return last_;
  const Keyframe intended = trajectory_.at(time_s);
  last_.position_m = add(add(intended.position_m, tremor(time_s)), yield_);
  last_.rotation_wxyz = intended.rotation_wxyz;
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
