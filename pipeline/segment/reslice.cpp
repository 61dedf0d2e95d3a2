#include "pipeline/segment/reslice.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "pipeline/mesh/vector3.h"
#include "pipeline/package/label_map.h"
#include "pipeline/parallel.h"

namespace vallecula::pipeline {
namespace {

/// Cubic between voxels (Catmull and Rom): a straight line between them would blur thin bone and the epiglottis by as
/// much again as the scanner did. No value leaves the range of the eight voxels about the point.
float between_voxels(const Hounsfield& hu, const std::array<double, 3>& index) {
  const auto& g = hu.grid;
  std::array<std::array<std::size_t, 4>, 3> at{};
  std::array<std::array<float, 4>, 3> w{};
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(g.size[0]),
                                          static_cast<std::size_t>(g.size[0]) * static_cast<std::size_t>(g.size[1])};
  for (int a = 0; a < 3; ++a) {
    const double v = std::clamp(index[a], 0.0, g.size[a] - 1.0);
    const int i = static_cast<int>(v);
    const auto f = static_cast<float>(v - i);
    for (int k = 0; k < 4; ++k)
      at[a][k] = static_cast<std::size_t>(std::clamp(i + k - 1, 0, g.size[a] - 1)) * stride[a];
    w[a] = {f * (-0.5F + f * (1.0F - 0.5F * f)), 1.0F + f * f * (1.5F * f - 2.5F), f * (0.5F + f * (2.0F - 1.5F * f)),
            f * f * (0.5F * f - 0.5F)};
  }
  const std::int16_t* v = hu.voxels.data();
  float sum = 0.0F;
  std::int16_t low = std::numeric_limits<std::int16_t>::max();
  std::int16_t high = std::numeric_limits<std::int16_t>::min();
  for (int c = 0; c < 4; ++c) {
    for (int b = 0; b < 4; ++b) {
      const std::int16_t* row = v + at[2][c] + at[1][b];
      const std::array<std::int16_t, 4> x{row[at[0][0]], row[at[0][1]], row[at[0][2]], row[at[0][3]]};
      sum += w[2][c] * w[1][b] * (w[0][0] * x[0] + w[0][1] * x[1] + w[0][2] * x[2] + w[0][3] * x[3]);
      if ((c != 1 && c != 2) || (b != 1 && b != 2)) continue;
      low = std::min({low, x[1], x[2]});
      high = std::max({high, x[1], x[2]});
    }
  }
  return std::clamp(sum, static_cast<float>(low), static_cast<float>(high));
}

enum class Matter { air, soft, bone };

Matter matter_of(std::uint8_t label) {
  if (label == kBackground || label == kAirway) return Matter::air;
  return label == kSkull || label == kMandible || label == kSpine ? Matter::bone : Matter::soft;
}

/// The labels about a point, each with its share of the point's cell (the weights of linear interpolation).
struct Shares {
  std::array<std::uint8_t, 8> label{};
  std::array<double, 8> weight{};
  int count = 0;
  std::uint8_t largest(const std::function<bool(std::uint8_t)>& among, std::uint8_t otherwise) const {
    int best = -1;
    for (int k = 0; k < count; ++k) {
      if (among(label[k]) && (best < 0 || weight[k] > weight[best])) best = k;
    }
    return best < 0 ? otherwise : label[best];
  }
};

/// False outside the grid.
bool shares_at(const Labels& labels, const Point& p, Shares& out) {
  const auto& g = labels.grid;
  std::array<int, 3> i{};
  std::array<double, 3> f{};
  for (int a = 0; a < 3; ++a) {
    const double v = (p[a] - g.origin[a]) / g.spacing[a];
    if (v < -0.5 || v > g.size[a] - 0.5) return false;
    i[a] = std::clamp(static_cast<int>(std::floor(v)), 0, std::max(0, g.size[a] - 2));
    f[a] = std::clamp(v - i[a], 0.0, 1.0);
  }
  out.count = 0;
  for (int c = 0; c < 8; ++c) {
    const auto label =
        labels.at(std::min(i[0] + (c & 1), g.size[0] - 1), std::min(i[1] + ((c >> 1) & 1), g.size[1] - 1),
                  std::min(i[2] + ((c >> 2) & 1), g.size[2] - 1));
    const double weight =
        ((c & 1) != 0 ? f[0] : 1.0 - f[0]) * ((c & 2) != 0 ? f[1] : 1.0 - f[1]) * ((c & 4) != 0 ? f[2] : 1.0 - f[2]);
    int k = 0;
    while (k < out.count && out.label[k] != label) ++k;
    if (k == out.count) {
      out.label[k] = label;
      out.weight[k] = 0.0;
      ++out.count;
    }
    out.weight[k] += weight;
  }
  return true;
}

template <class Choose>
Labels read_labels(const Grid& grid, const Transform& grid_to_labels, const Labels& labels, const Choose& choose) {
  Labels out(grid);
  parallel_for(grid.size[2], [&](int z) {
    Shares shares;
    for (int y = 0; y < grid.size[1]; ++y) {
      for (int x = 0; x < grid.size[0]; ++x) {
        const auto p = moved(grid_to_labels, grid.position(x, y, z));
        if (!shares_at(labels, p, shares)) continue;
        out.at(x, y, z) = shares.count == 1 ? shares.label[0] : choose(shares, p);
      }
    }
  });
  return out;
}

std::uint8_t by_weight(const Shares& shares) {
  return shares.largest([](std::uint8_t) { return true; }, kBackground);
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
  g.spacing[2] =
      std::clamp(volume / (most * g.spacing[0] * g.spacing[1]), std::min(g.spacing[0], g.spacing[2]), g.spacing[2]);
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
  // Trachea or bronchi, cut, and their rim, which is half air.
  const auto cut = dilated(holes_of_slice(body, 0), 2.0 * std::max(from.spacing[0], from.spacing[1]));
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
        if (inside) out.at(x, y, z) = static_cast<std::int16_t>(std::lround(between_voxels(patient, index)));
      }
    }
  });
  return out;
}

Labels read_onto(const Grid& grid, const Transform& grid_to_labels, const Labels& labels) {
  return read_labels(grid, grid_to_labels, labels,
                     [](const Shares& shares, const Point&) { return by_weight(shares); });
}

Labels read_onto(const Grid& grid, const Transform& grid_to_labels, const Labels& labels, const Hounsfield& hu,
                 const Thresholds& t) {
  return read_labels(grid, grid_to_labels, labels, [&](const Shares& shares, const Point& p) {
    std::array<double, 3> index{};
    for (int a = 0; a < 3; ++a) index[a] = (p[a] - hu.grid.origin[a]) / hu.grid.spacing[a];
    const float value = between_voxels(hu, index);
    const auto here = value > t.bone ? Matter::bone : value < t.air ? Matter::air : Matter::soft;
    return shares.largest([here](std::uint8_t label) { return matter_of(label) == here; }, by_weight(shares));
  });
}

}  // namespace vallecula::pipeline
