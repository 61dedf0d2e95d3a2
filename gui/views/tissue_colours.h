// What colour a tissue has on the screen, and the fine unevenness that makes it look like tissue. Display only.
#pragma once

#include <array>

#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

using Colour = std::array<double, 3>;  ///< linear-looking sRGB, 0..1

constexpr Colour kTongueColour{0.80, 0.34, 0.35};
constexpr Colour kEpiglottisColour{0.93, 0.62, 0.56};
constexpr Colour kCordColour{0.98, 0.94, 0.90};
constexpr Colour kTracheaColour{0.91, 0.60, 0.56};
constexpr Colour kCartilageColour{0.95, 0.86, 0.80};
constexpr Colour kAirwayBlue{0.16, 0.42, 0.93};  ///< the paper draws the trachea in blue
constexpr Colour kBoneColour{0.90, 0.86, 0.74};

Colour tissue_colour(pipeline::Tissue tissue);
/// 0 dry and matt .. 1 wet and glossy.
double tissue_wetness(pipeline::Tissue tissue);

/// Smooth noise of a point (mm), about -1..1, fixed for all time; `wavelength_mm` is its grain.
double grain(const std::array<double, 3>& point_mm, double wavelength_mm);
/// Its gradient, per `wavelength_mm`: what a bump map tilts a normal by.
std::array<double, 3> grain_slope(const std::array<double, 3>& point_mm, double wavelength_mm);

/// Base colour with the blotches of living skin or mucosa: redder and paler patches of some millimetres.
Colour mottled(const Colour& base, const std::array<double, 3>& point_mm, double strength);

}  // namespace vallecula::gui
