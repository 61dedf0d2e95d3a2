// A regular grid of voxels whose axes are the patient's: x to the left, y to the back, z to the head (LPS, mm).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vallecula::pipeline {

/// Where the voxels lie. Everything behind the reader is axis aligned, so no directions are kept.
struct Grid {
  std::array<int, 3> size{0, 0, 0};              ///< voxels in x, y, z; x runs fastest in memory
  std::array<double, 3> spacing{1.0, 1.0, 1.0};  ///< mm
  std::array<double, 3> origin{0.0, 0.0, 0.0};   ///< centre of voxel (0, 0, 0), mm LPS

  std::size_t count() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }
  std::size_t index(int x, int y, int z) const { return (static_cast<std::size_t>(z) * size[1] + y) * size[0] + x; }
  bool contains(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < size[0] && y < size[1] && z < size[2];
  }
  std::array<int, 3> cell(std::size_t i) const {
    const auto row = static_cast<std::size_t>(size[0]);
    const auto rest = i / row;
    return {static_cast<int>(i % row), static_cast<int>(rest % size[1]), static_cast<int>(rest / size[1])};
  }
  std::array<double, 3> position(double x, double y, double z) const {
    return {origin[0] + x * spacing[0], origin[1] + y * spacing[1], origin[2] + z * spacing[2]};
  }
  std::array<double, 3> position(std::size_t i) const {
    const auto c = cell(i);
    return position(c[0], c[1], c[2]);
  }
  /// The voxel whose centre is nearest to a point (it may lie outside the grid: see contains).
  std::array<int, 3> nearest(const std::array<double, 3>& p) const {
    std::array<int, 3> c{};
    for (int a = 0; a < 3; ++a) c[a] = static_cast<int>(std::lround((p[a] - origin[a]) / spacing[a]));
    return c;
  }
  double voxel_mm3() const { return spacing[0] * spacing[1] * spacing[2]; }
};

template <class T>
struct Volume {
  Grid grid;
  std::vector<T> voxels;  ///< grid.count() values

  Volume() = default;
  explicit Volume(const Grid& g, T value = T()) : grid(g), voxels(g.count(), value) {}
  T& at(int x, int y, int z) { return voxels[grid.index(x, y, z)]; }
  const T& at(int x, int y, int z) const { return voxels[grid.index(x, y, z)]; }
};

using Hounsfield = Volume<std::int16_t>;
using Labels = Volume<std::uint8_t>;
using Mask = Volume<std::uint8_t>;  ///< 0 or 1

}  // namespace vallecula::pipeline
