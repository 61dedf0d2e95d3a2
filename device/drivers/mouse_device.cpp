#include "device/drivers/mouse_device.h"

#include <algorithm>
#include <string>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

/// A pause (a blocked thread, a stopped debugger) is caught up as if it had lasted no longer than this.
constexpr double kLongestStep = 0.05;

void require_positive(double value, const char* name) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw DeviceError(std::string("mouse device: ") + name + " = " + std::to_string(value) +
                      "; expected a positive number");
  }
}

}  // namespace

MouseDevice::MouseDevice(const MouseSettings& settings) : settings_(settings), handed_(Target{}) {
  require_positive(settings.max_speed_m_s, "max_speed_m_s");
  require_positive(settings.max_turn_rad_s, "max_turn_rad_s");
  require_positive(settings.smoothing_s, "smoothing_s");
  require_positive(settings.lift_speed_m_s, "lift_speed_m_s");
  require_positive(settings.lift_range_m, "lift_range_m");
  require_positive(settings.lift_levels_rad_m, "lift_levels_rad_m");
  require_positive(settings.lift_force_share, "lift_force_share");
  require_positive(settings.feel_age_s, "feel_age_s");
  require_positive(settings.workspace_m, "workspace_m");
}

DeviceInfo MouseDevice::info() const {
  DeviceInfo info;
  info.kind = "mouse";
  info.model = "mouse and keyboard";
  return info;
}

void MouseDevice::place(const std::array<double, 3>& position_m, const std::array<double, 4>& rotation_wxyz) noexcept {
  if (!finite(position_m) || !std::isfinite(dot(rotation_wxyz, rotation_wxyz))) return;
  target_.position_m = centre_ = position_m;
  target_.rotation_wxyz = normalised(rotation_wxyz);
  target_.lift_direction = 0.0;
  target_.lift_share = 1.0;
  ++target_.placement;
  handed_.publish(target_);
}

void MouseDevice::set_view_axes(const std::array<double, 3>& right, const std::array<double, 3>& up,
                                const std::array<double, 3>& forward) noexcept {
  right_ = right;
  up_ = up;
  forward_ = forward;
}

void MouseDevice::shift(const std::array<double, 3>& direction, double distance_m) noexcept {
  const Vector moved = add(target_.position_m, scale(direction, distance_m));
  if (!finite(moved)) return;
  const Vector from_centre = subtract(moved, centre_);
  const double distance = length(from_centre);
  target_.position_m =
      distance > settings_.workspace_m ? add(centre_, scale(from_centre, settings_.workspace_m / distance)) : moved;
}

void MouseDevice::move(double right_m, double up_m) noexcept {
  shift(right_, right_m);
  shift(up_, up_m);
  handed_.publish(target_);
}

void MouseDevice::advance(double forward_m) noexcept {
  shift(forward_, forward_m);
  handed_.publish(target_);
}

void MouseDevice::turn(double pitch_rad, double yaw_rad, double roll_rad) noexcept {
  if (!finite({pitch_rad, yaw_rad, roll_rad})) return;
  Rotation q = multiply(target_.rotation_wxyz, about_axis({0, 1, 0}, pitch_rad));
  q = multiply(q, about_axis({0, 0, 1}, yaw_rad));
  target_.rotation_wxyz = normalised(multiply(q, about_axis({1, 0, 0}, roll_rad)));
  handed_.publish(target_);
}

void MouseDevice::set_lift(double direction) noexcept {
  target_.lift_direction = std::isfinite(direction) ? std::clamp(direction, -1.0, 1.0) : 0.0;
  handed_.publish(target_);
}

void MouseDevice::feel(double force_n, double device_limit_n) noexcept {
  if (!std::isfinite(force_n) || !std::isfinite(device_limit_n) || !(device_limit_n > 0.0)) return;
  target_.lift_share = std::clamp(1.0 - force_n / (settings_.lift_force_share * device_limit_n), 0.0, 1.0);
  if (++target_.felt == 0) target_.felt = 1;  // after years of frames
  handed_.publish(target_);
}

void MouseDevice::set_buttons(std::uint32_t buttons) noexcept {
  target_.buttons = buttons;
  handed_.publish(target_);
}

DeviceReading MouseDevice::read(double time_s) noexcept {
  const Target& target = handed_.newest();
  const double step_s = started_ ? std::clamp(time_s - now_s_, 0.0, kLongestStep) : 0.0;
  now_s_ = time_s;
  if (!started_ || target.placement != placement_) {
    limited_ = smooth_ = out_ = {target.position_m, target.rotation_wxyz};
    lift_ = smooth_lift_ = 0.0;
    placement_ = target.placement;
    started_ = true;
  }

  const Vector way = subtract(target.position_m, limited_.position_m);
  const double distance = length(way), reach = settings_.max_speed_m_s * step_s;
  limited_.position_m = distance > reach ? add(limited_.position_m, scale(way, reach / distance)) : target.position_m;
  const double angle = angle_between(limited_.rotation_wxyz, target.rotation_wxyz),
               turn = settings_.max_turn_rad_s * step_s;
  limited_.rotation_wxyz =
      angle > turn ? slerp(limited_.rotation_wxyz, target.rotation_wxyz, turn / angle) : target.rotation_wxyz;
  since_felt_s_ = target.felt == felt_ ? since_felt_s_ + step_s : 0.0;
  felt_ = target.felt;
  const bool old = felt_ != 0 && since_felt_s_ > settings_.feel_age_s;
  const double lifting = old ? 0.0 : target.lift_share;
  const double lift_speed =
      target.lift_direction * settings_.lift_speed_m_s * (target.lift_direction > 0.0 ? lifting : 1.0);
  lift_ = std::clamp(lift_ + lift_speed * step_s, 0.0, settings_.lift_range_m);

  const double share = 1.0 - std::exp(-step_s / settings_.smoothing_s);
  smooth_.position_m = add(smooth_.position_m, scale(subtract(limited_.position_m, smooth_.position_m), share));
  smooth_.rotation_wxyz = slerp(smooth_.rotation_wxyz, limited_.rotation_wxyz, share);
  out_.position_m = add(out_.position_m, scale(subtract(smooth_.position_m, out_.position_m), share));
  out_.rotation_wxyz = slerp(out_.rotation_wxyz, smooth_.rotation_wxyz, share);
  smooth_lift_ += share * (lift_ - smooth_lift_);
  lift_shown_.store(smooth_lift_, std::memory_order_relaxed);

  DeviceReading reading;
  reading.position_m = add(out_.position_m, rotate(out_.rotation_wxyz, {0, 0, smooth_lift_}));
  reading.rotation_wxyz =
      normalised(multiply(out_.rotation_wxyz, about_axis({0, 1, 0}, smooth_lift_ * settings_.lift_levels_rad_m)));
  reading.buttons = target.buttons;
  return reading;
}

void MouseDevice::write(const std::array<double, 3>&) noexcept {}  // a mouse has no motors: the window shows the force

}  // namespace vallecula::device
