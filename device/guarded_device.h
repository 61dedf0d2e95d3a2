// One device in a hand, made safe: mapped to the patient, its force through the one output chain, paused at any fault
// until the device is back and the hand confirms.
#pragma once

#include <atomic>

#include "device/output_chain.h"
#include "device/workspace_map.h"

namespace vallecula::device {

struct GuardSettings {
  OutputLimits limits;
  MapSettings map;                  ///< of a device with own axes; any other is not mapped
  std::uint32_t clutch_button = 2;  ///< bit of the button (after the map) that frees the hand; own axes only; 0: none
};

/// What the device itself asks for: its forces as limits, and of a device with own axes the force scaled down where its
/// peak is below kFullForceN, so that the whole range of a laryngoscopy can be felt on a weak one, and to
/// most_force_scale().
GuardSettings guard_for(const DeviceInfo& info, const MapSettings& map = {});
constexpr double kFullForceN = 7.9;  ///< the Touch X's, with which the method was published

/// The largest force scale with which the stiffest contact does not buzz on this device; at most 1. The hand feels the
/// model's stiffness times the force scale times the square of the motion scale: the map scales the way and the force.
double most_force_scale(const DeviceInfo& info, const MapSettings& map);
constexpr double kStiffestModelNM = 1200.0;  ///< the engine's coupling of the hand to the tool: no contact is stiffer

/// The largest force on the tool (N, in the patient) that the device can show under these settings; 0: shows none.
double largest_model_force_n(const GuardSettings& settings);

enum class GuardState : std::uint8_t {
  working,
  clutched,   ///< the hand is free: the tool stands still
  paused,     ///< a fault holds; zero force
  confirming  ///< the device is back; zero force until the hand confirms
};

/// A hand confirms with any button of the device, by confirm(), or by holding the ghost this near to the frozen tool
/// for this long.
constexpr double kConfirmWithinM = 0.005, kConfirmHoldS = 0.5;

/// The device must outlive it. While paused or confirming, readings are not valid: whoever takes them keeps the tool
/// where it is. In the very tick in which a fault is found the force is zero.
class GuardedDevice {
 public:
  /// Throws std::invalid_argument when a setting is out of its range.
  GuardedDevice(HapticDevice& device, const GuardSettings& settings);

  // --- before the first tick
  // ------------------------------------------------------------------------------------------
  /// Where the tool of a device with own axes begins, m and w first, and the operator's view in the patient.
  void begin_at(const std::array<double, 3>& position_m, const std::array<double, 4>& rotation_wxyz) noexcept;
  void set_view_axes(const std::array<double, 3>& right, const std::array<double, 3>& up) noexcept;
  /// Another attempt with the same device: as made, but that its motors are as warm as they are.
  void begin_anew() noexcept;

  // --- the servo's thread; wait-free
  // -----------------------------------------------------------------------------------
  /// The tool where the hand wants it, in the patient's axes. A pose that is no pose comes through once, as it is, for
  /// whoever records it; it pauses the device as driver_error.
  /// `waited_s`: of that time, how long what plays back has been kept waiting.
  DeviceReading read(double time_s, double waited_s = 0.0) noexcept;
  /// Somebody holds it, or has and the hand has not confirmed since: what plays back waits.
  bool waits() const noexcept { return frozen() || (quiet() && fault() == DeviceFault::frozen); }
  /// Where the scene holds the tool (the proxy); between read and write, when there is one.
  void see_tool(const std::array<double, 3>& position_m, const std::array<double, 4>& rotation_wxyz) noexcept;
  /// Force on the hand in the patient's axes, N; once after every read. Returns what was sent, in the device's axes.
  std::array<double, 3> write(const std::array<double, 3>& force_n) noexcept;
  /// Zero force, from whichever thread is the last: nobody drives the device any more.
  void let_go() noexcept;

  // --- any thread ----------------------------------------------------------------------------------------------------
  GuardState state() const noexcept { return state_.load(std::memory_order_relaxed); }
  /// Of the pause that holds, or of the last one; none: there was none.
  DeviceFault fault() const noexcept { return fault_.load(std::memory_order_relaxed); }
  /// The hand confirms by a key; no effect while the device is not back.
  void confirm() noexcept { confirmations_.fetch_add(1, std::memory_order_relaxed); }
  /// Somebody holds the trial: paused as by a fault of that name until it is let go; the hand then confirms.
  void freeze(bool on) noexcept { frozen_.store(on, std::memory_order_relaxed); }
  bool frozen() const noexcept { return frozen_.load(std::memory_order_relaxed); }

 private:
  struct Place {
    std::array<double, 3> position_m{0, 0, 0};
    std::array<double, 4> rotation_wxyz{1, 0, 0, 0};
  };
  DeviceFault trouble(const DeviceReading& reading, bool has_pose) const noexcept;
  bool quiet() const noexcept { return state() == GuardState::paused || state() == GuardState::confirming; }
  void pause(DeviceFault fault) noexcept;
  void work_on(const DeviceReading& reading, const Place& place) noexcept;
  void clutch(const DeviceReading& reading, const DeviceReading& tool) noexcept;
  bool confirmed(const DeviceReading& tool, double elapsed_s) noexcept;

  HapticDevice& device_;
  const bool own_axes_;
  const std::uint32_t clutch_button_;
  WorkspaceMap map_;
  OutputChain chain_;

  bool centred_ = false;    ///< the first good reading has been put at the start
  bool held_only_ = false;  ///< the pause began by somebody's holding it, and no device has been away since
  bool seen_tool_ = false;  ///< the scene has told where it holds the tool
  Place start_;
  Place tool_;          ///< in the scene; without one, of the last reading before the pause
  DeviceReading last_;  ///< what was last given out with a usable pose
  double now_s_ = 0.0, near_s_ = 0.0;
  std::uint32_t buttons_ = 0;    ///< of the last tick
  std::uint32_t confirmed_ = 0;  ///< confirmations_ when the device came back
  std::atomic<std::uint32_t> confirmations_{0};
  std::atomic<bool> frozen_{false};
  std::atomic<GuardState> state_{GuardState::working};
  std::atomic<DeviceFault> fault_{DeviceFault::none};
};

}  // namespace vallecula::device
