#include "pipeline/segment/epiglottis.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vallecula::pipeline {
namespace {

/// Thickness over its measure along y: the leaf leans back by about 40 degrees.
constexpr double kAcross = 0.77;

/// Tissue with airway within `reach_mm` on both sides along y: a standing sheet. Returns its depth in voxels in
/// `depth`.
Mask standing_sheet(const Mask& body, const Mask& lumen, double reach_mm) {
  const auto& g = body.grid;
  const int reach = static_cast<int>(std::floor(reach_mm / g.spacing[1]));
  Mask sheet(g);
  for (int z = 0; z < g.size[2]; ++z) {
    for (int x = 0; x < g.size[0]; ++x) {
      int first = -1;
      for (int y = 0; y < g.size[1]; ++y) {
        if (lumen.at(x, y, z) != 0) {
          if (first >= 0 && y - first <= reach) {
            for (int k = first; k < y; ++k) sheet.at(x, k, z) = body.at(x, k, z);
          }
          first = y + 1;
        } else if (body.at(x, y, z) == 0) {
          first = -1;
        }
      }
    }
  }
  return sheet;
}

/// In each sagittal slice near the middle, the lowest airway in front of the leaf.
bool find_vallecula(const Mask& leaf, const Mask& lumen, const Frame& frame, Vector3& vallecula) {
  const auto& g = leaf.grid;
  Vector3 sum{};
  int slices = 0;
  for (int x = 0; x < g.size[0]; ++x) {
    if (std::abs(g.origin[0] + x * g.spacing[0] - frame.mid_x) > 2.5 * frame.scale) continue;
    // Down along the front face of the leaf while there is airway directly in front of it.
    bool found = false;
    for (int z = 0; z < g.size[2] && !found; ++z) {
      for (int y = 1; y < g.size[1] && !found; ++y) {
        if (leaf.at(x, y, z) == 0 || lumen.at(x, y - 1, z) == 0) continue;
        int front = y - 1;
        while (front > 0 && lumen.at(x, front - 1, z) != 0) --front;
        sum = sum + g.position(x, 0.5 * (front + y - 1), z);
        ++slices;
        found = true;
      }
    }
  }
  if (slices == 0) return false;
  vallecula = (1.0 / slices) * sum;
  vallecula[0] = frame.mid_x;
  return true;
}

}  // namespace

Epiglottis measured_epiglottis(const Mask& leaf, const Mask& lumen, const Frame& frame) {
  Epiglottis e;
  e.mask = leaf;
  const auto& g = leaf.grid;
  const auto box = bounds_of(leaf);
  if (box.empty()) return e;
  e.seen = true;
  const int half = (box.low[2] + box.high[2]) / 2;
  std::size_t voxels = 0;
  std::size_t columns = 0;
  int tips = 0;
  for (int z = half; z <= box.high[2]; ++z) {
    for (int x = box.low[0]; x <= box.high[0]; ++x) {
      std::size_t here = 0;
      for (int y = box.low[1]; y <= box.high[1]; ++y) {
        if (leaf.at(x, y, z) == 0) continue;
        ++here;
        if (z < box.high[2]) continue;
        e.tip = e.tip + g.position(x, y, z);
        ++tips;
      }
      voxels += here;
      columns += here > 0 ? 1 : 0;
    }
  }
  e.tip = (1.0 / tips) * e.tip;
  e.tip[0] = frame.mid_x;
  e.thickness_mm = kAcross * g.spacing[1] * static_cast<double>(voxels) / static_cast<double>(columns);
  if (!find_vallecula(leaf, lumen, frame, e.vallecula)) {
    // No air in front of it: the leaf lies against the tongue, and the pit is at its foot.
    e.vallecula = g.position(0, box.low[1], box.low[2]);
    e.vallecula[0] = frame.mid_x;
  }
  return e;
}

