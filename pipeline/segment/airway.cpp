#include "pipeline/segment/airway.h"

#include <algorithm>
#include <stdexcept>

namespace vallecula::pipeline {
namespace {

struct Spot {
  Vector3 centre{};
  double area_mm2 = 0.0;
};

/// Connected pieces of the lumen in an axial slice.
std::vector<Spot> spots_of(const Mask& lumen, int z) {
  const auto& g = lumen.grid;
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(g.size[0]) * g.size[1], 0);
  std::vector<Spot> spots;
  std::vector<std::array<int, 2>> piece;
  for (int y0 = 0; y0 < g.size[1]; ++y0) {
    for (int x0 = 0; x0 < g.size[0]; ++x0) {
      if (lumen.at(x0, y0, z) == 0 || seen[static_cast<std::size_t>(y0) * g.size[0] + x0] != 0) continue;
      piece.assign(1, {x0, y0});
      seen[static_cast<std::size_t>(y0) * g.size[0] + x0] = 1;
      Vector3 sum{};
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const auto [x, y] = piece[i];
        sum = sum + g.position(x, y, z);
        constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
        for (const auto& d : kSteps) {
          const int nx = x + d[0];
          const int ny = y + d[1];
          if (nx < 0 || ny < 0 || nx >= g.size[0] || ny >= g.size[1] || lumen.at(nx, ny, z) == 0) continue;
          auto& s = seen[static_cast<std::size_t>(ny) * g.size[0] + nx];
          if (s != 0) continue;
          s = 1;
          piece.push_back({nx, ny});
        }
      }
      const auto n = static_cast<double>(piece.size());
      spots.push_back({(1.0 / n) * sum, n * g.spacing[0] * g.spacing[1]});
    }
  }
  std::stable_sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.area_mm2 > b.area_mm2; });
  return spots;
}

/// The trachea followed from the lowest slice with lumen upwards: its centres, and the carina when two bronchi join.
struct Trachea {
  std::vector<Spot> spots;  ///< one a slice, upwards, single pieces only
  Vector3 carina{};
  bool carina_seen = false;
};

Trachea follow_trachea(const Mask& lumen, double s) {
  const auto& g = lumen.grid;
  Trachea t;
  for (int z = 0; z < g.size[2]; ++z) {
    const auto spots = spots_of(lumen, z);
    if (spots.empty()) continue;
    const bool two =
        spots.size() >= 2 && spots[1].area_mm2 > 0.3 * spots[0].area_mm2 &&
        std::abs(spots[0].centre[0] - spots[1].centre[0]) > std::abs(spots[0].centre[1] - spots[1].centre[1]);
    if (two && t.spots.size() * g.spacing[2] < 6.0 * s) {
      // Still two bronchi; what was taken for a trachea below them was the end of one of them.
      t.carina = 0.5 * (spots[0].centre + spots[1].centre);
      t.carina_seen = true;
      t.spots.clear();
      continue;
    }
    if (!t.spots.empty()) {
      // Follow the piece nearest to the last one; a jump means that the trachea has ended.
      const auto next = std::min_element(spots.begin(), spots.end(), [&](const Spot& a, const Spot& b) {
        return distance(a.centre, t.spots.back().centre) < distance(b.centre, t.spots.back().centre);
      });
      if (distance(next->centre, t.spots.back().centre) > 4.0 * s + g.spacing[2]) break;
      t.spots.push_back(*next);
    } else {
      t.spots.push_back(spots.front());
    }
    if (t.spots.size() * g.spacing[2] > 30.0 * s) break;
  }
  return t;
}

/// Least-squares direction of the centres of a range, pointing from the first to the last.
Vector3 direction_of(const std::vector<Section>& course, std::size_t from) {
  Vector3 mean{};
  const auto n = static_cast<double>(course.size() - from);
  for (std::size_t i = from; i < course.size(); ++i) mean = mean + (1.0 / n) * course[i].centre;
  Vector3 d{};
  for (std::size_t i = from; i < course.size(); ++i) {
    d = d + (static_cast<double>(i - from) - 0.5 * (n - 1.0)) * (course[i].centre - mean);
  }
  return unit(d);
}

