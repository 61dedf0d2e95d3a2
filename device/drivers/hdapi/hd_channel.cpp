#include "device/drivers/hdapi/hd_channel.h"

#include <algorithm>
#include <chrono>

namespace vallecula::device::hdapi {
namespace {

constexpr int kSlowTurns = 50;  // calibration and temperature change slowly
constexpr int kMostMotors = 8;

std::int64_t clock_ns() noexcept {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Of several errors the one that a person must know first.
int severity(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::none:
      return 0;
    case DeviceFault::not_calibrated:
      return 1;
    case DeviceFault::driver_error:
    case DeviceFault::frozen:
      return 2;
    case DeviceFault::servo_late:
      return 3;
    case DeviceFault::non_finite_command:
      return 4;
    case DeviceFault::force_exceeded:
      return 5;
    case DeviceFault::motor_warm:
      return 6;
    case DeviceFault::communication_lost:
      return 7;
    case DeviceFault::unplugged:
      return 8;
  }
  return 2;
}

}  // namespace

void Channel::command(const Vector& force_n) noexcept {
  if (!finite(force_n)) bad_command_.store(true, std::memory_order_relaxed);
  commands_.publish({finite(force_n) ? force_n : Vector{0, 0, 0}, ++commands_given_});
}

DeviceFault Channel::fault() const noexcept {
  const DeviceFault held = fault_.load(std::memory_order_relaxed);
  const DeviceFault still = fault_of_standing(1e-9 * (clock_ns() - turned_ns_.load(std::memory_order_relaxed)));
  return severity(still) > severity(held) ? still : held;
}

void Channel::attach(Handle handle, const Properties& properties) noexcept {
  handle_ = handle;
  middle_mm_ = properties.middle_mm;
  peak_n_ = properties.info.peak_force_n;
  period_s_ = 1.0 / properties.info.rate_hz;
  styles_ = properties.calibration_styles;
  motors_ = std::clamp(properties.motors, 1, kMostMotors);
  turns_ = on_since_ = 0;
  answers_ = false;
  shown_ = {0, 0, 0};
  noted_ = DeviceFault::none;
  turned_ns_.store(clock_ns(), std::memory_order_relaxed);
  calibration_.store(Calibration::needs_update, std::memory_order_relaxed);
}

void Channel::detach() noexcept {
  handle_ = kNoDevice;
  fault_.store(DeviceFault::unplugged, std::memory_order_relaxed);
}

bool Channel::lost() const noexcept {
  const DeviceFault held = fault_.load(std::memory_order_relaxed);
  return held == DeviceFault::communication_lost || held == DeviceFault::unplugged;
}

void Channel::begin(const Functions& hd, double now_s) noexcept {
  elapsed_s_ += turns_ == 0 ? period_s_ : std::max(period_s_, now_s - last_s_);
  last_s_ = now_s;
  hd.make_current(handle_);
  hd.begin_frame(handle_);
}

void Channel::note(DeviceFault fault) noexcept {
  if (severity(fault) > severity(noted_)) noted_ = fault;
}

void Channel::look_slowly(const Functions& hd) noexcept {
  double temperatures[kMostMotors];
  std::fill_n(temperatures, kMostMotors, -1.0);
  hd.get_doubles(kMotorTemperature, temperatures);
  const double warmth = warmth_of(temperatures, motors_);
  warmth_.store(warmth, std::memory_order_relaxed);
  if (warmth >= 1.0) note(DeviceFault::motor_warm);

  unsigned int status = hd.check_calibration();
  const unsigned int style = styles_ & kStyleAutomatic ? kStyleAutomatic : styles_ & kStyleInkWell;
  // An update moves the origin under the hand: only when no force is shown, so at the next look if one is now.
  if (status == kNeedsUpdate && style != 0 && fault_.load(std::memory_order_relaxed) != DeviceFault::none) {
    hd.update_calibration(style);
    status = hd.check_calibration();
  }
  const Calibration calibration = calibration_of(status);
  calibration_.store(calibration, std::memory_order_relaxed);
  if (calibration != Calibration::good) note(DeviceFault::not_calibrated);
}

void Channel::exchange(const Functions& hd, bool may_show) noexcept {
  double transform[16] = {};
  hd.get_doubles(kTransform, transform);
  int buttons = 0;
  hd.get_integers(kButtons, &buttons);
  if (const auto pose = pose_of(transform, middle_mm_)) {
    now_.pose = *pose;
  } else {
    note(DeviceFault::driver_error);
  }
  now_.buttons = static_cast<std::uint32_t>(buttons);
  if (!answers_) {
    // A device that another program holds opens, but its joints read exactly zero for ever (check): a live arm never
    // does once a hand has touched it.
    double joints[3] = {};
    hd.get_doubles(kJointAngles, joints);
    answers_ = joints[0] != 0.0 || joints[1] != 0.0 || joints[2] != 0.0;
    if (!answers_) note(DeviceFault::communication_lost);
  }
  if (turns_ % kSlowTurns == 0) look_slowly(hd);
  shown_ = force_to_show(may_show);
  hd.set_doubles(kForce, shown_.data());
  hd.end_frame(handle_);
  ++turns_;
}

Vector Channel::force_to_show(bool may_show) noexcept {
  const Command& command = commands_.newest();
  if (command.number != newest_command_.number) {
    newest_command_ = command;
    commanded_s_ = elapsed_s_;
  }
  if (bad_command_.exchange(false, std::memory_order_relaxed)) note(DeviceFault::non_finite_command);
  const bool stops = newest_command_.force_n == Vector{0, 0, 0};
  // Whoever leaves off with a zero is done; whoever leaves off in mid force is late.
  if (elapsed_s_ - commanded_s_ > kWatchdogS && !stops) note(DeviceFault::servo_late);
  if (!may_show || silent() || noted_ != DeviceFault::none ||
      fault_.load(std::memory_order_relaxed) != DeviceFault::none) {
    on_since_ = turns_;
    return {0, 0, 0};
  }
  if (stops) return {0, 0, 0};  // not bounded in rate: so the output chain stops the force
  // By turns, not by the clock: a loop that stood still for a while makes no jump.
  const double share = std::min(1.0, static_cast<double>(turns_ - on_since_) * period_s_ / kRampS);
  const Vector wanted = scale(shortened_or_zero(newest_command_.force_n, peak_n_), share);
  const Vector change = subtract(wanted, shown_), step = shortened(change, kMostRateNS * period_s_);
  return step == change ? wanted : shortened(add(shown_, step), peak_n_);
}

bool Channel::over(DeviceFault fault) const noexcept {
  if (fault == DeviceFault::not_calibrated) return calibration() == Calibration::good;
  return elapsed_s_ - error_s_ >= kQuietS &&
         length(shortened_or_zero(newest_command_.force_n, peak_n_)) <= kEasedShare * peak_n_ &&
         (fault != DeviceFault::motor_warm || warmth() < kCoolWarmth);
}

void Channel::settle(const Functions& hd) noexcept {
  // With the first turn after attach() what was held before is over.
  const DeviceFault held = turns_ == 1 ? DeviceFault::not_calibrated : fault_.load(std::memory_order_relaxed);
  DeviceFault now = held;
  if (noted_ != DeviceFault::none) {
    error_s_ = elapsed_s_;
    if (held == DeviceFault::none) hd.disable(kForceOutput);
    if (severity(noted_) > severity(held)) now = noted_;
    noted_ = DeviceFault::none;
  } else if (held != DeviceFault::none && over(held)) {
    hd.enable(kForceOutput);
    now = DeviceFault::none;
  }
  fault_.store(now, std::memory_order_relaxed);
  state_.publish(now_);
  turned_ns_.store(clock_ns(), std::memory_order_relaxed);
}

}  // namespace vallecula::device::hdapi
