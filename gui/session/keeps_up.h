// Whether the computer keeps up with the hand.
#pragma once

namespace vallecula::gui {

constexpr double kNoticedShare =
    0.01;  ///< of forces that are late, or steps dropped, from which a hand notices (assumed)

/// `late`: forces written more than 1 ms after they were due; `dropped`: ticks whose simulation step was not finished.
constexpr bool keeps_up(long long ticks, long long late, long long dropped) {
  const double noticed = kNoticedShare * static_cast<double>(ticks);
  return static_cast<double>(late) <= noticed && static_cast<double>(dropped) <= noticed;
}

}  // namespace vallecula::gui
