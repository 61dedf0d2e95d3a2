// Where the voxels of a label image from elsewhere lie: any directions, any handedness.
#pragma once

#include <array>
#include <cstddef>

#include "pipeline/mesh/vector3.h"
#include "pipeline/volume.h"

namespace vallecula::pipeline {

struct Placement {
  std::array<int, 3> size{0, 0, 0};                                ///< voxels along i, j, k; i runs fastest in memory
  std::array<Vector3, 3> step{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< from a voxel to the next along i, j, k, mm LPS
  Vector3 origin{};                                                ///< centre of voxel (0, 0, 0), mm LPS

  std::size_t count() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }
  Vector3 position(double i, double j, double k) const { return origin + i * step[0] + j * step[1] + k * step[2]; }
  std::array<double, 3> spacing() const { return {norm(step[0]), norm(step[1]), norm(step[2])}; }
  double voxel_mm3() const;  ///< > 0 unless the steps lie in a plane
};

Placement placement_of(const Grid& grid);

/// Rows of the inverse of the steps' matrix: index along a = dot(rows[a], point - origin). Needs voxel_mm3() > 0.
std::array<Vector3, 3> index_rows(const Placement& place);

/// The same voxels: as many, and none further than a hundredth of a voxel from its fellow.
bool same_place(const Placement& a, const Placement& b);

}  // namespace vallecula::pipeline
