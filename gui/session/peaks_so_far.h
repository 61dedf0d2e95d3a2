// The largest forces since a trial began, from every tick, as the score has them: what is drawn sees one tick in
// thirty.
#pragma once

#include <algorithm>
#include <cmath>

#include "curricula/trial_log.h"

namespace vallecula::gui {

/// Model force on a structure in a tick, N.
inline double load_n(const curricula::LogTick& tick, curricula::LoadedStructure structure) {
  const auto& f = tick.loads[structure].force_n;
  return std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
}

struct PeaksSoFar {
  float tongue_n = 0.0f, gum_n = 0.0f;
  long long led_ticks = 0;  ///< of the way on which the blade is led, still to come

  PeaksSoFar() = default;
  explicit PeaksSoFar(const curricula::LogHeader& header) {
    const auto led = header.settings.find(curricula::kLeadInTicks);
    if (led != header.settings.end()) led_ticks = static_cast<long long>(led->second);
  }
  /// What is no hand's doing counts as little as in the score: a tick of a pause, or of the way on which the blade is
  /// led.
  void take(const curricula::LogTick& tick) {
    if (curricula::paused(tick) || led_ticks-- > 0) return;
    tongue_n = std::fmax(tongue_n, static_cast<float>(load_n(tick, curricula::kTongue)));
    gum_n = std::fmax(gum_n, static_cast<float>(load_n(tick, curricula::kGum)));
  }
};

}  // namespace vallecula::gui