Epiglottis find_epiglottis(const Mask& body, const Mask& lumen, const Airway& airway, const Frame& frame,
                           const std::optional<Vector3>& seed) {
  const auto& g = body.grid;
  const double s = frame.scale;
  const auto& glottis = airway.glottis.centre;
  Epiglottis e;
  e.mask = Mask(g);

  auto sheet = all_of(any_of(standing_sheet(body, lumen, 3.2 * s), without(closed(lumen, 1.5 * s), lumen)), body);
  const double floor_z = airway.front_commissure[2] + 2.0 * s;
  for (std::size_t i = 0; i < sheet.voxels.size(); ++i) {
    if (sheet.voxels[i] == 0) continue;
    const auto p = g.position(i);
    const double above = p[2] - glottis[2];
    // Above the glottis and leaning to the back no further than its own height.
    const bool place = above > 1.5 * s && above < 22.0 * s && std::abs(p[0] - frame.mid_x) < 5.0 * s &&
                       p[1] < glottis[1] + 0.6 * above && p[1] > airway.front_commissure[1] - 4.0 * s;
    sheet.voxels[i] = place && p[2] > floor_z ? 1 : 0;
  }
  const auto parts = components(sheet);
  int best = seed ? piece_at(parts, *seed, 3.0 * s) : 0;
  if (seed && best == 0)
    throw std::runtime_error(
        "the epiglottis's seed lies in no sheet with air before and behind it; draw it and give it as a label map");
  double best_score = 0.0;
  for (std::size_t id = 1; id < parts.sizes.size() && !seed; ++id) {
    if (parts.sizes[id] * g.voxel_mm3() < 3.0 * s * s * s) break;
    const auto part = parts.mask(static_cast<int>(id));
    const auto box = bounds_of(part);
    const double height = (box.high[2] - box.low[2]) * g.spacing[2];
    const double middle = std::abs(g.origin[0] + 0.5 * (box.low[0] + box.high[0]) * g.spacing[0] - frame.mid_x);
    const double score = middle < 3.0 * s ? height * std::cbrt(static_cast<double>(parts.sizes[id])) : 0.0;
    if (score > best_score) {
      best_score = score;
      best = static_cast<int>(id);
    }
  }
  if (best == 0) return e;
  auto leaf = parts.mask(best);
  const auto box = bounds_of(leaf);
  const double top = g.origin[2] + box.high[2] * g.spacing[2];
  if (top - glottis[2] < 6.0 * s) return e;

  // Half-width from the upper half, where no fold joins it; below it narrows to the petiole.
  std::vector<double> widths;
  Vector3 tip{};
  int tips = 0;
  std::size_t voxels = 0;
  std::size_t columns = 0;
  const double half_height = 0.5 * (top + floor_z);
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    const double pz = g.origin[2] + z * g.spacing[2];
    double widest = 0.0;
    for (int x = box.low[0]; x <= box.high[0]; ++x) {
      std::size_t here = 0;
      for (int y = box.low[1]; y <= box.high[1]; ++y) {
        if (leaf.at(x, y, z) == 0) continue;
        ++here;
        widest = std::max(widest, std::abs(g.origin[0] + x * g.spacing[0] - frame.mid_x));
        if (z == box.high[2]) {
          tip = tip + g.position(x, y, z);
          ++tips;
        }
      }
      if (here > 0 && pz > half_height) {
        voxels += here;
        ++columns;
      }
    }
    if (pz > half_height && widest > 0.0) widths.push_back(widest);
  }
  e.tip = (1.0 / tips) * tip;
  e.tip[0] = frame.mid_x;
  e.thickness_mm = columns > 0 ? kAcross * g.spacing[1] * voxels / columns : 1.5 * s;
  double half_width = 3.5 * s;
  if (!widths.empty()) {
    std::nth_element(widths.begin(), widths.begin() + widths.size() * 3 / 4, widths.end());
    half_width = std::clamp(widths[widths.size() * 3 / 4] + 0.25 * s, 1.5 * s, 5.0 * s);
  }
  if (!find_vallecula(leaf, lumen, frame, e.vallecula)) return e;

  const auto width_at = [&](double z) {
    const double f = std::clamp((z - floor_z) / std::max(1e-6, e.vallecula[2] + 3.0 * s - floor_z), 0.0, 1.0);
    return 2.4 * s + f * (half_width - 2.4 * s);
  };
  for (std::size_t i = 0; i < leaf.voxels.size(); ++i) {
    if (leaf.voxels[i] == 0) continue;
    const auto p = g.position(i);
    if (std::abs(p[0] - frame.mid_x) > width_at(p[2])) leaf.voxels[i] = 0;
  }
  // The petiole: the front wall of the vestibule at the leaf's thickness.
  const int depth = std::max(1, static_cast<int>(std::lround(e.thickness_mm / g.spacing[1])));
  for (int z = 0; z < g.size[2]; ++z) {
    const double pz = g.origin[2] + z * g.spacing[2];
    if (pz < floor_z || pz > e.vallecula[2] + 2.0 * s) continue;
    for (int x = 0; x < g.size[0]; ++x) {
      if (std::abs(g.origin[0] + x * g.spacing[0] - frame.mid_x) > width_at(pz)) continue;
      // From the axis of the vestibule forwards to its wall.
      int y = std::clamp(g.nearest({0, airway.glottis.centre[1], 0})[1], 0, g.size[1] - 1);
      while (y > 0 && lumen.at(x, y, z) == 0 && g.origin[1] + y * g.spacing[1] > airway.front_commissure[1] - s) --y;
      if (lumen.at(x, y, z) == 0) continue;
      while (y > 0 && lumen.at(x, y, z) != 0) --y;
      for (int k = 0; k < depth && y - k >= 0; ++k) {
        if (body.at(x, y - k, z) == 0) break;
        leaf.at(x, y - k, z) = 1;
      }
    }
  }
  e.mask = largest_component(leaf);
  e.seen = true;
  return e;
}

}  // namespace vallecula::pipeline
