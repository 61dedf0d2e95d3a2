// A hand without a person: follows a trajectory, yields to the force it feels, trembles a little, and stands on a
// device with a force limit of its own.
#pragma once

#include <atomic>
#include <filesystem>
#include <iosfwd>
#include <vector>

#include "device/trajectory.h"

namespace vallecula::device {

struct HandSettings {
  double stiffness_n_m = 400.0;  ///< how firmly the hand holds its intended pose: a seated arm has 200-1000 (assumed)
  double damping_n_s_m = 8.0;    ///< the yielding lags by damping/stiffness; at least 2, or a stiff scene would chatter
  double tremor_amplitude_m = 0.0;  ///< bound of the physiological tremor (8-12 Hz) along each axis
  unsigned tremor_seed = 1;         ///< same seed, same tremor, on every machine
  double max_force_n = 50.0;        ///< what the hand can hold: pushed harder it gives way (assumed: an arm's)
  double device_limit_n = 7.9;      ///< what the device can give: larger commands are clamped
  double limit_time_s = 0.5;        ///< commanded at the limit for longer than this: fault force_exceeded
  double recovery_time_s = 1.0;     ///< after a fault the device stays unusable at least this long
};

/// The hand of every scripted device the application makes. A script cannot look and correct itself as a person does,
/// so it is firmer than an arm: 1 N moves it by a third of a millimetre (assumed).
inline HandSettings firm_hand() {
  HandSettings hand;
  hand.stiffness_n_m = 3000.0;
  return hand;
}

/// A fault that comes and goes by the script.
struct InjectedFault {
  DeviceFault fault = DeviceFault::none;
  double from_s = 0.0, for_s = 0.0;
};

/// A command of at least this share of the limit counts as "at the limit".
constexpr double kAtLimitShare = 0.99;
/// After a fault the device comes back only once the commanded force is below this share of the limit.
constexpr double kDemandGoneShare = 0.5;

/// What a file says of a scripted hand: rows as read_trajectory_csv() takes them and, among the lines that start with
/// #,
///   # fault KIND FROM_S FOR_S     KIND as name_of() has it: force_exceeded, unplugged, ...
///   # hand NAME VALUE             NAME a field of HandSettings: stiffness_n_m, max_force_n, tremor_seed, ...
/// Other remarks are skipped.
struct HandScript {
  std::vector<Keyframe> keyframes;
  HandSettings hand = firm_hand();
  std::vector<InjectedFault> faults;
};
/// Throws DeviceError naming file and line.
HandScript read_hand_script(const std::filesystem::path& file);
/// The same from text that is named so in errors.
HandScript read_hand_script(std::istream& text, const std::string& name);

class ScriptedDevice final : public HapticDevice {
 public:
  /// Throws DeviceError when a setting is not finite or out of its range.
  ScriptedDevice(Trajectory trajectory, const HandSettings& hand, std::vector<InjectedFault> faults = {});

  DeviceInfo info() const override;
  /// Intended pose + tremor + what the hand yielded; while a fault holds it is not valid, and the last one where the
  /// fault is one of the senses (lost, unplugged, not calibrated, driver error).
  DeviceReading read(double time_s) noexcept override;
  void write(const std::array<double, 3>& force_n) noexcept override;
  DeviceFault fault() const noexcept override { return fault_.load(std::memory_order_relaxed); }
  Calibration calibration() const noexcept override {
    return fault() == DeviceFault::not_calibrated ? Calibration::needs_hand : Calibration::not_needed;
  }
  bool plays_back() const noexcept override { return true; }
  bool finished(double time_s) const noexcept override { return time_s > trajectory_.end_s(); }

  /// How often a fault began.
  int fault_count() const noexcept { return fault_count_.load(std::memory_order_relaxed); }
  /// Force the motors give now, N; zero while a fault holds.
  const std::array<double, 3>& given_force_n() const noexcept { return given_; }
  const Trajectory& trajectory() const noexcept { return trajectory_; }
  /// The script's faults that begin after its last keyframe: a trial ends there, so they never come.
  int faults_too_late() const noexcept;

 private:
  static constexpr int kTremorWaves = 6;  ///< sines per axis: enough not to look periodic within a trial
  struct Wave {
    double omega_rad_s, phase_rad;
  };
  std::array<double, 3> tremor(double time_s) const noexcept;
  void enter_fault(DeviceFault fault) noexcept;
  DeviceFault injected(double time_s) const noexcept;
  void give_way(double elapsed_s) noexcept;

  Trajectory trajectory_;
  HandSettings hand_;
  std::vector<InjectedFault> faults_;
  std::array<std::array<Wave, kTremorWaves>, 3> waves_{};
  std::array<double, 3> yield_{0, 0, 0};  ///< displacement of the hand by the force, m
  std::array<double, 3> given_{0, 0, 0};
  double commanded_n_ = 0.0;
  double now_s_ = 0.0;
  bool started_ = false;
  double at_limit_since_s_ = -1.0;  ///< negative: not at the limit
  double fault_since_s_ = 0.0;
  bool injected_ = false;  ///< the fault that holds is the script's: it goes by the script
  DeviceReading last_;
  std::atomic<DeviceFault> fault_{DeviceFault::none};
  std::atomic<int> fault_count_{0};
};

}  // namespace vallecula::device
