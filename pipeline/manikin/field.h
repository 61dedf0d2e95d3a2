// Smooth implicit shapes: signed distances (mm, negative inside) that blend. Close to Euclidean near the surface, and
// nowhere steeper than kSteepest, so that the sign of a whole block follows from its centre.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace vallecula::pipeline::manikin {

/// LPS millimetres.
struct Vec {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};
inline Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec& a) { return std::sqrt(dot(a, a)); }

/// A point of a plane: usually the mid-sagittal one (y, z), for the gum arches the plan (x, y).
struct Flat {
  double u = 0.0;
  double v = 0.0;
};

/// Largest gradient of any shape below unless it names its own; the voxeliser's block test relies on it.
constexpr double kSteepest = 1.7;
constexpr double kGentle = 1.2;  ///< that of the large ones: skin and bones

/// Polynomial smooth minimum: equal to min where |a - b| >= k, at most k/4 below it.
inline double blend(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * k * 0.25;
}
inline double carve(double a, double b, double k) { return -blend(-a, b, k); }  ///< a without b
inline double meet(double a, double b, double k) { return -blend(-a, -b, k); }  ///< common to a and b

/// Intersection of two half spaces whose common edge is rounded with radius r; exact on both faces away from the edge.
inline double rounded(double a, double b, double r) {
  a += r;
  b += r;
  return std::min(std::max(a, b), 0.0) + std::hypot(std::max(a, 0.0), std::max(b, 0.0)) - r;
}

inline double ramp(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Ellipsoid at `c` with radii `r`, first order exact at its surface.
double ellipsoid(const Vec& p, const Vec& c, const Vec& r);
/// The same, turned by `tilt` (rad) about x: its y axis points to (cos, -sin) in (y, z).
double tilted_ellipsoid(const Vec& p, const Vec& c, const Vec& r, double tilt);
double triangle_distance(const Vec& p, const Vec& a, const Vec& b, const Vec& c);

/// Points of a centripetal Catmull-Rom curve through `through`, `per_span` to a span.
std::vector<Flat> curve(const std::vector<Flat>& through, bool closed, int per_span = 8);
std::vector<Vec> curve(const std::vector<Vec>& through, int per_span = 6);

/// A value over a plane region, sampled on a grid once and read by bilinear interpolation; outside the grid it goes on
/// with unit slope for distances, or constant for widths.
class Sampled {
 public:
  Sampled() = default;
  template <class Function>
  Sampled(Flat low, Flat high, double cell, bool distance, Function&& value)
      : low_(low), cell_(cell), distance_(distance) {
    columns_ = static_cast<int>(std::ceil((high.u - low.u) / cell)) + 1;
    rows_ = static_cast<int>(std::ceil((high.v - low.v) / cell)) + 1;
    values_.resize(static_cast<std::size_t>(columns_) * rows_);
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        values_[static_cast<std::size_t>(j) * columns_ + i] =
            static_cast<float>(value(Flat{low.u + i * cell, low.v + j * cell}));
  }
  double operator()(double u, double v) const;
  Flat low() const { return low_; }
  Flat high() const { return {low_.u + (columns_ - 1) * cell_, low_.v + (rows_ - 1) * cell_}; }

 private:
  Flat low_;
  double cell_ = 1.0;
  bool distance_ = true;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> values_;
};

/// Signed distance to a closed smooth outline through the points.
Sampled outline(const std::vector<Flat>& through, double margin = 6.0, double cell = 0.4);
/// Distance to an open smooth curve through the points, less a radius that runs from point to point.
Sampled stroke(const std::vector<Flat>& through, const std::vector<double>& radius, double margin = 5.0,
               double cell = 0.3);

struct WidthPoint {
  Flat at;
  double width = 0.0;
};
/// Half width over the plane, smooth through scattered values and within their range, over the box of `region`.
Sampled widths(const std::vector<WidthPoint>& points, const Sampled& region);

/// A tube about a curve through points with radii; symmetric in x when `mirrored`.
class Tube {
 public:
  Tube(const std::vector<Vec>& through, const std::vector<double>& radius, bool mirrored, int per_span = 6);
  double operator()(const Vec& p) const;
  Vec low() const { return low_; }
  Vec high() const { return high_; }

 private:
  std::vector<Vec> points_;
  std::vector<double> radius_;
  bool mirrored_;
  Vec low_;
  Vec high_;
};

/// A curved plate between two rows of points (a ruled strip), each with its half thickness; mirrored in x.
class Plate {
 public:
  Plate(const std::vector<Vec>& top, const std::vector<Vec>& bottom, const std::vector<double>& top_radius,
        const std::vector<double>& bottom_radius);
  double operator()(const Vec& p) const;

 private:
  struct Facet {
    Vec a, b, c;
    double ra, rb, rc;
  };
  std::vector<Facet> facets_;
};

/// A shape with a box that holds it: far from the box the distance to the box is the answer (never more than the true
/// distance).
struct Shape {
  std::function<double(const Vec&)> distance;
  Vec low{-1e3, -1e3, -1e3};
  Vec high{1e3, 1e3, 1e3};
  double steepest = kSteepest;
  double near = 2.0;  ///< how far from the box the distance itself is still wanted, mm
  double operator()(const Vec& p) const {
    const double dx = std::max({low.x - p.x, p.x - high.x, 0.0});
    const double dy = std::max({low.y - p.y, p.y - high.y, 0.0});
    const double dz = std::max({low.z - p.z, p.z - high.z, 0.0});
    const double d = std::sqrt(dx * dx + dy * dy + dz * dz);
    return d > near ? d : distance(p);
  }
};

}  // namespace vallecula::pipeline::manikin
