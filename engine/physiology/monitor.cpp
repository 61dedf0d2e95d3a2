#include "engine/physiology/monitor.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

std::int32_t percent(double fraction) noexcept {
  return static_cast<std::int32_t>(100.0 * std::clamp(fraction, 0.0, 1.0) + 0.5);
}

}  // namespace

OximeterState start_oximeter(double arterial) noexcept {
  OximeterState s;
  s.seen.fill(static_cast<float>(arterial));
  s.percent = percent(arterial);
  return s;
}

void sample(OximeterState& s, int delay_samples, double arterial) noexcept {
  constexpr int kRing = static_cast<int>(std::tuple_size<decltype(s.seen)>::value);
  s.newest = (s.newest + 1) % kRing;
  s.seen[static_cast<std::size_t>(s.newest)] = static_cast<float>(arterial);
  if (--s.until_shown > 0) return;
  s.until_shown = kShownEvery;
  // Summed anew each time: a running sum would keep its rounding errors for ever.
  const int last = std::clamp(delay_samples, kAveraged / 2, kMostDelay) - kAveraged / 2;
  double sum = 0.0;
  for (int k = 0; k < kAveraged; ++k)
    sum += static_cast<double>(s.seen[static_cast<std::size_t>((s.newest - last - k + 2 * kRing) % kRing)]);
  s.percent = percent(sum / kAveraged);
}

void shift(OximeterState& s, double by) noexcept {
  for (float& seen : s.seen) seen = static_cast<float>(std::clamp(static_cast<double>(seen) + by, 0.0, 1.0));
}

void breathe(const Co2Detector& d, Co2DetectorState& s, bool in_airway, double heart_per_min) noexcept {
  if (in_airway && heart_per_min >= d.least_heart_per_min)
    s.breaths = std::min(s.breaths + 1, d.breaths_needed);
  else
    s.breaths = 0;
}

DetectorColour colour(const Co2Detector& d, const Co2DetectorState& s) noexcept {
  return s.breaths >= d.breaths_needed ? DetectorColour::yellow : DetectorColour::purple;
}

}  // namespace vallecula::engine
