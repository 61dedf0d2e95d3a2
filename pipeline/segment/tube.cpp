#include "pipeline/segment/tube.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vallecula::pipeline {
namespace {

// A tube's own measures, mm: they do not grow with the patient.
constexpr double kWallReach = 1.4;    // the blurred wall's crest lies this near to its inner border
constexpr double kLargest = 5.6;      // inner radius: 11 mm outside is an adult's largest tube
constexpr double kThickestRod = 2.0;  // radius of a feeding tube
constexpr double kStep = 0.5;         // between cuts along a tube
constexpr double kRayStep = 0.15;
constexpr double kLumen = -600.0;  // HU: darker is the air inside a tube
constexpr double kThinTube = 2.6;  // diameter: below it a feeding tube, above it one for the windpipe
constexpr double kGap = 4.0;       // a tube is carried on over so much that does not look like one

/// The grey values along one ray from a tube's middle, across its wall.
struct Ray {
  bool wall = false;   ///< is there anything like a wall?
  double inner = 0.0;  ///< where the wall begins
  double crest = 0.0;  ///< radius of the brightest
  double peak = 0.0;   ///< HU there
  double after = 0.0;  ///< the darkest shortly behind it, HU
};

/// One cut across a tube.
struct Cut {
  Vector3 centre{};
  double radius = 0.0;  ///< of the lumen when hollow, else outside
  double outer = 0.0;   ///< outside, without the scanner's blur
  double round = 0.0;   ///< share of the rays that agree on the radius
  double thin = 0.0;    ///< share that find it darker behind the wall
  double bare = 0.0;    ///< share that find air there
  double peak = 0.0;    ///< HU
};

double median(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class Finder {
 public:
  Finder(const Volume<float>& hu, const Thresholds& t, bool hollow) : hu_(hu), t_(t), hollow_(hollow) {
    const auto& d = hu.grid.spacing;
    blur_ = std::max(0.8, 1.6 * std::max(d[0], d[1]));
    drop_ = std::max(150.0, 5.0 * t.noise);
  }

  double blur() const { return blur_; }

  /// `radius` is the tube's when it is known, else 0.
  bool cut(const Vector3& at, const Vector3& direction, double radius, int rays, Cut& out) const {
    const auto [u, v] = across(direction);
    out = Cut();
    out.centre = at;
    const int turns = rays < kRays ? 1 : 3;
    std::array<Ray, kRays> seen;
    std::array<Vector3, kRays> way;
    for (int turn = 0; turn < turns; ++turn) {
      std::vector<double> radii;
      for (int k = 0; k < rays; ++k) {
        const double angle = 6.283185307179586 * k / rays;
        way[k] = std::cos(angle) * u + std::sin(angle) * v;
        seen[k] = ray(out.centre, way[k]);
        if (seen[k].wall && (hollow_ || is_thin(seen[k]))) radii.push_back(border(out.centre, way[k], seen[k]));
      }
      if (static_cast<int>(radii.size()) < rays / 2) return false;
      const double middle = radius > 0.0 ? radius : median(radii);
      const double within = std::max(0.3, 0.15 * middle);
      out.radius = 0.0;
      Vector3 off{};
      int agreed = 0;
      int thin = 0;
      int bare = 0;
      std::vector<double> peaks;
      std::vector<double> outers;
      for (int k = 0; k < rays; ++k) {
        if (!seen[k].wall || (!hollow_ && !is_thin(seen[k]))) continue;
        const double r = border(out.centre, way[k], seen[k]);
        off = off + (2.0 / rays * std::clamp(r - middle, -0.6, 0.6)) * way[k];
        // A last turn judges; the ones before bring the middle to the middle.
        if (std::abs(r - middle) > (turn + 1 < turns || turns == 1 ? 2.0 : 1.0) * within) continue;
        ++agreed;
        out.radius += r;
        peaks.push_back(seen[k].peak);
        if (!is_thin(seen[k])) continue;
        ++thin;
        bare += seen[k].after < t_.air ? 1 : 0;
        outers.push_back(outside(out.centre, way[k], seen[k]));
      }
      if (agreed == 0) return false;
      out.radius /= agreed;
      out.round = static_cast<double>(agreed) / rays;
      out.thin = static_cast<double>(thin) / rays;
      out.bare = static_cast<double>(bare) / rays;
      out.peak = median(peaks);
      out.outer = median(outers);
      if (turn + 1 < turns) out.centre = out.centre + off;
    }
    return true;
  }

  /// Both ways from a cut; the cuts in order. Empty when it is no tube.
  std::vector<Cut> follow(const Cut& start, const Vector3& direction) const {
    std::vector<Cut> all;
    for (const double way : {-1.0, 1.0}) {
      auto part = follow_one_way(start, way * direction);
      if (way < 0.0) std::reverse(part.begin(), part.end());
      all.insert(all.end(), part.begin(), part.end());
      if (way < 0.0) all.push_back(start);
    }
    return all;
  }

  static constexpr int kRays = 24;

 private:
  bool is_thin(const Ray& r) const { return r.peak - r.after >= drop_; }
  double value(const Vector3& p) const { return value_at(hu_, p); }

  Ray ray(const Vector3& from, const Vector3& way) const {
    Ray out;
    double r = 0.0;
    if (hollow_) {
      while (r < kLargest && value(from + r * way) < kLumen) r += kRayStep;
      if (r >= kLargest || r < 0.4) return out;
    }
    out.inner = r;
    out.peak = -1e9;
    for (; r < out.inner + kWallReach; r += kRayStep) {
      const double v = value(from + r * way);
      if (v > out.peak) {
        out.peak = v;
        out.crest = r;
      } else if (v < out.peak - drop_) {
        break;
      }
    }
    out.after = out.peak;
    for (r = out.crest; r < out.crest + kWallReach; r += kRayStep)
      out.after = std::min(out.after, value(from + r * way));
    out.wall = out.peak > kLumen + 150.0;
    return out;
  }
  /// From the crest outwards, half way down.
  double half_way_out(const Vector3& from, const Vector3& way, const Ray& r) const {
    double at = r.crest;
    while (at < r.crest + kWallReach && value(from + at * way) > 0.5 * (r.peak + r.after)) at += 0.5 * kRayStep;
    return at;
  }
  /// What the radius is told by.
  double border(const Vector3& from, const Vector3& way, const Ray& r) const {
    return hollow_ ? r.inner : half_way_out(from, way, r);
  }
  /// The wall's outer side: half the width at half height is more than half the wall, by the blur.
  double outside(const Vector3& from, const Vector3& way, const Ray& r) const {
    const double out = half_way_out(from, way, r);
    if (!hollow_) return out;
    double in = r.crest;
    while (in > 0.0 && value(from + in * way) > 0.5 * (r.peak - 1000.0)) in -= 0.5 * kRayStep;
    const double broad = out - in;
    return 0.5 * (in + out) + 0.5 * std::clamp(std::sqrt(std::max(0.0, broad * broad - blur_ * blur_)), 0.3, 1.2);
  }

  std::vector<Cut> follow_one_way(const Cut& start, Vector3 direction) const {
    std::vector<Cut> cuts{start};
    std::size_t good = 1;
    Vector3 at = start.centre;
    for (double gap = 0.0; gap <= kGap && cuts.size() < 1000;) {
      at = at + kStep * direction;
      const auto c = hu_.grid.nearest(at);
      if (!hu_.grid.contains(c[0], c[1], c[2])) break;
      Cut next;
      bool fits = false;
      const auto [u, v] = across(direction);
      for (const auto& lean : {Vector3{}, 0.3 * v, -0.3 * v, 0.3 * u, -0.3 * u}) {  // it may bend sharply
        const auto leant = unit(direction + lean);
        fits = cut(at, leant, start.radius, kRays, next) && next.round >= 0.65 && distance(next.centre, at) < 0.5;
        if (!fits) continue;
        direction = leant;
        break;
      }
      if (!fits) {
        next = Cut();
        next.centre = at;
        gap += kStep;
      } else {
        gap = 0.0;
        at = next.centre;
      }
      cuts.push_back(next);
      if (fits) good = cuts.size();
      const std::size_t back = std::min<std::size_t>(5, cuts.size() - 1);
      if (fits && back >= 3) direction = unit(at - cuts[cuts.size() - 1 - back].centre);
    }
    cuts.resize(good);
    cuts.erase(cuts.begin());
    return cuts;
  }

  const Volume<float>& hu_;
  const Thresholds& t_;
  bool hollow_;
  double blur_ = 0.8;
  double drop_ = 150.0;
};

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

/// A tube from end to end.
struct Course {
  std::vector<Cut> cuts;
  double outer = 0.0;  ///< radius
};

/// What no part of a body has: a thin wall, alike all around, over this length; for a rod also that it lies bare.
bool is_tube(const std::vector<Cut>& cuts, bool hollow, double lowest_z, double soft, Course& course) {
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
    seen += kStep;
    bare += c.bare >= 0.3 ? kStep : 0.0;
  }
  if (hollow ? seen < 15.0 : seen < 25.0 || bare < 8.0 || median(peaks) < soft + 100.0) return false;
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
    for (double q = r + kRayStep; q <= reach; q += kRayStep)
      darkest = std::min(darkest, value_at(before, s.at + q * way));
    if (darkest > t.air) darkest = std::min<double>(before.voxels[i], std::max(darkest, t.soft));
    after.voxels[i] = static_cast<float>(darkest);
  }
  paste(after, box, hu);
}

