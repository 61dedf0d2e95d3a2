// How the blade was moved.
#pragma once

#include <optional>
#include <vector>

#include "curricula/trial_log.h"

namespace vallecula::curricula {

struct Stay;

struct MotionFigures {
  /// Of the blade's tip as the scene held it, over all attempts; from means of kPathBlockS, so that a device's noise does
  /// not add up to a way.
  double tip_path_m = 0.0;
  // For researchers: of the hand (the device's pose) over the longest stretch of an attempt without a pause.
  std::optional<double> smoothness;  ///< spectral arc length of the tip's speed at 50 Hz; nothing below 1 s
  std::optional<double> tremor_m;    ///< root mean square of the tip's way within kTremorLowHz to kTremorHighHz, three
                                     ///< axes together; nothing below kTremorSegment samples of kTremorBlockS
};

constexpr double kPathBlockS = 0.02;  ///< also the speed's samples for the smoothness
constexpr double kTremorBlockS = 0.005;
constexpr std::size_t kTremorSegment = 256;  ///< samples: 1.28 s
constexpr double kTremorLowHz = 4.0, kTremorHighHz = 12.0;  ///< with the window's resolution of 0.8 Hz

/// Spectral arc length: Balasubramanian et al. 2012 and 2015 (10 Hz, 5 %, padding 4). Tremor: Welch's periodogram.
MotionFigures measure_motion(const TrialLog& log, const std::vector<Stay>& attempts);

}  // namespace vallecula::curricula
