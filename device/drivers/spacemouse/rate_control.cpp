#include "device/drivers/spacemouse/rate_control.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

/// A servo that paused goes on from where it was: no step is longer than this.
constexpr double kLongestStep = 0.05;
/// Below this share of the greatest speed a cap that was let go stands still: an exponential never ends by itself.
constexpr double kStandsStill = 1e-3;

void require_positive(double value, const char* name) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw DeviceError(std::string("spacemouse: ") + name + " = " + std::to_string(value) +
                      "; expected a positive number");
  }
}

/// From the cap's axes (right, towards the person, down) to the device's (right, up, towards the person), as a share of
/// the greatest deflection; a vector no longer than one.
Vector share_of_full(const std::array<std::int16_t, 3>& counts, const RateSettings& settings) noexcept {
  Vector share;
  for (std::size_t i = 0; i < 3; ++i) {
    const double pushed = std::min(std::abs(static_cast<double>(counts[i])) / settings.full_counts, 1.0);
    const double beyond = std::max(0.0, pushed - settings.dead_zone) / (1.0 - settings.dead_zone);
    share[i] = counts[i] < 0 ? -beyond : beyond;
  }
  const double total = length(share);
  if (total > 1.0) share = scale(share, 1.0 / total);
  return {share[0], -share[2], share[1]};
}

/// One step of a first-order low-pass towards `wanted`, which has `full` as its greatest length.
void approach(Vector& now, const Vector& wanted, double share, double full) noexcept {
  now = add(now, scale(subtract(wanted, now), share));
  if (length(wanted) == 0.0 && length(now) < kStandsStill * full) now = {0, 0, 0};
}

}  // namespace

RateControl::RateControl(const RateSettings& settings) : settings_(settings) {
  require_positive(settings.max_speed_m_s, "max_speed_m_s");
  require_positive(settings.max_turn_rad_s, "max_turn_rad_s");
  require_positive(settings.full_counts, "full_counts");
  require_positive(settings.dead_zone, "dead_zone");
  require_positive(1.0 - settings.dead_zone, "1 - dead_zone");
  require_positive(settings.smoothing_s, "smoothing_s");
  require_positive(settings.silence_s, "silence_s");
  require_positive(settings.workspace_m, "workspace_m");
}

double RateControl::advance_clock(double time_s) noexcept {
  const double step_s = started_ && time_s > now_s_ ? time_s - now_s_ : 0.0;
  if (std::isfinite(time_s)) now_s_ = time_s;
  started_ = true;
  return std::isfinite(step_s) ? step_s : 0.0;
}

DeviceReading RateControl::hold(double time_s) noexcept {
  advance_clock(time_s);
  speed_m_s_ = turn_rad_s_ = {0, 0, 0};
  reading_.buttons = 0;
  return reading_;
}

DeviceReading RateControl::step(const SpaceMouseState& cap, double time_s) noexcept {
  const double passed_s = advance_clock(time_s), step_s = std::min(passed_s, kLongestStep);
  translation_silent_s_ = cap.translation_reports != translation_reports_ ? 0.0 : translation_silent_s_ + passed_s;
  rotation_silent_s_ = cap.rotation_reports != rotation_reports_ ? 0.0 : rotation_silent_s_ + passed_s;
  translation_reports_ = cap.translation_reports;
  rotation_reports_ = cap.rotation_reports;

  Vector speed{0, 0, 0}, turn{0, 0, 0};
  if (translation_silent_s_ < settings_.silence_s)
    speed = scale(share_of_full(cap.translation, settings_), settings_.max_speed_m_s);
  if (rotation_silent_s_ < settings_.silence_s)
    turn = scale(share_of_full(cap.rotation, settings_), settings_.max_turn_rad_s);
  const double share = 1.0 - std::exp(-step_s / settings_.smoothing_s);
  approach(speed_m_s_, speed, share, settings_.max_speed_m_s);
  approach(turn_rad_s_, turn, share, settings_.max_turn_rad_s);

  const double reach = 0.5 * settings_.workspace_m;
  reading_.position_m = add(reading_.position_m, scale(speed_m_s_, step_s));
  for (double& x : reading_.position_m) x = std::clamp(x, -reach, reach);
  const double rate = length(turn_rad_s_);
  if (rate > 0.0)
    reading_.rotation_wxyz =
        normalised(multiply(about_axis(scale(turn_rad_s_, 1.0 / rate), rate * step_s), reading_.rotation_wxyz));
  reading_.buttons = cap.buttons;
  return reading_;
}

}  // namespace vallecula::device
