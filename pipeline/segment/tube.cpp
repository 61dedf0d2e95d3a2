#include "pipeline/segment/tube.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/segment/tube_course.h"

namespace vallecula::pipeline {
namespace {

// A tube's own measures, mm: they do not grow with the patient.
constexpr double kThickestRod = 2.0;  // radius of a feeding tube
constexpr double kThinTube = 2.6;     // diameter: below it a feeding tube, above it one for the windpipe
// 11 mm outside is an adult's largest tube.
constexpr TubeKind kWide{true, false, -600.0, 0.4, 5.6};
// A feeding tube full of air: the blur lifts its lumen from -1000 HU.
constexpr TubeKind kCapillary{true, true, -250.0, 0.0, 1.0};
constexpr TubeKind kRod{false, true, -600.0, 0.0, 0.0};

/// Voxels that lie in the middle of a short run of like ones along two axes: where a tube's middle may be.
template <class Test>
std::vector<std::size_t> middles(const Volume<float>& hu, const Test& in, double longest_mm, int second) {
  const auto& g = hu.grid;
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(g.size[0]),
                                          static_cast<std::size_t>(g.size[0]) * g.size[1]};
  std::vector<std::size_t> found;
  const int longest = static_cast<int>(longest_mm / g.spacing[0]);
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      const auto row = g.index(0, y, z);
      for (int x = 0; x < g.size[0];) {
        if (!in(hu.voxels[row + x])) {
          ++x;
          continue;
        }
        const int from = x;
        while (x < g.size[0] && in(hu.voxels[row + x])) ++x;
        if (x - from > longest || from == 0 || x == g.size[0]) continue;
        const auto i = row + (from + x - 1) / 2;
        const int here = second == 1 ? y : z;
        const int reach = static_cast<int>(1.5 * longest_mm / g.spacing[second]);
        int up = 0;
        int down = 0;
        while (up <= reach && here + up + 1 < g.size[second] && in(hu.voxels[i + (up + 1) * stride[second]])) ++up;
        while (down <= reach && here - down > 0 && in(hu.voxels[i - (down + 1) * stride[second]])) ++down;
        if (up + down <= reach && std::abs(up - down) <= 1) found.push_back(i);
      }
    }
  }
  return found;
}

/// Voxels darker than a limit that have brighter ones around them, a fine tube's wall away along two axes.
std::vector<std::size_t> dark_middles(const Volume<float>& hu, double below, double by, int second) {
  const auto& g = hu.grid;
  std::vector<std::size_t> found;
  std::array<int, 3> away{};
  for (int a = 0; a < 3; ++a) away[a] = std::max(1, static_cast<int>(std::lround(0.9 / g.spacing[a])));
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(g.size[0]),
                                          static_cast<std::size_t>(g.size[0]) * g.size[1]};
  for (std::size_t i = 0; i < hu.voxels.size(); ++i) {
    const float here = hu.voxels[i];
    if (here > below) continue;
    const auto c = g.cell(i);
    bool ringed = true;
    for (const int axis : {0, second}) {
      const auto step = stride[axis] * static_cast<std::size_t>(away[axis]);
      ringed = ringed && c[axis] >= away[axis] && c[axis] + away[axis] < g.size[axis] &&
               std::min(hu.voxels[i - step], hu.voxels[i + step]) > here + by;
    }
    if (ringed) found.push_back(i);
  }
  return found;
}

/// A tube from end to end.
struct Course {
  std::vector<TubeCut> cuts;
  double outer = 0.0;  ///< radius
};

/// What no part of a body has: a thin wall, alike all around, over this length; for a fine tube also that it lies bare.
bool is_tube(const std::vector<TubeCut>& cuts, const TubeKind& kind, double lowest_z, double soft, Course& course) {
  double seen = 0.0;
  double bare = 0.0;
  std::vector<double> outers;
  std::vector<double> peaks;
  for (const auto& c : cuts) {
    const bool clear = c.round >= 0.7 && c.thin >= 0.6;
    if (!clear) continue;
    outers.push_back(c.outer);
    peaks.push_back(c.peak);
    if (c.centre[2] < lowest_z) continue;
    seen += kTubeStep;
    bare += c.bare >= 0.3 ? kTubeStep : 0.0;
  }
  if (kind.fine ? seen < 25.0 || bare < 8.0 : seen < 15.0) return false;
  if (!kind.hollow && median(peaks) < soft + 100.0) return false;
  course.cuts = cuts;
  course.outer = median(outers);
  return true;
}

