#include "gui/views/tissue_colours.h"

#include <vtkNew.h>
#include <vtkPerlinNoise.h>

#include <algorithm>

namespace vallecula::gui {

Colour tissue_colour(pipeline::Tissue tissue) {
  switch (tissue) {
    case pipeline::Tissue::skin:
      return {0.90, 0.68, 0.58};
    case pipeline::Tissue::lip:
      return {0.82, 0.47, 0.44};
    case pipeline::Tissue::gum:
      return {0.88, 0.52, 0.52};
    case pipeline::Tissue::palate:
      return {0.86, 0.50, 0.48};
    case pipeline::Tissue::mucosa:
      return {0.78, 0.36, 0.34};
    case pipeline::Tissue::larynx:
      return {0.90, 0.54, 0.50};
  }
  return {0.8, 0.4, 0.4};
}

double tissue_wetness(pipeline::Tissue tissue) {
  switch (tissue) {
    case pipeline::Tissue::skin:
      return 0.0;
    case pipeline::Tissue::lip:
      return 0.35;
    case pipeline::Tissue::gum:
    case pipeline::Tissue::palate:
      return 0.85;
    case pipeline::Tissue::mucosa:
    case pipeline::Tissue::larynx:
      return 1.0;
  }
  return 0.0;
}

double grain(const std::array<double, 3>& point_mm, double wavelength_mm) {
  static const vtkNew<vtkPerlinNoise> noise;  // evaluation is const in effect: no state changes after construction
  double p[3] = {point_mm[0] / wavelength_mm, point_mm[1] / wavelength_mm, point_mm[2] / wavelength_mm};
  return noise->EvaluateFunction(p);
}

std::array<double, 3> grain_slope(const std::array<double, 3>& point_mm, double wavelength_mm) {
  const double step = 0.1 * wavelength_mm;
  std::array<double, 3> slope{};
  for (int axis = 0; axis < 3; ++axis) {
    auto ahead = point_mm, behind = point_mm;
    ahead[axis] += step;
    behind[axis] -= step;
    slope[axis] = (grain(ahead, wavelength_mm) - grain(behind, wavelength_mm)) / 0.2;
  }
  return slope;
}

Colour mottled(const Colour& base, const std::array<double, 3>& point_mm, double strength) {
  const double coarse = grain(point_mm, 11.0), fine = grain(point_mm, 3.1);
  const double redness = strength * (0.7 * coarse + 0.3 * fine), light = strength * 0.5 * fine;
  return {std::clamp(base[0] * (1.0 + 0.25 * redness + light), 0.0, 1.0),
          std::clamp(base[1] * (1.0 - redness + light), 0.0, 1.0),
          std::clamp(base[2] * (1.0 - 0.9 * redness + light), 0.0, 1.0)};
}

}  // namespace vallecula::gui
