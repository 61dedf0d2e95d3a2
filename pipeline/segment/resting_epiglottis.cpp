#include "pipeline/segment/resting_epiglottis.h"

#include <algorithm>
#include <cmath>

namespace vallecula::pipeline {
namespace {

/// Gas that partial volume has dimmed, too dark for fat.
constexpr double kPocketHu = -180.0;

/// Foremost lumen of a row behind `from_y`; -1 without.
int front_of_lumen(const Mask& lumen, int x, int z, double from_y) {
  const auto& g = lumen.grid;
  for (int y = std::max(0, g.nearest({0, from_y, 0})[1]); y < g.size[1]; ++y) {
    if (lumen.at(x, y, z) != 0) return y;
  }
  return -1;
}

}  // namespace

Epiglottis rest_epiglottis(const Hounsfield& hu, const Mask& body, const Mask& lumen, const Mask& hyoid,
                           const Airway& airway, const Frame& frame) {
  const auto& g = body.grid;
  const double k = frame.scale;
  Epiglottis e;
  e.mask = Mask(g);
  const auto bone = bounds_of(hyoid);
  const double mid_x = bone.empty() ? airway.glottis.centre[0]
                                    : 0.5 * (airway.glottis.centre[0] +
                                             g.origin[0] + 0.5 * (bone.low[0] + bone.high[0]) * g.spacing[0]);
  const double hyoid_y = bone.empty() ? airway.front_commissure[1] - 6.0 * k
                                      : g.origin[1] + 0.5 * (bone.low[1] + bone.high[1]) * g.spacing[1];
  const double hyoid_z =
      bone.empty() ? airway.front_commissure[2] + 7.4 * k : g.origin[2] + 0.5 * (bone.low[2] + bone.high[2]) * g.spacing[2];
  const double floor_z = airway.front_commissure[2] + 2.0 * k;
  const double thickness = 1.7 * k;

  // The pits: pockets between hyoid and airway.
  double pit_z = hyoid_z;
  for (int z = g.size[2] - 1; z >= 0; --z) {
    const double pz = g.origin[2] + z * g.spacing[2];
    if (std::abs(pz - hyoid_z) > 6.0 * k) continue;
    for (int x = 0; x < g.size[0]; ++x) {
      if (std::abs(g.origin[0] + x * g.spacing[0] - mid_x) > 8.0 * k) continue;
      const int wall = front_of_lumen(lumen, x, z, hyoid_y);
      for (int y = std::max(0, g.nearest({0, hyoid_y, 0})[1]); y < wall; ++y) {
        const bool before_the_leaf = (wall - y) * g.spacing[1] > thickness;
        if (before_the_leaf && hu.at(x, y, z) < kPocketHu) pit_z = pz;
      }
    }
  }
  const double top = pit_z + 10.0 * k;
  Vector3 tip{};
  Vector3 pit{};
  double tips = 0.0;
  double pits = 0.0;
  for (int z = 0; z < g.size[2]; ++z) {
    const double pz = g.origin[2] + z * g.spacing[2];
    if (pz < floor_z || pz > top) continue;
    // A stalk below, widest half way up the free leaf, rounded at the tip.
    const double stalk = std::clamp((pz - floor_z) / std::max(1.0, pit_z - floor_z), 0.0, 1.0);
    const double round = std::clamp((top - pz) / (4.0 * k), 0.0, 1.0);
    const double half = (2.2 * k + 3.0 * k * stalk) * std::sqrt(0.25 + 0.75 * round);
    for (int x = 0; x < g.size[0]; ++x) {
      const double side = g.origin[0] + x * g.spacing[0] - mid_x;
      if (std::abs(side) > half) continue;
      const int wall = front_of_lumen(lumen, x, z, hyoid_y);
      if (wall < 0) continue;
      for (int y = wall - 1; y >= 0 && (wall - y - 0.5) * g.spacing[1] < thickness; --y) {
        if (body.at(x, y, z) == 0) break;
        e.mask.at(x, y, z) = 1;
      }
      if (std::abs(side) > 3.0 * k) continue;
      const auto p = g.position(x, wall, z);
      if (top - pz < g.spacing[2] + 0.01) {
        tip = tip + p;
        tips += 1.0;
      }
      if (std::abs(pz - pit_z) < 0.51 * g.spacing[2]) {
        pit = pit + p - Vector3{0.0, thickness, 0.0};
        pits += 1.0;
      }
    }
  }
  e.mask = largest_component(e.mask);
  if (tips < 1.0 || pits < 1.0 || static_cast<double>(count(e.mask)) * g.voxel_mm3() < 40.0 * k * k * k) {
    e.mask = Mask(g);
    return e;
  }
  e.tip = (1.0 / tips) * tip;
  e.vallecula = (1.0 / pits) * pit;
  e.tip[0] = e.vallecula[0] = mid_x;
  e.thickness_mm = thickness;
  e.seen = true;
  return e;
}

}  // namespace vallecula::pipeline
