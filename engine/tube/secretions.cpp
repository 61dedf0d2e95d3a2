#include "engine/tube/secretions.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace vallecula::engine {

namespace {

// An 8 F catheter draws 1 ml/s of mucus at the usual 100 mmHg (assumed); others by Hagen and Poiseuille.
constexpr double kReferenceFlow = 1e-6;      // m^3/s
constexpr double kReferenceInner = 1.78e-3;  // m
constexpr double kMostVolume = 20e-6;        // m^3: more than an infant's mouth and throat hold

}  // namespace

Secretions checked(const Secretions& s) {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument("secretions: " + why); };
  if (!(s.volume_m3 >= 0 && s.volume_m3 <= kMostVolume))
    refuse("a volume from 0 to 20 ml is needed, not " + std::to_string(1e6 * s.volume_m3));
  if (!(s.area_m2 >= 1e-6 && s.area_m2 <= 0.01))
    refuse("an area from 1 to 10000 mm^2 is needed, not " + std::to_string(1e6 * s.area_m2));
  if (!s.floor.allFinite()) refuse("the floor's deepest point is not finite");
  if (!(std::abs(s.up.norm() - 1) < 1e-3))
    refuse("the direction against gravity has a length of " + std::to_string(s.up.norm()) + " instead of 1");
  return s;
}

double drawn(const Secretions& s, double volume_m3, const Vec3& tip, double inner_diameter_m) noexcept {
  if (!(volume_m3 > 0)) return 0.0;
  const Vec3 from_floor = tip - s.floor;
  const double height = from_floor.dot(s.up);
  const Vec3 aside = from_floor - height * s.up;
  const bool dips = height - inner_diameter_m / 2 < level(s, volume_m3) && M_PI * aside.squaredNorm() < s.area_m2;
  const double ratio = inner_diameter_m / kReferenceInner;
  return dips ? kReferenceFlow * ratio * ratio * ratio * ratio : 0.0;
}

}  // namespace vallecula::engine