/// All tubes of one kind, taken out of `hu` one by one.
void find_kind(bool hollow, const Thresholds& t, const Frame& frame, Volume<float>& hu, std::vector<Tube>& tubes) {
  const Finder finder(hu, t, hollow);
  const double lowest_z = frame.skull_top - 135.0 * frame.scale;  // below the cords bronchi in the lung look alike
  const double bright = t.soft + 100.0;
  const auto lumen = [](float v) { return v < kLumen; };
  const auto rod = [bright](float v) { return v > bright; };
  constexpr double kLean = 0.70710678118654752;
  for (const int second : {1, 2}) {
    const auto candidates =
        hollow ? middles(hu, lumen, 2.0 * kLargest, second) : middles(hu, rod, 2.0 * kThickestRod, second);
    const Vector3 along = second == 1 ? Vector3{0, 0, 1} : Vector3{0, 1, 0};
    for (const auto i : candidates) {
      const auto p = hu.grid.position(i);
      if (p[2] < lowest_z || !(hollow ? lumen(hu.voxels[i]) : rod(hu.voxels[i]))) continue;
      for (const Vector3& direction : {along, Vector3{0, kLean, kLean}, Vector3{0, -kLean, kLean}}) {
        Cut start;
        if (!finder.cut(p, direction, 0.0, 8, start) || start.round < 0.7 || start.thin < 0.6) continue;
        if (!finder.cut(p, direction, 0.0, Finder::kRays, start) || start.round < 0.75 || start.thin < 0.7) continue;
        if (!hollow && (start.bare < 0.3 || start.radius > kThickestRod)) continue;
        Course course;
        if (!is_tube(finder.follow(start, direction), hollow, lowest_z, t.soft, course)) continue;
        Tube tube;
        tube.hollow = hollow;
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
        take_out(course, hollow && tube.diameter_mm > kThinTube, t, finder.blur(), hu);
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
  find_kind(true, t, frame, after, tubes);
  find_kind(false, t, frame, after, tubes);
  if (tubes.empty()) return tubes;
  auto part = cropped(hu, box);
  for (std::size_t i = 0; i < part.voxels.size(); ++i) {
    if (after.voxels[i] != before.voxels[i]) part.voxels[i] = static_cast<std::int16_t>(std::lround(after.voxels[i]));
  }
  paste(part, box, hu);
  return tubes;
}

std::optional<Vector3> cords_around(const std::vector<Tube>& tubes, double scale) {
  const auto cuts = [](double mm) { return static_cast<std::size_t>(std::ceil(mm / kStep)); };
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