std::vector<Section> follow_upwards(const Volume<float>& air, const Trachea& trachea, double s) {
  const double step = 0.4 * s;
  std::vector<Section> course;
  // Start a little above the carina, where the tube is round.
  const std::size_t first = std::min(trachea.spots.size() - 1, static_cast<std::size_t>(5.0 * s / air.grid.spacing[2]));
  const std::size_t second = trachea.spots.size() - 1;
  Vector3 d = unit(trachea.spots[second].centre - trachea.spots[first].centre);
  if (!(d[2] > 0.3)) d = {0.0, 0.0, 1.0};
  Vector3 at = trachea.spots[first].centre;
  std::vector<double> areas;
  for (int k = 0; k < 400; ++k) {
    const auto section = section_of(air, at, d, 0.25 * s, 14.0 * s);
    if (!section.found) break;
    areas.push_back(section.area_mm2);
    auto sorted = areas;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    // The pharynx is several times as wide as the trachea.
    if (areas.size() > 10 && section.area_mm2 > 4.0 * sorted[sorted.size() / 2]) break;
    course.push_back(section);
    const std::size_t back = static_cast<std::size_t>(6.0 * s / step);
    if (course.size() > back) {
      auto fresh = direction_of(course, course.size() - back);
      fresh[0] = 0.0;  // the airway's course lies in the plane of symmetry
      d = unit(0.8 * d + 0.2 * unit(fresh));
    }
    at = section.centre + step * d;
  }
  return course;
}

/// The first narrow place above the trachea: the least area before it opens again. Its plane is across the trachea: the
/// cords slant as the trachea does, and the plane of least area would follow every bulge of the vestibule.
Section find_glottis(const Volume<float>& air, const std::vector<Section>& course, double s,
                     const AirwayHints& hints) {
  const auto& close_to = hints.cords_near ? hints.cords_near : hints.cords_at;
  std::vector<double> areas;
  for (const auto& cut : course) areas.push_back(cut.area_mm2);
  auto lower = std::vector<double>(areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>((areas.size() + 1) / 2));
  std::nth_element(lower.begin(), lower.begin() + lower.size() / 2, lower.end());
  const double trachea = lower[lower.size() / 2];
  std::size_t narrowest = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (areas[i] < areas[narrowest]) narrowest = i;
    if (areas[narrowest] < 0.85 * trachea && areas[i] > 1.6 * areas[narrowest]) break;
  }
  if (close_to) {
    const auto away = [&](std::size_t i) { return distance(course[i].centre, *close_to); };
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      if (away(i) < away(nearest)) nearest = i;
    }
    if (away(nearest) > 10.0 * s)
      throw std::runtime_error("the larynx's seed is not near the airway between trachea and pharynx");
    narrowest = nearest;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      if (away(i) < away(nearest) + 4.0 * s && areas[i] < areas[narrowest]) narrowest = i;
    }
  }
  Vector3 axis{};
  for (std::size_t i = 0; i <= narrowest * 2 / 3; ++i) axis = axis + course[i].normal;
  axis = unit(axis);
  if (hints.cords_at && !hints.cords_near) return section_of(air, *hints.cords_at, axis, 0.2 * s, 14.0 * s);
  Section best;
  best.area_mm2 = 1e30;
  const std::size_t near = 8;
  for (std::size_t i = narrowest - std::min(near, narrowest); i < std::min(narrowest + near, course.size()); ++i) {
    const auto section = section_of(air, course[i].centre, axis, 0.2 * s, 14.0 * s);
    if (section.found && section.area_mm2 < best.area_mm2) best = section;
  }
  if (!best.found) return best;
  // The narrowest cut lies within the cords' thickness; the glottis is their upper border, where the lumen is an eighth
  // wider.
  const double narrow = best.area_mm2;
  const double step = 0.1 * s;
  for (int k = 1; k <= 20; ++k) {
    const auto above = section_of(air, best.centre + step * axis, axis, 0.2 * s, 14.0 * s);
    if (!above.found || above.area_mm2 > 1.125 * narrow) break;
    best = above;
  }
  return best;
}

/// Where the cords meet: the slit's width, carried forwards in a straight line from its wide part to nothing. The
/// scanner's blur hides the narrow end.
Vector3 where_cords_meet(const Volume<float>& air, const Section& glottis, const Vector3& seen_front,
                         const Vector3& back, double s) {
  const auto [aside, unused] = across(glottis.normal);
  (void)unused;
  const auto forwards = unit(seen_front - back);
  const double length = distance(seen_front, back);
  const double step = 0.05 * s;
  std::vector<std::array<double, 2>> widths;  // way from the back, width
  double widest = 0.0;
  for (double way = 0.0; way < length; way += 0.1 * s) {
    const auto middle = back + way * forwards;
    double width = 0.0;
    for (const double side : {-1.0, 1.0}) {
      double off = 0.0;
      while (off < 6.0 * s && value_at(air, middle + (side * off) * aside) > 0.0) off += step;
      width += off;
    }
    widths.push_back({way, width});
    widest = std::max(widest, width);
  }
  double n = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (const auto& [way, width] : widths) {
    if (way < 0.25 * length || width < 0.3 * widest || width > 0.85 * widest) continue;
    n += 1.0;
    x += way;
    y += width;
    xx += way * way;
    xy += way * width;
  }
  const double spread = n * xx - x * x;
  if (n < 4.0 || !(spread > 0.0)) return seen_front;
  const double slope = (n * xy - x * y) / spread;
  if (!(slope < 0.0)) return seen_front;
  const double meet = x / n - y / n / slope;
  return back + std::clamp(meet, length, length + 1.6 * s) * forwards;
}

}  // namespace

