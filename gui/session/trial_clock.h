// The trial's clock as its log has it.
#pragma once

#include <algorithm>

#include "engine/snapshot.h"

namespace vallecula::gui {

constexpr double kServoPeriodS = 0.001;

/// s, pauses included. A step that was not finished in time holds up what the picture shows, and not the time of an
/// attempt: that is the hand's.
inline double trial_clock_s(const engine::Snapshot& snapshot) {
  return std::max(snapshot.time_s, kServoPeriodS * static_cast<double>(snapshot.ticks));
}

}  // namespace vallecula::gui
