// Unit quaternions (w first) and three-vectors as plain arrays: all the arithmetic a device needs, without a library.
#pragma once

#include <array>
#include <cmath>
#include <limits>

namespace vallecula::device {

using Vector = std::array<double, 3>;
using Rotation = std::array<double, 4>;  ///< w, x, y, z; turns tool axes into world axes

inline Vector add(const Vector& a, const Vector& b) noexcept { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector subtract(const Vector& a, const Vector& b) noexcept { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector scale(const Vector& a, double s) noexcept { return {a[0] * s, a[1] * s, a[2] * s}; }
/// Scaled so that neither huge nor tiny components overflow or vanish; infinite or NaN input gives a non-finite result
/// (which the three-argument std::hypot of libstdc++ does not: it returns 0 for 0, NaN, 0).
inline double length(const Vector& a) noexcept { return std::hypot(std::hypot(a[0], a[1]), a[2]); }
inline bool finite(const Vector& a) noexcept {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}
/// Shortened to `limit`, direction kept; a hair less, so that rounding cannot leave it above. What is not finite is
/// returned not finite.
inline Vector shortened(const Vector& v, double limit) noexcept {
  const double norm = length(v);
  if (!(norm > limit)) return v;
  return scale(v, limit / norm * (1.0 - 4.0 * std::numeric_limits<double>::epsilon()));
}
/// The same as a last line of defence: a vector or length that is not finite, or a limit not positive, gives zero.
inline Vector shortened_or_zero(const Vector& v, double limit) noexcept {
  return std::isfinite(length(v)) && limit > 0.0 ? shortened(v, limit) : Vector{0, 0, 0};
}

inline double dot(const Rotation& a, const Rotation& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// Identity for a quaternion without a direction.
inline Rotation normalised(const Rotation& q) noexcept {
  const double norm = std::sqrt(dot(q, q));
  if (!(norm > 0.0) || !std::isfinite(norm)) return {1, 0, 0, 0};
  return {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
}

inline Rotation multiply(const Rotation& a, const Rotation& b) noexcept {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

inline Rotation about_axis(const Vector& unit_axis, double angle_rad) noexcept {
  const double s = std::sin(0.5 * angle_rad);
  return {std::cos(0.5 * angle_rad), unit_axis[0] * s, unit_axis[1] * s, unit_axis[2] * s};
}

inline Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rotation inverse(const Rotation& unit) noexcept { return {unit[0], -unit[1], -unit[2], -unit[3]}; }

/// The rotation that turns the axes x, y, z into these (orthonormal, right-handed). Shepperd 1978: the largest of the
/// four components is found first, so that none is divided by a small one.
inline Rotation from_axes(const Vector& x, const Vector& y, const Vector& z) noexcept {
  const double trace = x[0] + y[1] + z[2];
  if (trace >= x[0] && trace >= y[1] && trace >= z[2]) {
    return normalised({1.0 + trace, y[2] - z[1], z[0] - x[2], x[1] - y[0]});
  }
  if (x[0] >= y[1] && x[0] >= z[2]) {
    return normalised({y[2] - z[1], 1.0 + x[0] - y[1] - z[2], y[0] + x[1], z[0] + x[2]});
  }
  if (y[1] >= z[2]) return normalised({z[0] - x[2], y[0] + x[1], 1.0 - x[0] + y[1] - z[2], z[1] + y[2]});
  return normalised({x[1] - y[0], z[0] + x[2], z[1] + y[2], 1.0 - x[0] - y[1] + z[2]});
}

inline Vector rotate(const Rotation& q, const Vector& v) noexcept {
  const Rotation r = multiply(multiply(q, {0, v[0], v[1], v[2]}), inverse(q));
  return {r[1], r[2], r[3]};
}

/// Angle between two rotations, 0..pi.
inline double angle_between(const Rotation& a, const Rotation& b) noexcept {
  const Rotation d = multiply(inverse(a), b);
  return 2.0 * std::atan2(length({d[1], d[2], d[3]}), std::abs(d[0]));
}

/// The shorter great arc from a (s = 0) to b (s = 1) at constant angular speed.
inline Rotation slerp(const Rotation& a, const Rotation& b, double s) noexcept {
  double cosine = dot(a, b);
  const double sign = cosine < 0.0 ? -1.0 : 1.0;
  cosine = std::abs(cosine);
  double from = 1.0 - s, to = s;
  if (cosine < 1.0 - 1e-9) {  // nearer than this the sines cancel and the straight line is exact to rounding
    const double angle = std::acos(cosine);
    from = std::sin((1.0 - s) * angle) / std::sin(angle);
    to = std::sin(s * angle) / std::sin(angle);
  }
  return normalised({from * a[0] + sign * to * b[0], from * a[1] + sign * to * b[1], from * a[2] + sign * to * b[2],
                     from * a[3] + sign * to * b[3]});
}

}  // namespace vallecula::device
