#include "pipeline/dicom/to_patient_axes.h"

#include <algorithm>

#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/series_error.h"
#include "pipeline/parallel.h"

namespace vallecula::pipeline {
namespace {

constexpr std::int16_t kOutsideHu = -1024;

/// For each patient axis the index axis that runs along it, or all -1 when one does not run along any.
std::array<int, 3> matching_axes(const CtGeometry& g) {
  std::array<int, 3> source{-1, -1, -1};
  double off = 0.0;  // of the far corner
  for (int k = 0; k < 3; ++k) {
    int along = 0;
    for (int a = 1; a < 3; ++a) {
      if (std::abs(g.step[k][a]) > std::abs(g.step[k][along])) along = a;
    }
    source[along] = k;
    Vector3 aside = g.step[k];
    aside[along] = 0.0;
    off += norm(aside) * (g.size[k] - 1);
  }
  if (source[0] < 0 || source[1] < 0 || source[2] < 0 || off > kExactMm) return {-1, -1, -1};
  return source;
}

Hounsfield turned(const CtVolume& volume, const std::array<int, 3>& source) {
  const auto& m = volume.geometry;
  Grid grid;
  std::array<bool, 3> flipped{};
  for (int a = 0; a < 3; ++a) {
    const int k = source[a];
    grid.size[a] = m.size[k];
    grid.spacing[a] = std::abs(m.step[k][a]);
    flipped[a] = m.step[k][a] < 0.0;
    grid.origin[a] = flipped[a] ? m.origin[a] - grid.spacing[a] * (grid.size[a] - 1) : m.origin[a];
  }
  Hounsfield out(grid);
  parallel_for(grid.size[2], [&](int z) {
    std::array<int, 3> from{};
    from[source[2]] = flipped[2] ? grid.size[2] - 1 - z : z;
    for (int y = 0; y < grid.size[1]; ++y) {
      from[source[1]] = flipped[1] ? grid.size[1] - 1 - y : y;
      for (int x = 0; x < grid.size[0]; ++x) {
        from[source[0]] = flipped[0] ? grid.size[0] - 1 - x : x;
        out.at(x, y, z) = volume.at(from[0], from[1], from[2]);
      }
    }
  });
  return out;
}

/// Rows of the inverse of the matrix with these columns.
std::array<Vector3, 3> inverse(const std::array<Vector3, 3>& columns) {
  const auto bc = cross(columns[1], columns[2]);
  std::array<Vector3, 3> rows{bc, cross(columns[2], columns[0]), cross(columns[0], columns[1])};
  const double det = dot(columns[0], bc);
  for (auto& row : rows) {
    for (double& v : row) v /= det;
  }
  return rows;
}

/// The smallest grid along the patient's axes that encloses the volume.
Grid enclosing(const CtGeometry& m) {
  Vector3 low{1e30, 1e30, 1e30};
  Vector3 high{-1e30, -1e30, -1e30};
  for (int corner = 0; corner < 8; ++corner) {
    const auto v = m.position((corner & 1) * (m.size[0] - 1), ((corner >> 1) & 1) * (m.size[1] - 1),
                              ((corner >> 2) & 1) * (m.size[2] - 1));
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], v[a]);
      high[a] = std::max(high[a], v[a]);
    }
  }
  Grid grid;
  double count = 1.0;
  for (int a = 0; a < 3; ++a) {
    // The voxel size along a patient axis is that of the index axis nearest to it.
    int nearest = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(m.step[k][a]) / norm(m.step[k]) > std::abs(m.step[nearest][a]) / norm(m.step[nearest])) nearest = k;
    }
    grid.spacing[a] = norm(m.step[nearest]);
    grid.origin[a] = low[a];
    const double steps = std::floor((high[a] - low[a]) / grid.spacing[a] + 1e-6) + 1.0;
    count *= steps;
    if (count > static_cast<double>(kMostVoxels))
      throw SeriesError("series: too large to be turned onto the patient's axes; export the head and neck alone");
    grid.size[a] = static_cast<int>(steps);
  }
  return grid;
}

Hounsfield interpolated(const CtVolume& volume) {
  const auto& m = volume.geometry;
  const auto to_index = inverse(m.step);
  Hounsfield out(enclosing(m), kOutsideHu);
  const Grid& grid = out.grid;
  parallel_for(grid.size[2], [&](int z) {
    for (int y = 0; y < grid.size[1]; ++y) {
      for (int x = 0; x < grid.size[0]; ++x) {
        const auto p = grid.position(x, y, z);
        std::array<int, 3> i0{};
        Vector3 f{};
        bool inside = true;
        for (int k = 0; k < 3 && inside; ++k) {
          double index = 0.0;
          for (int a = 0; a < 3; ++a) index += to_index[k][a] * (p[a] - m.origin[a]);
          inside = index > -1e-6 && index < m.size[k] - 1 + 1e-6;
          index = std::clamp(index, 0.0, m.size[k] - 1.0);
          i0[k] = std::min(static_cast<int>(index), m.size[k] - 2);
          f[k] = index - i0[k];
        }
        if (!inside) continue;
        double sum = 0.0;
        for (int c = 0; c < 8; ++c) {
          const double w =
              ((c & 1) != 0 ? f[0] : 1 - f[0]) * ((c & 2) != 0 ? f[1] : 1 - f[1]) * ((c & 4) != 0 ? f[2] : 1 - f[2]);
          if (w > 0.0) sum += w * volume.at(i0[0] + (c & 1), i0[1] + ((c >> 1) & 1), i0[2] + ((c >> 2) & 1));
        }
        out.at(x, y, z) = static_cast<std::int16_t>(std::lround(sum));
      }
    }
  });
  return out;
}

}  // namespace

Hounsfield to_patient_axes(const CtVolume& volume, bool& resampled) {
  const auto source = matching_axes(volume.geometry);
  resampled = source[0] < 0;
  return resampled ? interpolated(volume) : turned(volume, source);
}

}  // namespace vallecula::pipeline
