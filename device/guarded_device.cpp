#include "device/guarded_device.h"

#include <algorithm>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

/// A pause of the clock (a stopped debugger) is no holding still.
constexpr double kLongestTickS = 0.05;

bool is_pose(const DeviceReading& reading) noexcept {
  const double norm2 = dot(reading.rotation_wxyz, reading.rotation_wxyz);
  return finite(reading.position_m) && norm2 > 0.25 && norm2 < 4.0;
}

}  // namespace

GuardSettings guard_for(const DeviceInfo& info, const MapSettings& map) {
  GuardSettings settings;
  settings.map = map;
  settings.limits.peak_force_n = info.peak_force_n;
  settings.limits.continuous_force_n = info.continuous_force_n;
  if (info.own_axes && info.peak_force_n > 0.0)
    settings.limits.force_scale =
        std::min(most_force_scale(info, map), info.peak_force_n / (kFullForceN * map.motion_scale));
  return settings;
}

double most_force_scale(const DeviceInfo& info, const MapSettings& map) {
  if (!(info.max_stiffness_n_m > 0.0)) return 1.0;
  return std::min(1.0, info.max_stiffness_n_m / (kStiffestModelNM * map.motion_scale * map.motion_scale));
}

double largest_model_force_n(const GuardSettings& settings) {
  return settings.limits.peak_force_n / (settings.limits.force_scale * settings.map.motion_scale);
}

GuardedDevice::GuardedDevice(HapticDevice& device, const GuardSettings& settings)
    : device_(device),
      own_axes_(device.info().own_axes),
      clutch_button_(own_axes_ ? settings.clutch_button : 0),
      map_(settings.map),
      chain_(settings.limits) {}

void GuardedDevice::begin_at(const std::array<double, 3>& position_m,
                             const std::array<double, 4>& rotation_wxyz) noexcept {
  start_ = {position_m, rotation_wxyz};
  last_.position_m = position_m;
  last_.rotation_wxyz = rotation_wxyz;
}

void GuardedDevice::set_view_axes(const std::array<double, 3>& right, const std::array<double, 3>& up) noexcept {
  map_.set_view_axes(right, up);
}

void GuardedDevice::begin_anew() noexcept {
  chain_.reset();
  centred_ = seen_tool_ = false;
  begin_at(start_.position_m, start_.rotation_wxyz);
  now_s_ = 0.0;
  freeze(false);
  fault_.store(DeviceFault::none, std::memory_order_relaxed);
  state_.store(GuardState::working, std::memory_order_relaxed);
}

DeviceFault GuardedDevice::trouble(const DeviceReading& reading, bool has_pose) const noexcept {
  const DeviceFault fault = device_.fault();  // asked once: a driver's thread may end it meanwhile
  if (fault != DeviceFault::none) return fault;
  const Calibration calibration = device_.calibration();
  if (calibration != Calibration::good && calibration != Calibration::not_needed) return DeviceFault::not_calibrated;
  if (!reading.valid || !has_pose) return DeviceFault::driver_error;
  return frozen() ? DeviceFault::frozen : DeviceFault::none;
}

void GuardedDevice::pause(DeviceFault fault) noexcept {
  if (!quiet() && !seen_tool_) tool_ = {last_.position_m, last_.rotation_wxyz};
  held_only_ = fault == DeviceFault::frozen && (!quiet() || held_only_);
  fault_.store(fault, std::memory_order_relaxed);
  state_.store(GuardState::paused, std::memory_order_relaxed);
}

void GuardedDevice::work_on(const DeviceReading& reading, const Place& place) noexcept {
  if (own_axes_) map_.centre(reading, place.position_m, place.rotation_wxyz);
  centred_ = true;
  state_.store(GuardState::working, std::memory_order_relaxed);
}

