// What stands beside the infant: the pulse oximeter, late by as much as this infant's limb and this device make it, and
// the colour of the CO2 detector on the tube.
#pragma once

#include <array>
#include <cstdint>

namespace vallecula::engine {

constexpr double kMonitorStep = 0.1;  ///< s, between samples
constexpr int kAveraged = 80;         ///< samples: 8 s, a usual setting
constexpr int kMostDelay = 200;       ///< samples: 20 s
constexpr int kShownEvery = 10;       ///< samples: the number changes once a second

struct OximeterState {
  std::array<float, kMostDelay + kAveraged / 2> seen{};  ///< ring of arterial saturations
  std::int32_t newest = 0;
  std::int32_t until_shown = kShownEvery;
  std::int32_t percent = 0;  ///< as displayed
};

OximeterState start_oximeter(double arterial) noexcept;

/// One sample: the display is the mean of 8 s whose middle lies delay_samples (40..200) ago, in whole percent.
void sample(OximeterState& s, int delay_samples, double arterial) noexcept;

/// All that it has seen changes by this: what is driven from outside shows at once.
void shift(OximeterState& s, double by) noexcept;

/// Colours of a colorimetric detector: purple without CO2, yellow with it.
enum class DetectorColour : std::uint8_t { purple, yellow };

struct Co2Detector {
  std::int32_t breaths_needed = 0;   ///< with CO2, one after the other, until it is yellow
  double least_heart_per_min = 0.0;  ///< below this too little CO2 comes to the lungs: the false negative
};

struct Co2DetectorState {
  std::int32_t breaths = 0;  ///< with CO2, one after the other
};

/// A breath through the tube whose tip is, or is not, in the airway.
void breathe(const Co2Detector& d, Co2DetectorState& s, bool in_airway, double heart_per_min) noexcept;

DetectorColour colour(const Co2Detector& d, const Co2DetectorState& s) noexcept;

}  // namespace vallecula::engine
