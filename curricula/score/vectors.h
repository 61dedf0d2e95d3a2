// Points and directions of the log, as the score reckons with them (private to the library).
#pragma once

#include <array>
#include <cmath>

namespace vallecula::curricula {

using Point = std::array<double, 3>;

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point plus(const Point& a, const Point& b, double s = 1.0) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline Point scaled(const Point& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Not finite when a component is not (the three-argument std::hypot of libstdc++ returns 0 for 0, NaN, 0).
inline double magnitude(const Point& v) { return std::hypot(std::hypot(v[0], v[1]), v[2]); }
inline double distance(const Point& a, const Point& b) { return magnitude(plus(a, b, -1.0)); }

/// The body's z axis in the world: of the blade, out of its tongue side along the handle.
inline Point z_axis(const std::array<double, 4>& wxyz) {
  const auto& [w, x, y, z] = wxyz;
  return {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
}

}  // namespace vallecula::curricula
