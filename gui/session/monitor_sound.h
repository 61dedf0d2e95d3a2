// What the bedside monitor sounds like: a tone at each heart beat whose pitch falls with the saturation, and alarms.
// Samples alone, no device: session/sound_output plays them.
#pragma once

#include <cstddef>

namespace vallecula::gui {

/// By IEC 60601-1-8: high asks for an act now, medium for one soon.
enum class AlarmSound { none, medium, high };

/// What the monitor says at a moment. No heart rate: no beats.
struct MonitorState {
  double spo2 = 0.0;  ///< displayed, 0..1
  double heart_per_min = 0.0;
  AlarmSound alarm = AlarmSound::none;
};

/// Assumed, as makers keep their scales to themselves: 880 Hz at 100 %, a semitone (2^(1/12)) lower each 2 % of the
/// whole per cents displayed; never below kLowestPulse_hz.
constexpr double kFullPulse_hz = 880.0, kPercentPerSemitone = 2.0, kLowestPulse_hz = 150.0;
double pulse_pitch_hz(double spo2) noexcept;

constexpr double kPulse_s = 0.09;  ///< of a beat's tone (assumed)
/// A burst: high 10 pulses, medium 3; then a rest. All within IEC 60601-1-8:2006, tables 3 and 4.
constexpr double kHighPulse_s = 0.15, kMediumPulse_s = 0.20, kHighRest_s = 5.0, kMediumRest_s = 10.0;
constexpr double kHighPitch_hz = 523.25, kMediumPitch_hz = 392.0;

class MonitorTones {
 public:
  explicit MonitorTones(double sample_rate_hz) : rate_hz_(sample_rate_hz) {}
  /// From the next sample on. A beat or an alarm's pulse that has begun is finished.
  void set(const MonitorState& state) noexcept { state_ = state; }
  void set_volume(double volume) noexcept { volume_ = volume; }  ///< 0..1
  /// The next `count` samples, -1..1, without a jump anywhere.
  void fill(float* mono, std::size_t count) noexcept;

 private:
  double pulse() noexcept;
  double alarm() noexcept;

  double rate_hz_;
  MonitorState state_;
  double volume_ = 0.0, loudness_ = 0.0;  ///< asked for; followed gently
  double beat_ = 0.0;                     ///< of the present beat, 0..1
  double pulse_s_ = -1.0, pulse_hz_ = 0.0;  ///< since the tone began; below 0: silent
  AlarmSound sounding_ = AlarmSound::none;
  double burst_s_ = 0.0;
};

}  // namespace vallecula::gui