/// Writes what lies there without the tube. Within it: air, or soft tissue where a thin tube lies in tissue. In the
/// halo of its wall: the darkest that lies further out.
void take_out(const Course& course, bool always_air, const Thresholds& t, double blur, Volume<float>& hu) {
  const auto& g = hu.grid;
  const double air = std::min(2.0 * t.air - t.soft, -900.0);
  const double reach = course.outer + blur + 0.3;
  struct Station {
    Vector3 at;
    bool in_air;
  };
  std::vector<Station> line;
  const auto& cuts = course.cuts;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    double bare = 0.0;
    int n = 0;
    for (std::size_t j = i < 5 ? 0 : i - 5; j < std::min(cuts.size(), i + 6); ++j) {
      if (cuts[j].round == 0.0) continue;
      bare += cuts[j].bare;
      ++n;
    }
    const bool in_air = always_air || bare > 0.2 * n;
    if (i > 0) line.push_back({0.5 * (cuts[i - 1].centre + cuts[i].centre), in_air});
    line.push_back({cuts[i].centre, in_air});
  }
  // Its ends are cut askew and rounded.
  for (int k = 0; k < 4; ++k) {
    line.push_back({2.0 * line.back().at - line[line.size() - 2].at, line.back().in_air});
    line.insert(line.begin(), {2.0 * line[0].at - line[1].at, line[0].in_air});
  }
  Vector3 low = line[0].at;
  Vector3 high = low;
  for (const auto& s : line) {
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], s.at[a] - reach);
      high[a] = std::max(high[a], s.at[a] + reach);
    }
  }
  const auto box = box_between(g, low, high);
  const auto before = cropped(hu, box);
  const auto& b = before.grid;
  Volume<float> near(b, std::numeric_limits<float>::max());
  Volume<int> station(b, -1);
  for (std::size_t s = 0; s < line.size(); ++s) {
    const Vector3 span{reach, reach, reach};
    const auto around = box_between(b, line[s].at - span, line[s].at + span);
    for (int z = around.low[2]; z <= around.high[2]; ++z) {
      for (int y = around.low[1]; y <= around.high[1]; ++y) {
        for (int x = around.low[0]; x <= around.high[0]; ++x) {
          const auto i = b.index(x, y, z);
          const auto d = static_cast<float>(distance(b.position(x, y, z), line[s].at));
          if (d > reach || d >= near.voxels[i]) continue;
          near.voxels[i] = d;
          station.voxels[i] = static_cast<int>(s);
        }
      }
    }
  }
  auto after = before;
  for (std::size_t i = 0; i < b.count(); ++i) {
    if (station.voxels[i] < 0) continue;
    const auto& s = line[static_cast<std::size_t>(station.voxels[i])];
    const double r = near.voxels[i];
    if (r <= course.outer) {
      after.voxels[i] = static_cast<float>(s.in_air ? air : t.soft);
      continue;
    }
    const auto way = unit(Vector3(b.position(i)) - s.at);
    double darkest = before.voxels[i];
    for (double q = r + kTubeRayStep; q <= reach; q += kTubeRayStep)
      darkest = std::min(darkest, value_at(before, s.at + q * way));
    if (darkest > t.air) darkest = std::min<double>(before.voxels[i], std::max(darkest, t.soft));
    after.voxels[i] = static_cast<float>(darkest);
  }
  paste(after, box, hu);
}

/// All tubes of one kind, taken out of `hu` one by one: what lies beside one is seen when that one is gone.
void find_kind(const TubeKind& kind, const Thresholds& t, const Frame& frame, Volume<float>& hu,
               std::vector<Tube>& tubes) {
  const TubeFinder finder(hu, t, kind);
  const double lowest_z = frame.skull_top - 135.0 * frame.scale;  // below the cords bronchi in the lung look alike
  const double bright = t.soft + 100.0;
  const auto lumen = [&](float v) { return v < kind.lumen_hu; };
  const auto rod = [bright](float v) { return v > bright; };
  constexpr double kLean = 0.70710678118654752;
  for (const int second : {1, 2}) {
    const auto candidates = kind.hollow && kind.fine ? dark_middles(hu, kind.lumen_hu, 100.0, second)
                            : kind.hollow            ? middles(hu, lumen, 2.0 * kind.largest_inner, second)
                                                     : middles(hu, rod, 2.0 * kThickestRod, second);
    const Vector3 along = second == 1 ? Vector3{0, 0, 1} : Vector3{0, 1, 0};
    for (const auto i : candidates) {
      const auto p = hu.grid.position(i);
      if (p[2] < lowest_z || !(kind.hollow ? lumen(hu.voxels[i]) : rod(hu.voxels[i]))) continue;
      for (const Vector3& direction : {along, Vector3{0, kLean, kLean}, Vector3{0, -kLean, kLean}}) {
        TubeCut start;
        if (!finder.cut(p, direction, 0.0, 8, start) || start.round < 0.7 || start.thin < 0.6) continue;
        if (!finder.cut(p, direction, 0.0, TubeFinder::kRays, start) || start.round < 0.75 || start.thin < 0.7)
          continue;
        if (kind.fine && (start.bare < 0.3 || start.outer > kThickestRod)) continue;
        Course course;
        if (!is_tube(finder.follow(start, direction), kind, lowest_z, t.soft, course)) continue;
        Tube tube;
        tube.hollow = kind.hollow;
        tube.diameter_mm = 2.0 * course.outer;
        for (const auto& c : course.cuts) {
          tube.axis.push_back(c.centre);
          tube.bare.push_back(c.round > 0.0 || tube.bare.empty() ? c.bare : tube.bare.back());
        }
        const auto height = [](const Vector3& a) { return a[2] - a[1]; };
        if (height(tube.axis.front()) < height(tube.axis.back())) {
          std::reverse(tube.axis.begin(), tube.axis.end());
          std::reverse(tube.bare.begin(), tube.bare.end());
        }
        take_out(course, kind.hollow && tube.diameter_mm > kThinTube, t, finder.blur(), hu);
        tubes.push_back(std::move(tube));
        break;
      }
    }
  }
}

}  // namespace

