#include "pipeline/segment/mouth_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vallecula::pipeline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// The jaw's bone near the middle: its ridge, its lowest point, and the hindmost place in between.
struct Symphysis {
  bool seen = false;
  double crest_z = -1e30;
  double menton_z = 1e30;
  double inner_y = -1e30;
};

Symphysis symphysis_of(const Mask& mandible, const Frame& frame) {
  const auto& g = mandible.grid;
  const auto box =
      box_between(g, {frame.mid_x - 3.0 * frame.scale, -1e6, -1e6}, {frame.mid_x + 3.0 * frame.scale, 1e6, 1e6});
  Symphysis s;
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      for (int x = box.low[0]; x <= box.high[0]; ++x) {
        if (mandible.at(x, y, z) == 0) continue;
        const auto p = g.position(x, y, z);
        s.seen = true;
        s.crest_z = std::max(s.crest_z, p[2]);
        s.menton_z = std::min(s.menton_z, p[2]);
        s.inner_y = std::max(s.inner_y, p[1]);
      }
    }
  }
  return s;
}

/// Lowest bone of a column between two heights; kNone without.
double underside(const Mask& skull, int x, int y, double from_z, double to_z) {
  const auto& g = skull.grid;
  const int low = std::max(0, static_cast<int>(std::ceil((from_z - g.origin[2]) / g.spacing[2])));
  for (int z = low; z < g.size[2] && g.origin[2] + z * g.spacing[2] < to_z; ++z) {
    if (skull.at(x, y, z) != 0) return g.origin[2] + z * g.spacing[2] - 0.5 * g.spacing[2];
  }
  return kNone;
}

/// Inner surface of the jaws' arches as seen from the middle of the mouth: distances of the first bone in each
/// direction of each axial slice. Between the gums, where a ray meets none, the lower arch' own distance holds.
class Arches {
 public:
  Arches(const Mask& skull, const Mask& mandible, double mid_x, double back_y, double k)
      : grid_(skull.grid), mid_x_(mid_x), back_y_(back_y), hits_(static_cast<std::size_t>(grid_.size[2]) * kRays, kNone) {
    const double step = 0.5 * std::min(grid_.spacing[0], grid_.spacing[1]);
    std::vector<std::vector<double>> by_ray(kRays);
    for (int z = 0; z < grid_.size[2]; ++z) {
      const double pz = grid_.origin[2] + z * grid_.spacing[2];
      for (int ray = 0; ray < kRays; ++ray) {
        const double angle = angle_of(ray);
        for (double r = 4.0 * k; r < 48.0 * k; r += step) {
          const auto c = grid_.nearest({mid_x_ + r * std::sin(angle), back_y_ - r * std::cos(angle), pz});
          if (!grid_.contains(c[0], c[1], z)) break;
          const auto i = grid_.index(c[0], c[1], z);
          if (skull.voxels[i] == 0 && mandible.voxels[i] == 0) continue;
          hits_[static_cast<std::size_t>(z) * kRays + ray] = r;
          if (mandible.voxels[i] != 0) by_ray[ray].push_back(r);
          break;
        }
      }
    }
    // The arch itself is what rays of all heights meet nearest; the rami stand farther out.
    for (int ray = 0; ray < kRays; ++ray) {
      auto& r = by_ray[ray];
      if (r.empty()) continue;
      std::nth_element(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(r.size() / 4), r.end());
      usual_[ray] = r[r.size() / 4];
    }
  }
  /// How far inside of the arches a point of slice z is, mm.
  double depth(const Vector3& p, int z, double over_gum) const {
    const double dx = p[0] - mid_x_;
    const double dy = back_y_ - p[1];
    const double f = (std::atan2(dx, dy) / kOpening + 1.0) * 0.5 * (kRays - 1);
    if (f < 0.0 || f > kRays - 1) return kNone;  // behind: the arches do not bound it
    const int ray = static_cast<int>(std::lround(f));
    // What stands well inside of the arch is the roof, which is asked for elsewhere.
    const double hit = hits_[static_cast<std::size_t>(z) * kRays + ray];
    const double wall = hit < 0.6 * usual_[ray] ? usual_[ray] + over_gum : std::min(hit, usual_[ray] + over_gum);
    return wall - std::hypot(dx, dy);
  }

