#include "pipeline/segment/upright.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/mesh/vector3.h"
#include "pipeline/parallel.h"
#include "pipeline/segment/profile.h"

namespace vallecula::pipeline {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kLeastAskew = 2.0;  ///< degrees of tilt and turn: below, the search's own error and a head's asymmetry
constexpr double kLeastNod = 10.0;   ///< degrees: how far a head looks up or down is its position, not an error

/// The plane about which the head is symmetric: through `offset` mm along its normal from the head's middle.
struct Plane {
  double turn = 0.0;  ///< degrees
  double tilt = 0.0;
  double offset = 0.0;
  Vector3 normal() const {
    const double t = turn * kDegree;
    const double r = tilt * kDegree;
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
  const double n = nod_deg * kDegree;
  const double r = tilt_deg * kDegree;
  const double t = turn_deg * kDegree;
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

/// Linear between voxels, as a straight run over the eight: the resampling of a whole CT hangs on it.
float linear_at(const Hounsfield& hu, const std::array<double, 3>& index) {
  const auto& g = hu.grid;
  std::array<int, 3> i{};
  std::array<float, 3> f{};
  for (int a = 0; a < 3; ++a) {
    const double v = std::clamp(index[a], 0.0, g.size[a] - 1.0);
    i[a] = std::min(static_cast<int>(v), std::max(0, g.size[a] - 2));
    f[a] = static_cast<float>(v - i[a]);
  }
  const std::size_t dx = g.size[0] > 1 ? 1 : 0;
  const std::size_t dy = g.size[1] > 1 ? g.size[0] : 0;
  const std::size_t dz = g.size[2] > 1 ? static_cast<std::size_t>(g.size[0]) * g.size[1] : 0;
  const std::int16_t* v = hu.voxels.data() + g.index(i[0], i[1], i[2]);
  const auto row = [&](std::size_t at) { return v[at] + f[0] * static_cast<float>(v[at + dx] - v[at]); };
  const float low = row(0) + f[1] * (row(dy) - row(0));
  const float high = row(dz) + f[1] * (row(dz + dy) - row(dz));
  return low + f[2] * (high - low);
}

/// The air of the lowest slice that tissue surrounds there: trachea or bronchi, cut.
Mask cut_airways(const Mask& body) {
  Box lowest = whole(body.grid);
  lowest.high[2] = 0;
  const auto slice = cropped(body, lowest);
  Grid between = slice.grid;
  between.size[2] = 3;
  Mask stack(between, 1);
  std::copy(slice.voxels.begin(), slice.voxels.end(), stack.voxels.begin() + static_cast<std::ptrdiff_t>(slice.grid.count()));
  const auto filled = with_holes_filled(stack);
  Mask out(slice.grid);
  for (std::size_t i = 0; i < out.voxels.size(); ++i)
    out.voxels[i] = filled.voxels[slice.grid.count() + i] & (1 - slice.voxels[i]);
  return out;
}

}  // namespace

Point moved(const Transform& m, const Point& p) {
  Point q{};
  for (int a = 0; a < 3; ++a) q[a] = m[4 * a] * p[0] + m[4 * a + 1] * p[1] + m[4 * a + 2] * p[2] + m[4 * a + 3];
  return q;
}

Transform inverse_of(const Transform& m) {
  const Vector3 r0{m[0], m[1], m[2]};
  const Vector3 r1{m[4], m[5], m[6]};
  const Vector3 r2{m[8], m[9], m[10]};
  const double det = dot(r0, cross(r1, r2));
  const std::array<Vector3, 3> columns{(1.0 / det) * cross(r1, r2), (1.0 / det) * cross(r2, r0),
                                       (1.0 / det) * cross(r0, r1)};
  Transform out{};
  for (int row = 0; row < 3; ++row) {
    for (int c = 0; c < 3; ++c) {
      out[4 * row + c] = columns[c][row];
      out[4 * row + 3] -= columns[c][row] * m[4 * c + 3];
    }
  }
  out[15] = 1.0;
  return out;
}

PoseChange find_pose(const Hounsfield& hu, const Mask& body, const Frame& frame) {
  PoseChange pose;
  // 3.3 mm in the term infant, where the orbits and the jaw are a few voxels wide.
  const double step = std::clamp(3.3 * frame.scale, 1.5, 4.0);
  const auto grey = coarse_of(hu, body, step);
  const Symmetry symmetry(grey, frame);
  if (symmetry.empty()) return pose;
  const auto plane = plane_of(symmetry, 83.6 * frame.scale);
  if(getenv("NOD")) printf("[plane turn %.2f tilt %.2f off %.2f cost %.4f] ",plane.turn,plane.tilt,plane.offset,symmetry.cost(plane,20000));
  if(getenv("ASK")){ Plane q; sscanf(getenv("ASK"),"%lf,%lf",&q.turn,&q.tilt); q=symmetry.refined(q,0.3,0.1,3,20000); printf("[ask %.2f %.2f cost %.4f] ",q.turn,q.tilt,symmetry.cost(q,20000));}
  const bool askew = std::hypot(plane.turn, plane.tilt) >= kLeastAskew;
  const double tilt = askew ? plane.tilt : 0.0;
  const double turn = askew ? plane.turn : 0.0;
  const auto on_plane = symmetry.middle() + plane.offset * plane.normal();
  const auto straight = upright_about(on_plane, tilt, turn, 0.0);
  const double nod = nod_of(hu, body, inverse_of(straight), on_plane, frame);
  pose.tilt_deg = tilt;
  pose.turn_deg = turn;
  pose.nod_deg = std::abs(nod) >= (getenv("NODMIN")?atof(getenv("NODMIN")):kLeastNod) ? nod : 0.0;
  if (tilt != 0.0 || turn != 0.0 || pose.nod_deg != 0.0)
    pose.scan_to_package = upright_about(on_plane, tilt, turn, pose.nod_deg);
  return pose;
}

Hounsfield put_upright(const Hounsfield& hu, const Mask& body, const Thresholds& t, const PoseChange& pose) {
  constexpr std::int16_t kAir = -1000;
  const auto& from = hu.grid;
  Hounsfield patient = hu;
  for (std::size_t i = 0; i < patient.voxels.size(); ++i) {
    if (body.voxels[i] == 0 && patient.voxels[i] > t.air) patient.voxels[i] = kAir;
  }
  Vector3 low{1e9, 1e9, 1e9};
  Vector3 high{-1e9, -1e9, -1e9};
  for (int z = 0; z < from.size[2]; ++z) {
    for (int y = 0; y < from.size[1]; ++y) {
      for (int x = 0; x < from.size[0]; ++x) {
        if (body.at(x, y, z) == 0) continue;
        // Only the ends of a row can be the outermost.
        if (x > 0 && x + 1 < from.size[0] && body.at(x - 1, y, z) != 0 && body.at(x + 1, y, z) != 0) continue;
        const auto p = moved(pose.scan_to_package, from.position(x, y, z));
        for (int a = 0; a < 3; ++a) {
          low[a] = std::min(low[a], p[a]);
          high[a] = std::max(high[a], p[a]);
        }
      }
    }
  }
  Grid g;
  // As fine along as across, for the scan's slices lie askew now; in a large patient memory and time matter more.
  const double most = std::max(20e6, 1.2 * static_cast<double>(from.count()));
  g.spacing = from.spacing;
  const double volume = (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
  g.spacing[2] = std::clamp(volume / (most * g.spacing[0] * g.spacing[1]),
                            std::min(g.spacing[0], g.spacing[2]), g.spacing[2]);
  constexpr double kMargin = 6.0;
  for (int a = 0; a < 3; ++a) {
    // Below the neck nothing is added: the lowest slice must be the one that is cut.
    const double start = low[a] - (a == 2 ? 0.0 : kMargin);
    g.origin[a] = start;
    g.size[a] = static_cast<int>(std::ceil((high[a] + kMargin - start) / g.spacing[a])) + 1;
  }
  const auto back = inverse_of(pose.scan_to_package);
  std::array<double, 3> up{};  // the package's upwards, in voxels of the scan
  for (int a = 0; a < 3; ++a) up[a] = back[4 * a + 2] / from.spacing[a];
  const auto cut = cut_airways(body);
  Hounsfield out(g, kAir);
  parallel_for(g.size[2], [&](int z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        const auto p = moved(back, g.position(x, y, z));
        std::array<double, 3> index{};
        for (int a = 0; a < 3; ++a) index[a] = (p[a] - from.origin[a]) / from.spacing[a];
        if (index[2] < 0.0 && up[2] > 0.0) {
          const double way = -index[2] / up[2];
          for (int a = 0; a < 3; ++a) index[a] += way * up[a];
          const auto i = static_cast<int>(std::lround(index[0]));
          const auto j = static_cast<int>(std::lround(index[1]));
          if (cut.grid.contains(i, j, 0) && cut.at(i, j, 0) != 0) {
            out.at(x, y, z) = static_cast<std::int16_t>(t.soft);
            continue;
          }
        }
        bool inside = true;
        for (int a = 0; a < 3; ++a) inside = inside && index[a] > -0.5 && index[a] < from.size[a] - 0.5;
        if (inside) out.at(x, y, z) = static_cast<std::int16_t>(std::lround(linear_at(patient, index)));
      }
    }
  });
  return out;
}

Labels read_onto(const Grid& grid, const Transform& grid_to_labels, const Labels& labels) {
  Labels out(grid);
  const auto& g = labels.grid;
  parallel_for(grid.size[2], [&](int z) {
    for (int y = 0; y < grid.size[1]; ++y) {
      for (int x = 0; x < grid.size[0]; ++x) {
        const auto p = moved(grid_to_labels, grid.position(x, y, z));
        std::array<int, 3> i{};
        std::array<double, 3> f{};
        bool outside = false;
        for (int a = 0; a < 3; ++a) {
          const double v = (p[a] - g.origin[a]) / g.spacing[a];
          outside = outside || v < -0.5 || v > g.size[a] - 0.5;
          i[a] = std::clamp(static_cast<int>(std::floor(v)), 0, std::max(0, g.size[a] - 2));
          f[a] = std::clamp(v - i[a], 0.0, 1.0);
        }
        if (outside) continue;
        std::array<std::uint8_t, 8> label{};
        std::array<double, 8> weight{};
        bool same = true;
        for (int c = 0; c < 8; ++c) {
          label[c] = labels.at(std::min(i[0] + (c & 1), g.size[0] - 1), std::min(i[1] + ((c >> 1) & 1), g.size[1] - 1),
                               std::min(i[2] + ((c >> 2) & 1), g.size[2] - 1));
          weight[c] = ((c & 1) != 0 ? f[0] : 1.0 - f[0]) * ((c & 2) != 0 ? f[1] : 1.0 - f[1]) *
                      ((c & 4) != 0 ? f[2] : 1.0 - f[2]);
          same = same && label[c] == label[0];
        }
        int best = 0;
        for (int c = 0; c < 8 && !same; ++c) {
          for (int other = c + 1; other < 8; ++other) {
            if (label[other] != label[c]) continue;
            weight[c] += weight[other];
            weight[other] = 0.0;
          }
          if (weight[c] > weight[best]) best = c;
        }
        out.at(x, y, z) = label[best];
      }
    }
  });
  return out;
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
