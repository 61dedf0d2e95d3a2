#include "pipeline/segment/upright.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/mesh/vector3.h"
#include "pipeline/parallel.h"
#include "pipeline/segment/profile.h"

namespace vallecula::pipeline {
namespace {

constexpr double kPerDegree = 3.14159265358979323846 / 180.0;
constexpr double kLeastAskew = 2.0;  ///< degrees of tilt and turn: below, the search's own error and a head's asymmetry
// A nod is told by the likeness to the shipped infant. An adult's profile is another: there the likeness is believed
// only when it is far off, for a head that looks straight up is already 14 degrees from the infant's sniffing position.
constexpr double kLeastNod = 6.0;  ///< degrees
constexpr double kLeastNodOfOther = 25.0;
constexpr double kLike = 0.04;

/// The plane about which the head is symmetric: through `offset` mm along its normal from the head's middle.
struct Plane {
  double turn = 0.0;  ///< degrees
  double tilt = 0.0;
  double offset = 0.0;
  Vector3 normal() const {
    const double t = turn * kPerDegree;
    const double r = tilt * kPerDegree;
    return {std::cos(t) * std::cos(r), std::sin(t) * std::cos(r), -std::sin(r)};
  }
};

/// 0 in air, 1 in soft tissue, up to 1.8 in bone; metal no brighter. Block means: coarse, and without the noise.
Volume<float> coarse_of(const Hounsfield& hu, const Mask& body, double step_mm) {
  std::array<int, 3> k{};
  Grid g = hu.grid;
  for (int a = 0; a < 3; ++a) {
    k[a] = std::max(1, static_cast<int>(std::lround(step_mm / g.spacing[a])));
    g.size[a] = hu.grid.size[a] / k[a];
    g.spacing[a] *= k[a];
    g.origin[a] += 0.5 * (k[a] - 1) * hu.grid.spacing[a];
  }
  Volume<float> out(g);
  parallel_for(g.size[2], [&](int z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        float sum = 0.0F;
        for (int c = z * k[2]; c < (z + 1) * k[2]; ++c) {
          for (int b = y * k[1]; b < (y + 1) * k[1]; ++b) {
            for (int a = x * k[0]; a < (x + 1) * k[0]; ++a) {
              const auto i = hu.grid.index(a, b, c);
              if (body.voxels[i] != 0) sum += static_cast<float>(grey_of(hu.voxels[i]));
            }
          }
        }
        out.at(x, y, z) = sum / static_cast<float>(k[0] * k[1] * k[2]);
      }
    }
  });
  return out;
}

class Symmetry {
 public:
  Symmetry(const Volume<float>& grey, const Frame& frame) : grey_(grey) {
    const auto& g = grey.grid;
    // The head without the neck, which may be turned against it, and without the shoulders.
    const double breadth = 83.6 * frame.scale;
    for (std::size_t i = 0; i < grey.voxels.size(); ++i) {
      const Vector3 p = g.position(i);
      if (grey.voxels[i] < 0.3F || p[2] < frame.skull_top - 1.35 * breadth) continue;
      points_.push_back(p);
      values_.push_back(grey.voxels[i]);
      middle_ = middle_ + p;
    }
    if (!points_.empty()) middle_ = (1.0 / static_cast<double>(points_.size())) * middle_;
  }
  bool empty() const { return points_.size() < 200; }
  const Vector3& middle() const { return middle_; }

  /// Mean square difference of the head from its mirror image; each no more than 0.25, so that a couch, an arm or a
  /// tube on one side counts little. About `most` points are asked.
  double cost(const Plane& plane, std::size_t most) const {
    const auto n = plane.normal();
    const std::size_t stride = std::max<std::size_t>(1, points_.size() / most);
    const auto& g = grey_.grid;
    double sum = 0.0;
    double seen = 0.0;
    double asked = 0.0;
    for (std::size_t i = 0; i < points_.size(); i += stride) {
      asked += 1.0;
      const auto q = points_[i] - (2.0 * (dot(points_[i] - middle_, n) - plane.offset)) * n;
      bool inside = true;
      for (int a = 0; a < 3; ++a) {
        const double c = (q[a] - g.origin[a]) / g.spacing[a];
        // Beside the body there is air, whether scanned or not; above and below there may be more of the head.
        inside = inside && (a != 2 || (c > -0.5 && c < g.size[a] - 0.5));
      }
      if (!inside) continue;
      const double d = values_[i] - value_at(grey_, q);
      sum += std::min(d * d, 0.25);
      seen += 1.0;
    }
    return seen > 0.6 * asked ? sum / seen : 1.0;
  }

  Plane refined(Plane plane, double step_deg, double finest_deg, double step_mm, std::size_t most) const {
    double best = cost(plane, most);
    while (step_deg >= finest_deg) {
      const auto before = plane;
      for (int a = 0; a < 3; ++a) {
        for (const double sign : {1.0, -1.0}) {
          auto next = plane;
          if (a == 0) next.turn += sign * step_deg;
          if (a == 1) next.tilt += sign * step_deg;
          if (a == 2) next.offset += sign * step_mm;
          const double c = cost(next, most);
          if (c >= best) continue;
          best = c;
          plane = next;
        }
      }
      if (plane.turn == before.turn && plane.tilt == before.tilt && plane.offset == before.offset) {
        step_deg *= 0.5;
        step_mm *= 0.5;
      }
    }
    return plane;
  }

