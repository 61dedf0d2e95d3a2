// A manikin that lies askew in the scanner: its CT on a turned grid and, exactly, its labels there.
#pragma once

#include <cmath>
#include <random>

#include "pipeline/manikin/manikin.h"
#include "pipeline/mesh/vector3.h"
#include "pipeline/parallel.h"
#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {

/// How the patient lies: turned by these about his own axes, in the order nod, tilt, turn, and then moved.
struct Askew {
  double tilt_deg = 0.0;  ///< about y
  double turn_deg = 0.0;  ///< about z
  double nod_deg = 0.0;   ///< about x
  Vector3 moved{};        ///< mm

  Vector3 to_scan(const Vector3& p) const {
    constexpr double kDegree = 3.14159265358979323846 / 180.0;
    const double n = nod_deg * kDegree;
    const double r = tilt_deg * kDegree;
    const double t = turn_deg * kDegree;
    const Vector3 a{p[0], std::cos(n) * p[1] - std::sin(n) * p[2], std::sin(n) * p[1] + std::cos(n) * p[2]};
    const Vector3 b{std::cos(r) * a[0] + std::sin(r) * a[2], a[1], -std::sin(r) * a[0] + std::cos(r) * a[2]};
    const Vector3 c{std::cos(t) * b[0] - std::sin(t) * b[1], std::sin(t) * b[0] + std::cos(t) * b[1], b[2]};
    return c + moved;
  }
  Vector3 from_scan(const Vector3& p) const {
    const Vector3 q = p - moved;
    Vector3 out{};
    for (int a = 0; a < 3; ++a) {
      Vector3 e{};
      e[a] = 1.0;
      out[a] = dot(to_scan(e) - moved, q);
    }
    return out;
  }
};

/// Cubic between voxels, so that reading adds little to the blur of the scan that is read.
inline double cubic_at(const Volume<float>& volume, const Vector3& p) {
  const auto& g = volume.grid;
  std::array<std::array<double, 4>, 3> w{};
  std::array<int, 3> i{};
  for (int a = 0; a < 3; ++a) {
    const double v = std::clamp((p[a] - g.origin[a]) / g.spacing[a], 0.0, g.size[a] - 1.0);
    i[a] = static_cast<int>(v);
    const double f = v - i[a];
    w[a] = {((2.0 - f) * f - 1.0) * f / 2.0, ((3.0 * f - 5.0) * f * f + 2.0) / 2.0,
            ((4.0 - 3.0 * f) * f + 1.0) * f / 2.0, (f - 1.0) * f * f / 2.0};
  }
  double sum = 0.0;
  for (int c = 0; c < 64; ++c) {
    const std::array<int, 3> k{c % 4, c / 4 % 4, c / 16};
    std::array<int, 3> v{};
    for (int a = 0; a < 3; ++a) v[a] = std::clamp(i[a] + k[a] - 1, 0, g.size[a] - 1);
    sum += w[0][k[0]] * w[1][k[1]] * w[2][k[2]] * volume.at(v[0], v[1], v[2]);
  }
  return sum;
}

/// The CT is read between the voxels of an upright scan without noise; noise is added. The labels come from the
/// manikin's shapes wherever a border may be near.
inline ManikinScan scan_askew(const ManikinOptions& options, const Askew& pose, double spacing_mm, double slice_mm) {
  auto quiet = options;
  quiet.noise_hu = 0.0;
  quiet.in_plane_mm = 0.4;
  quiet.slice_mm = 0.6;
  const auto upright = scan_manikin(quiet);
  const auto hu = to_float(upright.ct);
  const auto& from = upright.ct.grid;
  const Manikin manikin(options.weight_kg, options.seed);
  Vector3 low{1e9, 1e9, 1e9};
  Vector3 high{-1e9, -1e9, -1e9};
  const auto body = bounds_of(where(upright.labels, [](std::uint8_t v) { return v != 0; }), 6.0);
  for (int c = 0; c < 8; ++c) {
    const auto corner =
        from.position((c & 1) != 0 ? body.high[0] : body.low[0], (c & 2) != 0 ? body.high[1] : body.low[1],
                      (c & 4) != 0 ? body.high[2] : body.low[2]);
    const auto p = pose.to_scan(corner);
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  // The scan ends a little below the carina.
  low[2] = pose.to_scan(manikin.landmarks().at("carina"))[2] - 10.0 * manikin.scale();
  Grid g;
  g.spacing = {spacing_mm, spacing_mm, slice_mm};
  g.origin = low;
  for (int a = 0; a < 3; ++a) g.size[a] = static_cast<int>(std::ceil((high[a] - low[a]) / g.spacing[a])) + 1;
  ManikinScan scan{Hounsfield(g), Labels(g)};
  parallel_for(g.size[2], [&](int z) {
    std::mt19937_64 random(1000003 * options.seed + static_cast<std::uint64_t>(z));
    std::normal_distribution<double> noise(0.0, 1.0);
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        const auto p = pose.from_scan(g.position(x, y, z));
        const double grain = options.noise_hu * noise(random);
        const auto near = from.nearest(p);
        bool same = true;
        int first = -1;
        for (int c = 0; c < 27 && same; ++c) {
          const std::array<int, 3> n{near[0] + c % 3 - 1, near[1] + c / 3 % 3 - 1, near[2] + c / 9 - 1};
          const int label = from.contains(n[0], n[1], n[2]) ? upright.labels.at(n[0], n[1], n[2]) : int{kBackground};
          if (first < 0) first = label;
          same = label == first;
        }
        // Below the upright scan the infant's neck and chest go on.
        const bool below = p[2] < from.origin[2];
        scan.labels.at(x, y, z) = static_cast<std::uint8_t>(same && !below ? first : int{manikin.label_at(p)});
        const double value = below ? manikin.hounsfield_at(p) : cubic_at(hu, p);
        scan.ct.at(x, y, z) = static_cast<std::int16_t>(std::lround(std::clamp(value + grain, -1024.0, 3071.0)));
      }
    }
  });
  return scan;
}

}  // namespace vallecula::pipeline