std::vector<Tube> take_out_tubes(Hounsfield& hu, const Thresholds& t, const Frame& frame) {
  const double aside = 24.0 * frame.scale;
  const auto box = box_between(hu.grid, {frame.mid_x - aside, -1e6, -1e6}, {frame.mid_x + aside, 1e6, 1e6});
  const auto before = to_float(cropped(hu, box));
  auto after = before;
  std::vector<Tube> tubes;
  for (const auto& kind : {kWide, kCapillary, kRod}) find_kind(kind, t, frame, after, tubes);
  if (tubes.empty()) return tubes;
  auto part = cropped(hu, box);
  for (std::size_t i = 0; i < part.voxels.size(); ++i) {
    if (after.voxels[i] != before.voxels[i]) part.voxels[i] = static_cast<std::int16_t>(std::lround(after.voxels[i]));
  }
  paste(part, box, hu);
  return tubes;
}

std::optional<Vector3> cords_around(const std::vector<Tube>& tubes, double scale) {
  const auto cuts = [](double mm) { return static_cast<std::size_t>(std::ceil(mm / kTubeStep)); };
  for (const auto& tube : tubes) {
    if (!tube.hollow || tube.diameter_mm <= kThinTube) continue;
    const std::size_t end = tube.bare.size() - std::min(tube.bare.size(), cuts(3.0));  // the tip is open and cut askew
    std::size_t held = end;
    while (held > 0 && tube.bare[held - 1] < 0.5) --held;  // from here on down the larynx lies against it
    if (held == 0) continue;
    for (std::size_t tight = held; tight < std::min(end, held + cuts(8.0 * scale)); ++tight) {
      if (tube.bare[tight] > 0.05) continue;
      const std::size_t below = std::min(end, tight + cuts(4.0 * scale));
      const bool stays =
          below - tight >= cuts(2.0 * scale) &&
          std::all_of(tube.bare.begin() + static_cast<std::ptrdiff_t>(tight),
                      tube.bare.begin() + static_cast<std::ptrdiff_t>(below), [](double b) { return b < 0.15; });
      if (stays) return 0.5 * (tube.axis[held] + tube.axis[tight]);
    }
  }
  return std::nullopt;
}

std::string describe(const std::vector<Tube>& tubes, const Head& head, const Airway& airway, double scale) {
  std::string text;
  for (const auto& tube : tubes) {
    const auto& from = tube.axis.front();
    const auto& to = tube.axis.back();
    const char* way_in = "mouth or nose";
    if (!head.lips.empty()) way_in = from[2] < head.lips[head.lips.size() / 2].upper[1] ? "the mouth" : "the nose";
    const char* end = "the throat";
    if (dot(to - airway.glottis.centre, airway.glottis.normal) < 0.0) {
      end = "the gullet";
      for (const auto& section : airway.course) {
        if (distance(section.centre, to) < 3.5 * scale) end = "the windpipe";
      }
    }
    const auto tenths = std::to_string(std::lround(10.0 * tube.diameter_mm));
    text += (text.empty() ? "a tube of about " : "; a tube of about ") + tenths.substr(0, tenths.size() - 1) + "." +
            tenths.back() + " mm from " + way_in + " to " + end + " was taken out";
  }
  return text + "; what touched it is as it lay against it";
}

}  // namespace vallecula::pipeline
