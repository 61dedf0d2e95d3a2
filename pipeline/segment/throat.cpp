#include "pipeline/segment/throat.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vallecula::pipeline {

Mask find_soft_palate(const Mask& body, const Mask& lumen, const Mask& skull, const Epiglottis& epiglottis,
                      const Airway& airway, const Frame& frame, const std::optional<Vector3>& seed) {
  const auto& g = body.grid;
  const double s = frame.scale;
  auto sheet = all_of(without(closed(lumen, 3.0 * s), lumen), body);
  sheet = without(sheet, skull);
  const double low = epiglottis.seen ? epiglottis.tip[2] + 3.0 * s : airway.glottis.centre[2] + 16.0 * s;
  for (std::size_t i = 0; i < sheet.voxels.size(); ++i) {
    if (sheet.voxels[i] == 0) continue;
    const auto p = g.position(i);
    const bool place =
        p[2] > low && std::abs(p[0] - frame.mid_x) < 14.0 * s && p[1] > airway.glottis.centre[1] - 12.0 * s;
    if (!place || epiglottis.mask.voxels[i] != 0) sheet.voxels[i] = 0;
  }
  const int behind = static_cast<int>(std::ceil(4.0 * s / g.spacing[1]));
  // Above the hard palate a thin sheet is the septum.
  for (int y = 0; y < g.size[1]; ++y) {
    for (int x = 0; x < g.size[0]; ++x) {
      bool above_bone = false;
      for (int z = 0; z < g.size[2]; ++z) {
        // Also just behind the bone's edge, where the septum stands on the palate's root.
        for (int ahead = 0; ahead <= behind && y - ahead >= 0; ++ahead) {
          above_bone = above_bone || (z > 0 && skull.at(x, y - ahead, z - 1) != 0);
        }
        if (above_bone) sheet.at(x, y, z) = 0;
      }
    }
  }
  const auto parts = components(opened(sheet, 0.8 * s));
  if (seed) {
    const int piece = piece_at(parts, *seed, 3.0 * s);
    if (piece == 0)
      throw std::runtime_error("the soft palate's seed lies in no sheet between airway and airway behind the palate");
    return all_of(sheet, dilated(parts.mask(piece), 0.8 * s));
  }
  if (parts.sizes.size() < 2 || parts.sizes[1] * g.voxel_mm3() < 60.0 * s * s * s) return Mask(g);
  return all_of(sheet, dilated(parts.mask(1), 0.8 * s));
}

Mask find_larynx(const Mask& body, const Mask& lumen, const Mask& taken, const Airway& airway, const Frame& frame) {
  const auto& g = body.grid;
  const double s = frame.scale;
  const auto& c = airway.glottis.centre;
  const auto& n = airway.glottis.normal;
  Mask larynx(g);
  const auto to_lumen = distance_to(lumen);
  for (std::size_t i = 0; i < larynx.voxels.size(); ++i) {
    if (body.voxels[i] == 0 || taken.voxels[i] != 0) continue;
    const auto p = g.position(i);
    const double up = dot(p - c, n);
    if (up < -11.0 * s || up > 7.0 * s) continue;
    const Vector3 axis = c + up * n;
    const double side = std::abs(p[0] - axis[0]);
    const double back = p[1] - axis[1];
    const bool wall = to_lumen.voxels[i] < 3.0 * s && side < 6.0 * s && back > -7.0 * s && back < 7.0 * s;
    if (wall && (up < 1.0 * s || to_lumen.voxels[i] < 2.0 * s)) larynx.voxels[i] = 1;
  }
  return larynx;
}

Mask find_oesophagus(const Mask& body, const Mask& gas, const Mask& spine, const Mask& taken, const Airway& airway,
                     const Frame& frame) {
  const auto& g = body.grid;
  const double s = frame.scale;
  Mask out(g);
  const double half = 3.5 * s;
  for (const auto& cut : airway.course) {
    if (cut.centre[2] > airway.glottis.centre[2] - 2.0 * s) continue;
    const int z = g.nearest(cut.centre)[2];
    const int x = g.nearest(cut.centre)[0];
    if (!g.contains(x, 0, z)) continue;
    const double radius = std::sqrt(cut.area_mm2 / 3.14159265);
    const double wall = cut.centre[1] + radius;
    double bone = wall + 8.0 * s;
    for (int y = g.nearest({0, wall, 0})[1]; y < g.size[1]; ++y) {
      if (spine.at(x, y, z) == 0) continue;
      bone = g.origin[1] + y * g.spacing[1];
      break;
    }
    const double middle = wall + 0.4 * std::min(bone - wall, 9.0 * s);
    const double depth = std::clamp(0.4 * (bone - wall), 1.2 * s, 3.0 * s);
    for (int y = 0; y < g.size[1]; ++y) {
      for (int xx = 0; xx < g.size[0]; ++xx) {
        const auto p = g.position(xx, y, z);
        const double u = (p[0] - cut.centre[0]) / half;
        const double v = (p[1] - middle) / depth;
        const auto i = g.index(xx, y, z);
        const bool held = u * u + v * v < 1.0 && body.voxels[i] != 0 && taken.voxels[i] == 0;
        // Gas behind the trachea is in the oesophagus, whatever its shape.
        const bool bubble =
            gas.voxels[i] != 0 && p[1] > wall && std::abs(p[0] - cut.centre[0]) < 20.0 * s && p[1] < bone + 15.0 * s;
        if (held || bubble) out.voxels[i] = 1;
      }
    }
  }
  return out;
}

}  // namespace vallecula::pipeline
