#include "pipeline/dicom/to_patient_axes.h"

#include <algorithm>
#include <limits>

namespace vallecula::pipeline {
namespace {

using Vector = std::array<double, 3>;

constexpr std::int16_t kAirHu = -1024;

/// Index to millimetres: origin + i step[0] + j step[1] + k step[2]. Steps need not be perpendicular (tilted gantry).
struct Affine {
  Vector origin{};
  std::array<Vector, 3> step{};
};

Affine affine_of(const std::vector<Slice>& slices) {
  const auto& first = slices.front();
  Affine m;
  m.origin = first.position;
  for (int a = 0; a < 3; ++a) {
    m.step[0][a] = first.row[a] * first.spacing[0];
    m.step[1][a] = first.column[a] * first.spacing[1];
    m.step[2][a] = (slices.back().position[a] - first.position[a]) / static_cast<double>(slices.size() - 1);
  }
  return m;
}

double length(const Vector& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/// For each patient axis the index axis that runs along it, or all -1 when one does not run along any.
std::array<int, 3> matching_axes(const Affine& m) {
  std::array<int, 3> source{-1, -1, -1};
  for (int k = 0; k < 3; ++k) {
    for (int a = 0; a < 3; ++a) {
      if (std::abs(m.step[k][a]) > 0.999995 * length(m.step[k])) source[a] = k;  // within 0.2 degrees
    }
  }
  if (source[0] < 0 || source[1] < 0 || source[2] < 0) return {-1, -1, -1};
  return source;
}

Hounsfield turned(const std::vector<Slice>& slices, const Affine& m, const std::array<int, 3>& source) {
  const std::array<int, 3> size{slices.front().columns, slices.front().rows, static_cast<int>(slices.size())};
  Grid grid;
  std::array<bool, 3> flipped{};
  for (int a = 0; a < 3; ++a) {
    const int k = source[a];
    grid.size[a] = size[k];
    grid.spacing[a] = length(m.step[k]);
    flipped[a] = m.step[k][a] < 0.0;
    grid.origin[a] = m.origin[a];
  }
  for (int a = 0; a < 3; ++a) {
    if (flipped[a]) grid.origin[a] = m.origin[a] - grid.spacing[a] * (grid.size[a] - 1);
  }
  Hounsfield out(grid);
  std::array<int, 3> from{};
  for (int z = 0; z < grid.size[2]; ++z) {
    from[source[2]] = flipped[2] ? grid.size[2] - 1 - z : z;
    for (int y = 0; y < grid.size[1]; ++y) {
      from[source[1]] = flipped[1] ? grid.size[1] - 1 - y : y;
      for (int x = 0; x < grid.size[0]; ++x) {
        from[source[0]] = flipped[0] ? grid.size[0] - 1 - x : x;
        out.at(x, y, z) = slices[from[2]].hu[static_cast<std::size_t>(from[1]) * size[0] + from[0]];
      }
    }
  }
  return out;
}

std::array<Vector, 3> inverse(const std::array<Vector, 3>& columns) {
  const auto& a = columns[0];
  const auto& b = columns[1];
  const auto& c = columns[2];
  const auto cross = [](const Vector& u, const Vector& v) {
    return Vector{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const auto bc = cross(b, c);
  const double det = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
  std::array<Vector, 3> rows{bc, cross(c, a), cross(a, b)};
  for (auto& row : rows) {
    for (double& v : row) v /= det;
  }
  return rows;
}

Hounsfield interpolated(const std::vector<Slice>& slices, const Affine& m) {
  const std::array<int, 3> size{slices.front().columns, slices.front().rows, static_cast<int>(slices.size())};
  Vector low{1e30, 1e30, 1e30};
  Vector high{-1e30, -1e30, -1e30};
  for (int corner = 0; corner < 8; ++corner) {
    for (int a = 0; a < 3; ++a) {
      double v = m.origin[a];
      for (int k = 0; k < 3; ++k) v += ((corner >> k) & 1) != 0 ? m.step[k][a] * (size[k] - 1) : 0.0;
      low[a] = std::min(low[a], v);
      high[a] = std::max(high[a], v);
    }
  }
  Grid grid;
  for (int a = 0; a < 3; ++a) {
    // The voxel size along a patient axis is that of the index axis nearest to it.
    int nearest = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(m.step[k][a]) / length(m.step[k]) > std::abs(m.step[nearest][a]) / length(m.step[nearest]))
        nearest = k;
    }
    grid.spacing[a] = length(m.step[nearest]);
    grid.origin[a] = low[a];
    grid.size[a] = static_cast<int>(std::floor((high[a] - low[a]) / grid.spacing[a] + 1e-6)) + 1;
  }
  const auto to_index = inverse(m.step);
  Hounsfield out(grid, kAirHu);
  const auto value = [&](int i, int j, int k) {
    return static_cast<double>(slices[k].hu[static_cast<std::size_t>(j) * size[0] + i]);
  };
  for (int z = 0; z < grid.size[2]; ++z) {
    for (int y = 0; y < grid.size[1]; ++y) {
      for (int x = 0; x < grid.size[0]; ++x) {
        const auto p = grid.position(x, y, z);
        std::array<int, 3> i0{};
        Vector f{};
        bool inside = true;
        for (int k = 0; k < 3 && inside; ++k) {
          double index = 0.0;
          for (int a = 0; a < 3; ++a) index += to_index[k][a] * (p[a] - m.origin[a]);
          inside = index > -1e-6 && index < size[k] - 1 + 1e-6;
          index = std::clamp(index, 0.0, size[k] - 1.0);
          i0[k] = std::min(static_cast<int>(index), size[k] - 2);
          f[k] = index - i0[k];
        }
        if (!inside) continue;
        double sum = 0.0;
        for (int c = 0; c < 8; ++c) {
          const double w =
              ((c & 1) != 0 ? f[0] : 1 - f[0]) * ((c & 2) != 0 ? f[1] : 1 - f[1]) * ((c & 4) != 0 ? f[2] : 1 - f[2]);
          if (w > 0.0) sum += w * value(i0[0] + (c & 1), i0[1] + ((c >> 1) & 1), i0[2] + ((c >> 2) & 1));
        }
        out.at(x, y, z) = static_cast<std::int16_t>(std::lround(sum));
      }
    }
  }
  return out;
}

}  // namespace

Hounsfield to_patient_axes(const std::vector<Slice>& slices, bool& resampled) {
  const auto m = affine_of(slices);
  const auto source = matching_axes(m);
  resampled = source[0] < 0;
  return resampled ? interpolated(slices, m) : turned(slices, m, source);
}

}  // namespace vallecula::pipeline