 private:
  const Volume<float>& grey_;
  std::vector<Vector3> points_;
  std::vector<float> values_;
  Vector3 middle_{};
};

Plane plane_of(const Symmetry& symmetry, double breadth) {
  struct Start {
    double cost;
    Plane plane;
  };
  std::vector<Start> starts;
  for (double turn = -60.0; turn <= 60.0; turn += 10.0) {
    for (double tilt = -45.0; tilt <= 45.0; tilt += 9.0) {
      Start best{std::numeric_limits<double>::infinity(), {}};
      for (int k = -3; k <= 3; ++k) {
        const Plane plane{turn, tilt, k * 0.03 * breadth};
        const double c = symmetry.cost(plane, 1200);
        if (c < best.cost) best = {c, plane};
      }
      starts.push_back(best);
    }
  }
  std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.cost < b.cost; });
  Start best{std::numeric_limits<double>::infinity(), {}};
  for (int k = 0; k < 4; ++k) {
    const auto plane = symmetry.refined(starts[k].plane, 4.0, 1.0, 0.02 * breadth, 4000);
    const double c = symmetry.cost(plane, 4000);
    if (c < best.cost) best = {c, plane};
  }
  return symmetry.refined(best.plane, 1.0, 0.1, 0.01 * breadth, 20000);
}

/// p -> Rx(-nod) Ry(-tilt) Rz(-turn) (p - middle) + middle: the patient was nodded, then tilted, then turned.
Transform upright_about(const Vector3& middle, double tilt_deg, double turn_deg, double nod_deg) {
  const double n = nod_deg * kPerDegree;
  const double r = tilt_deg * kPerDegree;
  const double t = turn_deg * kPerDegree;
  Transform m{};
  for (int a = 0; a < 3; ++a) {
    Vector3 e{};
    e[a] = 1.0;
    const Vector3 b{std::cos(t) * e[0] + std::sin(t) * e[1], -std::sin(t) * e[0] + std::cos(t) * e[1], e[2]};
    const Vector3 c{std::cos(r) * b[0] - std::sin(r) * b[2], b[1], std::sin(r) * b[0] + std::cos(r) * b[2]};
    const Vector3 d{c[0], std::cos(n) * c[1] + std::sin(n) * c[2], -std::sin(n) * c[1] + std::cos(n) * c[2]};
    for (int row = 0; row < 3; ++row) m[4 * row + a] = d[row];
  }
  for (int row = 0; row < 3; ++row)
    m[4 * row + 3] = middle[row] - m[4 * row] * middle[0] - m[4 * row + 1] * middle[1] - m[4 * row + 2] * middle[2];
  m[15] = 1.0;
  return m;
}

}  // namespace

PoseChange find_pose(const Hounsfield& hu, const Mask& body, const Frame& frame) {
  PoseChange pose;
  // 3.3 mm in the term infant, where the orbits and the jaw are a few voxels wide.
  const double step = std::clamp(3.3 * frame.scale, 1.5, 4.0);
  const auto grey = coarse_of(hu, body, step);
  const Symmetry symmetry(grey, frame);
  if (symmetry.empty()) return pose;
  const auto plane = plane_of(symmetry, 83.6 * frame.scale);
  const bool askew = std::hypot(plane.turn, plane.tilt) >= kLeastAskew;
  const double tilt = askew ? plane.tilt : 0.0;
  const double turn = askew ? plane.turn : 0.0;
  const auto on_plane = symmetry.middle() + plane.offset * plane.normal();
  const auto straight = upright_about(on_plane, tilt, turn, 0.0);
  const auto nod = nod_of(hu, body, inverse_of(straight), on_plane, frame);
  pose.tilt_deg = tilt;
  pose.turn_deg = turn;
  if (std::abs(nod.degrees) >= (nod.misfit < kLike ? kLeastNod : kLeastNodOfOther)) pose.nod_deg = nod.degrees;
  if (tilt != 0.0 || turn != 0.0 || pose.nod_deg != 0.0)
    pose.scan_to_package = upright_about(on_plane, tilt, turn, pose.nod_deg);
  return pose;
}

Edits put_upright(const Edits& edits, const PoseChange& pose, const Grid& grid) {
  if (!pose.moved()) return edits;
  Edits out = edits;
  for (auto& [name, point] : out.seeds) point = moved(pose.scan_to_package, point);
  for (auto& [name, point] : out.landmarks) {
    point = moved(pose.scan_to_package, point);
    if (name != "glottis_normal") continue;
    // A direction turns, it does not move.
    const auto origin = moved(pose.scan_to_package, Point{});
    for (int a = 0; a < 3; ++a) point[a] -= origin[a];
  }
  if (out.labels) out.labels = read_onto(grid, inverse_of(pose.scan_to_package), *edits.labels);
  return out;
}

}  // namespace vallecula::pipeline