void GuardedDevice::clutch(const DeviceReading& reading, const DeviceReading& tool) noexcept {
  const bool held = (tool.buttons & clutch_button_) != 0;
  if (held && state() == GuardState::working) {
    state_.store(GuardState::clutched, std::memory_order_relaxed);
    chain_.soften();
  } else if (!held && state() == GuardState::clutched) {
    work_on(reading, {last_.position_m, last_.rotation_wxyz});
  }
}

bool GuardedDevice::confirmed(const DeviceReading& tool, double elapsed_s) noexcept {
  near_s_ = length(subtract(tool.position_m, tool_.position_m)) <= kConfirmWithinM ? near_s_ + elapsed_s : 0.0;
  const bool was_kept_waiting = device_.plays_back() && held_only_;
  return device_.confirms_itself() || was_kept_waiting || (tool.buttons & ~buttons_) != 0 || near_s_ >= kConfirmHoldS ||
         confirmations_.load(std::memory_order_relaxed) != confirmed_;
}

DeviceReading GuardedDevice::read(double time_s, double waited_s) noexcept {
  const DeviceReading reading = device_.read(device_.plays_back() ? time_s - waited_s : time_s);
  const double elapsed_s = std::clamp(time_s - now_s_, 0.0, kLongestTickS);
  now_s_ = time_s;
  const bool has_pose = is_pose(reading);
  const DeviceFault fault = trouble(reading, has_pose);
  if (!centred_ && fault == DeviceFault::none && !quiet()) work_on(reading, start_);

  DeviceReading tool = own_axes_ ? map_.to_patient(reading) : reading;
  if (!has_pose || (own_axes_ && !centred_)) {
    tool.position_m = last_.position_m;
    tool.rotation_wxyz = last_.rotation_wxyz;
  }
  if (fault != DeviceFault::none) {
    // A pose that is none is passed on in its first tick only, so that it is on record.
    const bool passes = !quiet() && reading.valid && !has_pose && fault == DeviceFault::driver_error;
    pause(fault);
    if (passes) return reading;
  } else if (state() == GuardState::paused) {
    state_.store(GuardState::confirming, std::memory_order_relaxed);
    confirmed_ = confirmations_.load(std::memory_order_relaxed);
    buttons_ = tool.buttons;
    near_s_ = 0.0;
  }
  if (state() == GuardState::confirming && confirmed(tool, elapsed_s)) {
    work_on(reading, tool_);
    if (own_axes_) tool = last_ = map_.to_patient(reading);  // the clutch may be what confirmed: it holds the tool here
    chain_.reset();
  }
  buttons_ = tool.buttons;
  if (own_axes_ && !quiet()) {
    clutch(reading, tool);
    tool = map_.to_patient(reading);
    if (state() == GuardState::clutched) {
      tool.position_m = last_.position_m;
      tool.rotation_wxyz = last_.rotation_wxyz;
    }
  }
  tool.valid = !quiet();
  last_ = tool;
  return tool;
}

void GuardedDevice::see_tool(const std::array<double, 3>& position_m,
                             const std::array<double, 4>& rotation_wxyz) noexcept {
  tool_ = {position_m, rotation_wxyz};
  seen_tool_ = true;
}

std::array<double, 3> GuardedDevice::write(const std::array<double, 3>& force_n) noexcept {
  const DeviceFault fault = device_.fault();  // it may have come since the reading
  if (fault != DeviceFault::none) pause(fault);
  if (quiet()) {
    chain_.stop(device_);
    return chain_.last_sent_n();
  }
  const Vector wanted = own_axes_ ? map_.force_to_device(force_n) : force_n;
  // Multiplied, not replaced: what is not a number is caught with the clutch held too.
  const Vector sent = chain_.send(device_, scale(wanted, state() == GuardState::clutched ? 0.0 : 1.0));
  if (chain_.fault() != DeviceFault::none) {
    pause(chain_.fault());
    chain_.reset();
  }
  return sent;
}

void GuardedDevice::let_go() noexcept {
  chain_.reset();
  device_.write({0, 0, 0});
}

}  // namespace vallecula::device
