#include "engine/tube/tube_design.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vallecula::engine {

namespace {

constexpr double kGripShortOfConnector = 0.060;

/// Sources. Outer diameters of 3.5 and 4.0: CLINICAL.md (of 5.4 to 5.6 mm the middle); of 2.5 and 3.0, and the lengths:
/// makers' catalogues (assumed). Cord mark, a line 2 mm wide: 24, 26, 28 mm for 2.5, 3.0, 3.5 as first described (in
/// Gill and O'Donnell, Arch Dis Child Fetal Neonatal Ed 2014;99:F344); 4.0 continues the row (assumed). Curve: ISO
/// 5361's 140 mm. Bevel: 37.5 degrees (Red Cross items catalogue, MCTDTEND), facing left. Centimetre marks from 5 on,
/// Young's modulus (plasticised PVC has 10 to 30 MPa when warm; a tube comes at the room's temperature: the upper end),
/// Poisson's ratio and density: assumed.
struct Size {
  const char* name;
  double inner, outer, length, cord_mark;  // mm
};
constexpr Size kSizes[] = {
    {"2.5", 2.5, 3.6, 140, 24}, {"3.0", 3.0, 4.2, 160, 26}, {"3.5", 3.5, 4.9, 180, 28}, {"4.0", 4.0, 5.5, 200, 30}};

/// Second moment of area of a ring, m^4.
double ring_inertia(double outer, double inner) { return M_PI / 64 * (std::pow(outer, 4) - std::pow(inner, 4)); }
double ring_area(double outer, double inner) { return M_PI / 4 * (outer * outer - inner * inner); }

std::string mm(double m) { return std::to_string(1e3 * m) + " mm"; }

void check(const TubeDesign& t, const Stylet* s, double grip) {
  const auto positive = [](double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value))
      throw std::invalid_argument(std::string("tube: ") + what + " is " + std::to_string(value) +
                                  "; it must be above 0");
  };
  const auto poisson = [](double value, const char* what) {
    if (!(value > -1 && value <= 0.5))
      throw std::invalid_argument(std::string("tube: ") + what + " is " + std::to_string(value) +
                                  "; it must lie above -1 and at 0.5 at most");
  };
  positive(t.inner_diameter, "the inner diameter, m,");
  positive(t.length, "the length, m,");
  positive(t.bend_radius, "the radius of its curve, m,");
  positive(t.young_pa, "Young's modulus, Pa,");
  positive(t.density_kg_m3, "the density, kg/m^3,");
  poisson(t.poisson, "Poisson's ratio");
  if (!(t.outer_diameter > t.inner_diameter) || !std::isfinite(t.outer_diameter))
    throw std::invalid_argument("tube: an outer diameter of " + mm(t.outer_diameter) + " over an inner one of " +
                                mm(t.inner_diameter) + " leaves no wall");
  if (!(grip > 0) || !(grip <= t.length))
    throw std::invalid_argument("tube: it is " + mm(t.length) + " long and cannot be held " + mm(grip) +
                                " from its tip");
  if (!(t.cord_mark_from_tip > 0) || !(t.cord_mark_from_tip < t.length))
    throw std::invalid_argument("tube: a cord mark " + mm(t.cord_mark_from_tip) + " from the tip is not on a tube of " +
                                mm(t.length));
  if (!s) return;
  positive(s->diameter, "the stylet's diameter, m,");
  positive(s->young_pa, "the stylet's Young's modulus, Pa,");
  positive(s->density_kg_m3, "the stylet's density, kg/m^3,");
  positive(s->bend_length, "the length of the stylet's bend, m,");
  poisson(s->poisson, "the stylet's Poisson's ratio");
  if (!(s->diameter < t.inner_diameter))
    throw std::invalid_argument("tube: a stylet of " + mm(s->diameter) + " does not go into a lumen of " +
                                mm(t.inner_diameter));
  if (!(s->short_of_tip >= 0) || !(s->short_of_tip < grip))
    throw std::invalid_argument("tube: a stylet that ends " + mm(s->short_of_tip) +
                                " short of the tip is not between tip and grip");
  if (!std::isfinite(s->bend_rad) || !std::isfinite(s->bend_from_tip))
    throw std::invalid_argument("tube: the stylet's bend is not finite");
}

}  // namespace

TubeDesign tube_design(const std::string& inner_diameter_mm) {
  for (const Size& size : kSizes) {
    if (inner_diameter_mm != size.name) continue;
    TubeDesign tube;
    tube.inner_diameter = 1e-3 * size.inner;
    tube.outer_diameter = 1e-3 * size.outer;
    tube.length = 1e-3 * size.length;
    tube.cord_mark_from_tip = 1e-3 * size.cord_mark;
    return tube;
  }
  throw std::invalid_argument("tube '" + inner_diameter_mm + "' is not known; there are 2.5, 3.0, 3.5 and 4.0 (mm)");
}

TubeDesign suction_catheter(double outer_diameter) {
  TubeDesign catheter;
  catheter.outer_diameter = outer_diameter;
  catheter.inner_diameter = 2.0 / 3.0 * outer_diameter;
  catheter.bend_radius = 0.5;  // as it comes from its pack (assumed)
  catheter.bevel_rad = M_PI / 2;
  return catheter;
}

double usual_grip_from_tip(const TubeDesign& tube) { return tube.length - kGripShortOfConnector; }

RodDescription tube_rod(const TubeDesign& tube, const Stylet* stylet, double grip_from_tip) {
  check(tube, stylet, grip_from_tip);
  RodDescription rod;
  rod.length_m = grip_from_tip;
  rod.outer_radius_m = tube.outer_diameter / 2;
  rod.mass_kg_m = tube.density_kg_m3 * ring_area(tube.outer_diameter, tube.inner_diameter);
  if (stylet) rod.mass_kg_m += stylet->density_kg_m3 * ring_area(stylet->diameter, 0.0);
  const double wall = tube.young_pa * ring_inertia(tube.outer_diameter, tube.inner_diameter);
  const double core = stylet ? stylet->young_pa * ring_inertia(stylet->diameter, 0.0) : 0.0;
  const double segment = grip_from_tip / kTubeSegments;
  for (int i = 0; i < kTubeJoints; ++i) {
    RodSection& section = rod.section[static_cast<std::size_t>(i)];
    const double low = (i + 0.5) * segment, high = low + segment;  // what the joint stands for, from the tip
    section.bending_n_m2 = wall;
    section.twisting_n_m2 = wall / (1 + tube.poisson);  // G J, with J = 2 I
    section.natural_curvature_per_m = 1 / tube.bend_radius;
    if (!stylet) continue;
    const double within = std::clamp((high - stylet->short_of_tip) / segment, 0.0, 1.0);
    const double bend_low = stylet->bend_from_tip - stylet->bend_length / 2, bend_high = bend_low + stylet->bend_length;
    const double bent = std::max(0.0, std::min(high, bend_high) - std::max(low, bend_low)) / segment;
    const double curvature = bent * stylet->bend_rad / stylet->bend_length;
    section.bending_n_m2 += within * core;
    section.twisting_n_m2 += within * core / (1 + stylet->poisson);
    section.natural_curvature_per_m =
        (wall * section.natural_curvature_per_m + within * core * curvature) / section.bending_n_m2;
  }
  return rod;
}

}  // namespace vallecula::engine
