#include "gui/session/monitor_sound.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vallecula::gui {
namespace {

constexpr double kLoud = 0.45;         // pulse and alarm together stay below 1
constexpr double kPulseRise_s = 0.010, kPulseFall_s = 0.035, kAlarmEdge_s = 0.030;
constexpr double kVolumeTime_s = 0.03;

struct Pattern {
  const double* onsets_s;
  std::size_t pulses;
  double pulse_s, pitch_hz, length_s;
};
// From one pulse's begin to the next: 3 + 2, a pause, and again; and 3 alone.
constexpr std::array<double, 10> kHighOnsets{0.0, 0.25, 0.50, 0.95, 1.20, 2.00, 2.25, 2.50, 2.95, 3.20};
constexpr std::array<double, 3> kMediumOnsets{0.0, 0.40, 0.80};
constexpr Pattern kHigh{kHighOnsets.data(), kHighOnsets.size(), kHighPulse_s, kHighPitch_hz,
                        kHighOnsets.back() + kHighPulse_s + kHighRest_s};
constexpr Pattern kMedium{kMediumOnsets.data(), kMediumOnsets.size(), kMediumPulse_s, kMediumPitch_hz,
                          kMediumOnsets.back() + kMediumPulse_s + kMediumRest_s};

/// 0 at both ends, 1 between, with round shoulders.
double envelope(double at_s, double length_s, double rise_s, double fall_s) {
  if (at_s < 0.0 || at_s >= length_s) return 0.0;
  const double share = std::min({1.0, at_s / rise_s, (length_s - at_s) / fall_s});
  return 0.5 - 0.5 * std::cos(M_PI * share);
}

/// The fundamental and four harmonics, so that it is heard as an alarm and found by the ear; within -1..1.
double rich(double phase) {
  double sum = 0.0, loudest = 0.0;
  for (int k = 1; k <= 5; ++k) {
    sum += std::sin(k * phase) / k;
    loudest += 1.0 / k;
  }
  return sum / loudest;
}

}  // namespace

double pulse_pitch_hz(double spo2) noexcept {
  const double percent = std::round(100.0 * std::clamp(spo2, 0.0, 1.0));
  return std::max(kLowestPulse_hz, kFullPulse_hz * std::exp2((percent - 100.0) / (12.0 * kPercentPerSemitone)));
}

double MonitorTones::pulse() noexcept {
  const double step_s = 1.0 / rate_hz_;
  if (pulse_s_ >= 0.0 && (pulse_s_ += step_s) >= kPulse_s) pulse_s_ = -1.0;
  if (state_.heart_per_min > 0.0) beat_ += step_s * state_.heart_per_min / 60.0;
  if (beat_ >= 1.0) {
    beat_ -= std::floor(beat_);
    if (pulse_s_ < 0.0) {  // a heart faster than its tone is long misses none of it, and begins none
      pulse_s_ = 0.0;
      pulse_hz_ = pulse_pitch_hz(state_.spo2);
    }
  }
  return pulse_s_ < 0.0 ? 0.0
                        : envelope(pulse_s_, kPulse_s, kPulseRise_s, kPulseFall_s) *
                              std::sin(2.0 * M_PI * pulse_hz_ * pulse_s_);
}

double MonitorTones::alarm() noexcept {
  const auto pattern_of = [](AlarmSound alarm) { return alarm == AlarmSound::high ? &kHigh : &kMedium; };
  const auto in_pulse = [](const Pattern& pattern, double at_s) {
    for (std::size_t i = 0; i < pattern.pulses; ++i)
      if (at_s >= pattern.onsets_s[i] && at_s < pattern.onsets_s[i] + pattern.pulse_s) return at_s - pattern.onsets_s[i];
    return -1.0;
  };
  double at_s = sounding_ == AlarmSound::none ? -1.0 : in_pulse(*pattern_of(sounding_), burst_s_);
  if (at_s < 0.0 && sounding_ != state_.alarm) {
    sounding_ = state_.alarm;
    burst_s_ = 0.0;
    at_s = sounding_ == AlarmSound::none ? -1.0 : 0.0;
  }
  if (sounding_ == AlarmSound::none) return 0.0;
  const Pattern& pattern = *pattern_of(sounding_);
  burst_s_ += 1.0 / rate_hz_;
  if (burst_s_ >= pattern.length_s) burst_s_ = 0.0;
  return at_s < 0.0 ? 0.0
                    : envelope(at_s, pattern.pulse_s, kAlarmEdge_s, kAlarmEdge_s) *
                          rich(2.0 * M_PI * pattern.pitch_hz * at_s);
}

void MonitorTones::fill(float* mono, std::size_t count) noexcept {
  const double follow = 1.0 - std::exp(-1.0 / (kVolumeTime_s * rate_hz_));
  for (std::size_t i = 0; i < count; ++i) {
    loudness_ += follow * (std::clamp(volume_, 0.0, 1.0) - loudness_);
    mono[i] = static_cast<float>(kLoud * loudness_ * (pulse() + alarm()));
  }
}

}  // namespace vallecula::gui