 private:
  static constexpr int kRays = 91;
  static constexpr double kOpening = 1.5;  ///< rad to either side of straight forwards
  static double angle_of(int ray) { return (2.0 * ray / (kRays - 1) - 1.0) * kOpening; }
  Grid grid_;
  double mid_x_;
  double back_y_;
  std::vector<double> hits_;
  std::array<double, kRays> usual_ = [] {
    std::array<double, kRays> none{};
    none.fill(kNone);
    return none;
  }();
};

/// Per slice the y of the pharynx' front wall in the middle; kNone where there is no airway.
std::vector<double> front_wall(const Mask& lumen, double mid_x, double half_mm, double from_y) {
  const auto& g = lumen.grid;
  std::vector<double> wall(g.size[2], kNone);
  const auto box = box_between(g, {mid_x - half_mm, from_y, -1e6}, {mid_x + half_mm, 1e6, 1e6});
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1] && wall[z] == kNone; ++y) {
      for (int x = box.low[0]; x <= box.high[0]; ++x) {
        if (lumen.at(x, y, z) != 0) wall[z] = g.origin[1] + (y - 0.5) * g.spacing[1];
      }
    }
  }
  return wall;
}

}  // namespace

Roof find_roof(const Mask& skull, const Mask& mandible, const Frame& frame) {
  const auto& g = skull.grid;
  const double k = frame.scale;
  Roof roof;
  const auto chin = symphysis_of(mandible, frame);
  if (!chin.seen || count(skull) == 0) return roof;
  // Against single columns that miss (a suture, a canal) the lowest of those near the middle counts.
  const auto box = box_between(g, {frame.mid_x - 3.0 * k, -1e6, -1e6}, {frame.mid_x + 3.0 * k, 1e6, 1e6});
  const auto at = [&](int y) {
    double low = kNone;
    for (int x = box.low[0]; x <= box.high[0]; ++x)
      low = std::min(low, underside(skull, x, y, chin.crest_z + 1.0, chin.crest_z + 32.0 * k));
    return low;
  };
  const int start = std::clamp(g.nearest({0, chin.inner_y + 6.0 * k, 0})[1], 0, g.size[1] - 1);
  const double over = at(start);
  if (over == kNone) return roof;
  const auto follow = [&](int step) {
    const int gap = std::max(1, static_cast<int>(std::lround(1.5 * k / g.spacing[1])));
    int last = start;
    double height = over;
    for (int y = start + step; y >= 0 && y < g.size[1] && std::abs(y - last) <= gap; y += step) {
      const double here = at(y);
      if (here == kNone || std::abs(here - height) > 2.5 * k + g.spacing[2]) continue;
      last = y;
      height = here;
    }
    return Vector3{frame.mid_x, g.origin[1] + last * g.spacing[1], height};
  };
  roof.front = follow(-1);
  roof.back = follow(1);
  roof.seen = roof.back[1] - roof.front[1] > 12.0 * k;
  return roof;
}

