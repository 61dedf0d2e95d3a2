// What the monitor sounds like, measured on its samples by means that know nothing of how they were made.
#include "gui/session/monitor_sound.h"

#include <QAudioDeviceInfo>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "gui/session/sound_output.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

constexpr double kRate = 44100.0;

std::vector<float> samples(MonitorTones& tones, double seconds) {
  std::vector<float> out(static_cast<std::size_t>(seconds * kRate));
  tones.fill(out.data(), out.size());
  return out;
}
/// At full volume, settled.
MonitorTones sounding(const MonitorState& state) {
  MonitorTones tones(kRate);
  tones.set_volume(1.0);
  samples(tones, 0.5);
  tones.set(state);
  return tones;
}
/// Begin and end (samples) of every stretch in which something sounds.
std::vector<std::pair<std::size_t, std::size_t>> sounds(const std::vector<float>& all) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  const std::size_t quiet = static_cast<std::size_t>(0.02 * kRate);
  std::size_t last = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::abs(all[i]) < 1e-3f) continue;
    if (found.empty() || i - last > quiet) found.push_back({i, i});
    found.back().second = last = i;
  }
  return found;
}
/// The strongest frequency of a stretch, Hz: the peak of its discrete Fourier sum, searched in steps of 1 Hz.
double pitch(const std::vector<float>& all, std::pair<std::size_t, std::size_t> of) {
  double best = 0.0, at = 0.0;
  for (double hz = 100.0; hz < 1500.0; hz += 1.0) {
    std::complex<double> sum;
    for (std::size_t i = of.first; i < of.second; ++i)
      sum += static_cast<double>(all[i]) * std::polar(1.0, -2.0 * M_PI * hz * static_cast<double>(i) / kRate);
    if (std::abs(sum) > best) best = std::abs(sum), at = hz;
  }
  return at;
}

TEST(MonitorSound, ATonePerBeatWhosePitchFallsWithTheSaturation) {
  // Semitones of equal temperament, by hand: 100 % is a'' (880 Hz), 90 % five semitones lower e'' (659.26 Hz),
  // 76 % twelve lower a' (440 Hz).
  const std::pair<double, double> known[] = {{1.00, 880.0}, {0.90, 659.26}, {0.76, 440.0}};
  for (const auto& [spo2, hz] : known) {
    MonitorTones tones = sounding({spo2, 150.0, AlarmSound::none});
    const auto heard = samples(tones, 4.2);
    const auto beeps = sounds(heard);
    ASSERT_EQ(beeps.size(), 10u) << "150 a minute";
    EXPECT_NEAR(pitch(heard, beeps[3]), hz, 0.01 * hz);
    for (std::size_t i = 1; i < beeps.size(); ++i)
      EXPECT_NEAR(static_cast<double>(beeps[i].first - beeps[i - 1].first) / kRate, 0.4, 0.002);
  }
}

TEST(MonitorSound, IsSilentWithoutAHeartAndAtNoVolume) {
  MonitorTones still = sounding({0.97, 0.0, AlarmSound::none});
  EXPECT_TRUE(sounds(samples(still, 3.0)).empty());
  MonitorTones muted = sounding({0.97, 150.0, AlarmSound::high});
  muted.set_volume(0.0);
  samples(muted, 0.5);
  EXPECT_TRUE(sounds(samples(muted, 3.0)).empty());
}

TEST(MonitorSound, AlarmsAreBurstsOfTenAndOfThree) {
  MonitorTones high = sounding({0.7, 0.0, AlarmSound::high});
  const auto heard = samples(high, 8.0);
  const auto pulses = sounds(heard);
  ASSERT_EQ(pulses.size(), 10u) << "then a rest of 5 s";
  const auto begin_s = [&](std::size_t i) { return static_cast<double>(pulses[i].first) / kRate; };
  EXPECT_GT(begin_s(3) - begin_s(2), 1.5 * (begin_s(1) - begin_s(0))) << "three and two";
  const double between = begin_s(5) - static_cast<double>(pulses[4].second) / kRate;
  EXPECT_TRUE(between > 0.35 && between < 1.3) << between << " s, IEC 60601-1-8";
  EXPECT_NEAR(pitch(heard, pulses[0]), 523.25, 6.0);
  MonitorTones medium = sounding({0.9, 0.0, AlarmSound::medium});
  EXPECT_EQ(sounds(samples(medium, 8.0)).size(), 3u);
  EXPECT_EQ(sounds(samples(medium, 3.2)).size(), 1u) << "the next burst begins 11 s after the first";
}

TEST(MonitorSound, NeverClicks) {
  // Whatever changes and whenever: from sample to sample no more than the steepest tone of the loudest mix can rise.
  // The pulse: 2 pi f a sample. The alarm: 5 partials of amplitude 1/k over their sum, each as steep as the first. The
  // edges: pi / 2 a rise time. Volume: a 30 ms filter.
  const double loudest = 0.45, partials = 1.0 + 1.0 / 2 + 1.0 / 3 + 1.0 / 4 + 1.0 / 5;
  const double bound = loudest * (2 * M_PI * 880.0 + 5.0 / partials * 2 * M_PI * 523.25 + M_PI / 2 / 0.010 +
                                  M_PI / 2 / 0.030 + 2.0 / 0.03) / kRate;
  ASSERT_LT(bound, 0.15) << "a tone cut off at its height jumps by 0.45";
  MonitorTones tones(kRate);
  float last = 0.0f;
  double steepest = 0.0;
  const AlarmSound alarms[] = {AlarmSound::none, AlarmSound::high, AlarmSound::medium};
  for (int change = 0; change < 400; ++change) {
    tones.set({0.6 + 0.4 * std::abs(std::sin(1.3 * change)), change % 7 == 0 ? 0.0 : 60.0 + 3.0 * (change % 50),
               alarms[change % 3]});
    tones.set_volume(change % 5 == 0 ? 0.0 : 1.0);
    for (const float sample : samples(tones, 0.013 + 0.0007 * (change % 61))) {
      steepest = std::max(steepest, static_cast<double>(std::abs(sample - last)));
      last = sample;
    }
  }
  EXPECT_LT(steepest, bound);
  EXPECT_GT(steepest, 0.25 * bound) << "there was something to hear";
}

class Loudspeaker : public Screen {};

TEST_F(Loudspeaker, OrNoneIsSaidAndNothingWaitsForIt) {
  SoundOutput output;
  bool answered = false;
  QObject::connect(&output, &SoundOutput::answered, [&] { answered = true; });
  output.set_volume(0.0);
  output.hear({0.97, 150.0, AlarmSound::none});
  output.open();
  EXPECT_FALSE(answered) << "the answer comes later";
  ASSERT_TRUE(wait_for([&] { return answered; }, 30000));
  if (QAudioDeviceInfo::defaultOutputDevice().isNull()) {
    EXPECT_TRUE(output.remark().contains("no loudspeaker")) << output.remark().toStdString();
  }
}

}  // namespace
}  // namespace vallecula::gui::window_test
