#include "pipeline/segment/tube_course.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {
namespace {

constexpr double kWallReach = 1.4;  // mm: the blurred wall's crest lies this near to its inner border
constexpr double kGap = 4.0;        // mm: a tube is carried on over so much that does not look like one

}  // namespace

double median(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

TubeFinder::TubeFinder(const Volume<float>& hu, const Thresholds& t, const TubeKind& kind)
    : hu_(hu),
      air_hu_(t.air),
      kind_(kind),
      blur_(std::max(0.8, 1.6 * std::max(hu.grid.spacing[0], hu.grid.spacing[1]))),
      drop_(std::max(150.0, 5.0 * t.noise)),
      hollow_(std::max(100.0, 5.0 * t.noise)) {}

double TubeFinder::value(const Vector3& p) const { return value_at(hu_, p); }

TubeFinder::Ray TubeFinder::ray(const Vector3& from, const Vector3& way) const {
  Ray out;
  // The blur leaves lumen and wall of a fine tube at any grey value: what counts is that one is darker than the other.
  const bool capillary = kind_.hollow && kind_.fine;
  const double middle = value(from);
  double r = 0.0;
  if (capillary) {
    if (middle > kind_.lumen_hu) return out;
  } else if (kind_.hollow) {
    while (r < kind_.largest_inner && value(from + r * way) < kind_.lumen_hu) r += kTubeRayStep;
    if (r >= kind_.largest_inner || r < kind_.least_inner) return out;
  }
  out.inner = r;
  out.peak = -1e9;
  for (; r < out.inner + kWallReach; r += kTubeRayStep) {
    const double v = value(from + r * way);
    if (v > out.peak) {
      out.peak = v;
      out.crest = r;
    } else if (v < out.peak - (capillary ? hollow_ : drop_)) {
      break;
    }
  }
  out.after = out.peak;
  for (r = out.crest; r < out.crest + kWallReach; r += kTubeRayStep)
    out.after = std::min(out.after, value(from + r * way));
  if (!capillary) {
    out.wall = out.peak > kind_.lumen_hu + 150.0;
    return out;
  }
  out.wall = out.peak > middle + hollow_;
  while (out.inner < out.crest && value(from + out.inner * way) < 0.5 * (middle + out.peak))
    out.inner += 0.5 * kTubeRayStep;
  return out;
}

/// From the crest outwards, half way down.
double TubeFinder::half_way_out(const Vector3& from, const Vector3& way, const Ray& r) const {
  double at = r.crest;
  while (at < r.crest + kWallReach && value(from + at * way) > 0.5 * (r.peak + r.after)) at += 0.5 * kTubeRayStep;
  return at;
}

/// What the radius is told by.
double TubeFinder::border(const Vector3& from, const Vector3& way, const Ray& r) const {
  return kind_.hollow ? r.inner : half_way_out(from, way, r);
}

/// The wall's outer side: half the width at half height is more than half the wall, by the blur.
double TubeFinder::outside(const Vector3& from, const Vector3& way, const Ray& r) const {
  const double out = half_way_out(from, way, r);
  if (!kind_.hollow) return out;
  const auto half_wall = [&](double half_width) {
    return std::clamp(std::sqrt(std::max(0.0, half_width * half_width - 0.25 * blur_ * blur_)), 0.15, 0.6);
  };
  if (kind_.fine) return r.crest + half_wall(out - r.crest);
  double in = r.crest;
  while (in > 0.0 && value(from + in * way) > 0.5 * (r.peak - 1000.0)) in -= 0.5 * kTubeRayStep;
  return 0.5 * (in + out) + half_wall(0.5 * (out - in));
}

bool TubeFinder::cut(const Vector3& at, const Vector3& direction, double radius, int rays, TubeCut& out) const {
  const auto [u, v] = across(direction);
  out = TubeCut();
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
      if (seen[k].wall && (kind_.hollow || is_thin(seen[k]))) radii.push_back(border(out.centre, way[k], seen[k]));
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
      if (!seen[k].wall || (!kind_.hollow && !is_thin(seen[k]))) continue;
      const double r = border(out.centre, way[k], seen[k]);
      off = off + (2.0 / rays * std::clamp(r - middle, -0.6, 0.6)) * way[k];
      // A last turn judges; the ones before bring the middle to the middle.
      if (std::abs(r - middle) > (turn + 1 < turns || turns == 1 ? 2.0 : 1.0) * within) continue;
      ++agreed;
      out.radius += r;
      peaks.push_back(seen[k].peak);
      if (!is_thin(seen[k])) continue;
      ++thin;
      bare += seen[k].after < air_hu_ ? 1 : 0;
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

std::vector<TubeCut> TubeFinder::follow(const TubeCut& start, const Vector3& direction) const {
  std::vector<TubeCut> all;
  for (const double way : {-1.0, 1.0}) {
    auto part = follow_one_way(start, way * direction);
    if (way < 0.0) std::reverse(part.begin(), part.end());
    all.insert(all.end(), part.begin(), part.end());
    if (way < 0.0) all.push_back(start);
  }
  return all;
}

std::vector<TubeCut> TubeFinder::follow_one_way(const TubeCut& start, Vector3 direction) const {
  std::vector<TubeCut> cuts{start};
  std::size_t good = 1;
  Vector3 at = start.centre;
  for (double gap = 0.0; gap <= kGap && cuts.size() < 1000;) {
    at = at + kTubeStep * direction;
    const auto c = hu_.grid.nearest(at);
    if (!hu_.grid.contains(c[0], c[1], c[2])) break;
    TubeCut next;
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
      next = TubeCut();
      next.centre = at;
      gap += kTubeStep;
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

}  // namespace vallecula::pipeline