MouthBounds bound_mouth(const Mask& body, const Mask& lumen, const Mask& skull, const Mask& mandible, const Mask& hyoid,
                        const Airway& airway, const Epiglottis& epiglottis, const Frame& frame) {
  const auto& g = body.grid;
  const double k = frame.scale;
  MouthBounds out;
  out.tongue = Mask(g);
  out.soft_palate = Mask(g);
  const auto chin = symphysis_of(mandible, frame);
  const auto roof = find_roof(skull, mandible, frame);
  if (!chin.seen || !roof.seen) return out;
  out.crest_z = chin.crest_z;
  const auto wall = front_wall(lumen, frame.mid_x, 6.0 * k, chin.inner_y + 10.0 * k);
  const auto wall_at = [&](double z) {
    const int c = std::clamp(g.nearest({0, 0, z})[2], 0, g.size[2] - 1);
    return wall[c];
  };

  // The hyoid's upper edge; without one, where the term infant has it above the front commissure.
  Vector3 hyoid_top = airway.front_commissure + k * Vector3{0.0, -7.0, 10.0};
  if (count(hyoid) > 0) {
    const auto box = bounds_of(hyoid);
    hyoid_top = {frame.mid_x, 0.0, g.origin[2] + box.high[2] * g.spacing[2]};
    double sum = 0.0;
    double n = 0.0;
    for (std::size_t i = 0; i < g.count(); ++i) {
      const auto p = g.position(i);
      if (hyoid.voxels[i] == 0 || std::abs(p[0] - airway.glottis.centre[0]) > 6.0 * k) continue;
      sum += p[1];
      n += 1.0;
    }
    hyoid_top[1] = n > 0.0 ? sum / n : g.origin[1] + box.low[1] * g.spacing[1];
  }
  // The floor's muscles take the lower part of the chin's inner face: up to the spines that hold the tongue's own.
  const Vector3 spine{frame.mid_x, chin.inner_y, chin.menton_z + 0.5 * (chin.crest_z - chin.menton_z)};
  const double slope = (hyoid_top[2] - spine[2]) / std::max(1.0, hyoid_top[1] - spine[1]);
  const double uvula_z = roof.back[2] - 18.2 * k;
  const double middle_y = wall_at(chin.crest_z) != kNone ? wall_at(chin.crest_z) : airway.glottis.centre[1];
  const Arches arches(skull, mandible, frame.mid_x, middle_y - 2.0 * k, k);
  const auto to_lumen = distance_to(lumen);

  // Lowest bone over each column: the roof and the upper gum's inner side.
  std::vector<double> top(static_cast<std::size_t>(g.size[0]) * g.size[1], kNone);
  for (int y = 0; y < g.size[1]; ++y) {
    for (int x = 0; x < g.size[0]; ++x)
      top[static_cast<std::size_t>(y) * g.size[0] + x] =
          underside(skull, x, y, chin.crest_z + 1.0, roof.front[2] + 14.0 * k);
  }
  for (int z = 0; z < g.size[2]; ++z) {
    // Over the bone's end the lumen is that of the nose.
    const double back = wall_at(std::min(g.origin[2] + z * g.spacing[2], roof.back[2] - g.spacing[2]));
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        const auto i = g.index(x, y, z);
        if (body.voxels[i] == 0 || skull.voxels[i] != 0 || mandible.voxels[i] != 0 || hyoid.voxels[i] != 0) continue;
        const auto p = g.position(x, y, z);
        const double side = std::abs(p[0] - frame.mid_x);
        const bool behind_bone = p[1] > roof.back[1] - 1.0 * k;
        // The soft palate: 4 mm (term) of what lies before the airway, from the bone's end as far down as it is long.
        if (behind_bone && p[2] > uvula_z && p[2] < roof.back[2] + 2.0 * k && to_lumen.voxels[i] < 3.6 * k &&
            side < 11.0 * k * std::clamp((p[2] - uvula_z) / (12.0 * k) + 0.25, 0.0, 1.0) && back != kNone &&
            p[1] < back + 3.0 * k) {
          out.soft_palate.voxels[i] = 1;
          continue;
        }
        const double roof_z = std::min(top[static_cast<std::size_t>(y) * g.size[0] + x],
                                       behind_bone ? roof.back[2] - 0.45 * (p[1] - roof.back[1]) : kNone);
        if (p[2] > std::min(roof_z, roof.front[2] + 9.0 * k) - 0.6 * k) continue;
        if (back == kNone || p[1] > back) continue;
        // As wide as the arches in front; towards the throat it is round, towards the hyoid narrower.
        const double rounding = std::clamp((p[1] - back) / (15.0 * k) + 14.0 / 15.0, 0.0, 1.0);
        const double root = std::clamp((chin.crest_z - p[2]) / std::max(1.0, chin.crest_z - hyoid_top[2]), 0.0, 1.0);
        const double half = (13.0 - 3.0 * root) * k * std::sqrt(1.0 - rounding * rounding);
        if (side > half || arches.depth(p, z, 2.0 * k) < 0.8 * k) continue;
        double floor = hyoid_top[2] + 2.0 * k;
        if (p[1] < hyoid_top[1]) {
          floor = spine[2] + slope * (p[1] - spine[1]);
        } else if (epiglottis.seen) {
          // Behind the hyoid down to where the leaf is held: tongue and leaf are one body there.
          floor = std::min(floor, epiglottis.vallecula[2] + 0.4 * k);
        }
        if (p[2] < floor + 1.1 * std::max(0.0, side - 4.0 * k)) continue;
        out.tongue.voxels[i] = 1;
      }
    }
  }
  out.tongue = largest_component(out.tongue);
  out.found = static_cast<double>(count(out.tongue)) * g.voxel_mm3() > 1500.0 * k * k * k;
  return out;
}

}  // namespace vallecula::pipeline
