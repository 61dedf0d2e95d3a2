// The course of a tube through grey values: cuts across it, followed from one to the next.
#pragma once

#include <vector>

#include "pipeline/segment/head.h"
#include "pipeline/segment/section.h"

namespace vallecula::pipeline {

/// What a tube looks like in a scan. Lengths are a tube's own, mm: they do not grow with the patient.
struct TubeKind {
  bool hollow = false;         ///< air inside that is seen; else a bright rod (a thin tube full of fluid)
  bool fine = false;           ///< a feeding tube: the blur joins its wall with what it encloses
  double lumen_hu = 0.0;       ///< hollow: the air inside is darker
  double least_inner = 0.0;    ///< hollow: radius at which the wall begins, at the least
  double largest_inner = 0.0;  ///< hollow: and at the most
};

/// One cut across a tube.
struct TubeCut {
  Vector3 centre{};
  double radius = 0.0;  ///< of the lumen when hollow, else outside, mm
  double outer = 0.0;   ///< outside, without the scanner's blur, mm
  double round = 0.0;   ///< share of the rays that agree on the radius; 0 where no tube was seen
  double thin = 0.0;    ///< share that find it darker behind the wall
  double bare = 0.0;    ///< share that find air there
  double peak = 0.0;    ///< HU
};

constexpr double kTubeStep = 0.5;      ///< mm between cuts along a tube
constexpr double kTubeRayStep = 0.15;  ///< mm along the rays of a cut

/// Of an unsorted list, which is left in another order; 0 for an empty one.
double median(std::vector<double>& values);

/// Cuts across tubes of one kind in `hu`, which must outlive it.
class TubeFinder {
 public:
  TubeFinder(const Volume<float>& hu, const Thresholds& t, const TubeKind& kind);

  /// Width of the scanner's blur, mm.
  double blur() const { return blur_; }
  /// The cut about a point with so many rays (kRays at the most); `radius` is the tube's when it is known, else 0.
  /// False where less than half of the rays meet a wall.
  bool cut(const Vector3& at, const Vector3& direction, double radius, int rays, TubeCut& out) const;
  /// Both ways from a cut; the cuts in order.
  std::vector<TubeCut> follow(const TubeCut& start, const Vector3& direction) const;

  static constexpr int kRays = 24;

 private:
  /// The grey values along one ray from a tube's middle, across its wall.
  struct Ray {
    bool wall = false;   ///< is there anything like a wall?
    double inner = 0.0;  ///< where the wall begins
    double crest = 0.0;  ///< radius of the brightest
    double peak = 0.0;   ///< HU there
    double after = 0.0;  ///< the darkest shortly behind it, HU
  };

  double value(const Vector3& p) const;
  bool is_thin(const Ray& r) const { return r.peak - r.after >= drop_; }
  Ray ray(const Vector3& from, const Vector3& way) const;
  double half_way_out(const Vector3& from, const Vector3& way, const Ray& r) const;
  double border(const Vector3& from, const Vector3& way, const Ray& r) const;
  double outside(const Vector3& from, const Vector3& way, const Ray& r) const;
  std::vector<TubeCut> follow_one_way(const TubeCut& start, Vector3 direction) const;

  const Volume<float>& hu_;
  double air_hu_;
  TubeKind kind_;
  double blur_;
  double drop_;    ///< HU by which it is darker behind a wall
  double hollow_;  ///< HU by which a fine tube's lumen is darker than its wall
};

}  // namespace vallecula::pipeline