Volume<float> air_field(const Hounsfield& hu, const Thresholds& t) {
  Volume<float> field(hu.grid);
  const auto per_mm = static_cast<float>(1.0 / 700.0);
  for (std::size_t i = 0; i < field.voxels.size(); ++i)
    field.voxels[i] = (static_cast<float>(t.air) - hu.voxels[i]) * per_mm;
  return field;
}

namespace {

/// The lumen's outline in the glottis's plane, and its middle.
void outline_glottis(Airway& airway, const Volume<float>& air, double s) {
  airway.glottis_outline = outline_of(air, airway.glottis, 32, 14.0 * s);
  // The centre lies half way between the front and the back commissure, not at the centroid of a triangle.
  const auto by_y = [](const Vector3& a, const Vector3& b) { return a[1] < b[1]; };
  const auto [front, back] = std::minmax_element(airway.glottis_outline.begin(), airway.glottis_outline.end(), by_y);
  *front = where_cords_meet(air, airway.glottis, *front, *back, s);
  airway.front_commissure = *front;
  airway.glottis.centre = 0.5 * (*front + *back);
}

Mask lumen_of(const Mask& gas, const AirwayHints& hints, double s) {
  if (hints.lumen) return *hints.lumen;
  const auto& g = gas.grid;
  const auto parts = components(gas);
  int piece = 1;
  if (hints.seed) {
    piece = piece_at(parts, *hints.seed, 3.0 * s);
    if (piece == 0) throw std::runtime_error("the airway's seed lies in tissue; give a point in its air");
  }
  const auto id = static_cast<std::size_t>(piece);
  if (parts.sizes.size() <= id || parts.sizes[id] * g.voxel_mm3() < 300.0 * s * s * s) {
    throw std::runtime_error(
        "no airway was found: nose and mouth, throat or windpipe are missing (the series may show the brain alone or "
        "another part of the body, cut off the face, or end above the chin); name a CT that shows the whole face and "
        "reaches from above the palate to below the larynx");
  }
  return parts.mask(piece);
}

}  // namespace

void place_glottis(Airway& airway, const Volume<float>& air, const Vector3& centre, const Vector3& normal, double s) {
  const auto section = section_of(air, centre, unit(normal), 0.2 * s, 14.0 * s);
  if (!section.found)
    throw std::runtime_error(
        "the glottis given does not lie in a narrow part of the airway; move glottis_centre into the air between the "
        "cords");
  airway.glottis = section;
  outline_glottis(airway, air, s);
  airway.glottis.centre = centre;
}

Airway find_airway(const Volume<float>& air, const Head& head, const Frame& frame, const AirwayHints& hints) {
  const double s = frame.scale;
  const auto gas = without(head.inside, head.body);
  Airway airway;
  airway.lumen = lumen_of(gas, hints, s);
  airway.other_gas = without(gas, airway.lumen);
  const auto extent = bounds_of(airway.lumen);
  // What is missing when the course cannot be made out: said once, for both ways in which it may fail.
  const std::string unseen = extent.low[2] == 0 ? "the series ends above the glottis or just below it; name a CT that "
                                                  "reaches 1 cm below the larynx or further"
                                                : "the windpipe cannot be followed up to the larynx (is a tube, or "
                                                  "what was swallowed, in the way?); name a CT "
                                                  "that shows the whole airway";
  const auto trachea = follow_trachea(airway.lumen, s);
  if (trachea.spots.size() < 4) throw std::runtime_error(unseen);
  airway.course = follow_upwards(air, trachea, s);
  if (airway.course.size() < 12) throw std::runtime_error(unseen);
  airway.glottis = find_glottis(air, airway.course, s, hints);
  if (!airway.glottis.found) throw std::runtime_error(unseen);
  outline_glottis(airway, air, s);
  airway.carina_seen = trachea.carina_seen;
  if (trachea.carina_seen) {
    airway.carina = trachea.carina;
  } else {
    // Cords to carina is 50 mm in the term newborn (CLINICAL, vocal fold to carina); carried on along the trachea.
    // A short piece of it says little about its direction: the design's stands in for what is missing.
    const auto seen = airway.course.front().centre - airway.glottis.centre;
    const double trust = std::clamp(norm(seen) / (15.0 * s), 0.0, 1.0);
    const auto down = unit(trust * unit(seen) + (1.0 - trust) * Vector3{0.0, 0.292, -0.956});
    airway.carina = airway.glottis.centre + (50.4 * s) * down;
  }
  return airway;
}

}  // namespace vallecula::pipeline
