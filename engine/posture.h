// How the operator holds his own head and the assistant the infant's: helps that are asked for while a key is down.
#pragma once

#include <cstdint>

#include "engine/types.h"

namespace vallecula::engine {

constexpr double kEyeMove = 0.02;          ///< m, to each side
constexpr double kEyeMoveTime = 0.3;       ///< s, from the standing place to there (assumed)
constexpr double kExtension = 0.1745329;   ///< rad: 10 degrees, what a shoulder roll adds (assumed)
constexpr double kExtensionTime = 0.5;     ///< s, to the whole angle (assumed)

/// Of a trial, changing.
struct PostureState {
  double right = 0.0, up = 0.0;  ///< of the eye, as shares of kEyeMove, -1..1
  double extension = 0.0;        ///< share of kExtension, 0..1
};

/// dt_s (s) of it, with these bits of Action set. What is not a number is back at its start.
void step(PostureState& state, std::uint32_t actions, double dt_s) noexcept;

/// A way 0..1 as a limb goes it, from rest to rest (a cubic; the same for -1..0).
double eased(double share) noexcept;

}  // namespace vallecula::engine
