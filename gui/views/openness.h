// How open to the surrounding light a point of a surface is: what makes creases, nostrils and the depth of a mouth
// dark.
#pragma once

#include <vtkPolyData.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vallecula::gui {

/// Solids on a voxel grid, through which rays are cast. Built once; reading is thread-safe.
class Openness {
 public:
  /// Closed surfaces (mm). `reach_mm`: how far away a wall still takes light.
  Openness(const std::vector<vtkPolyData*>& solids, double reach_mm);
  /// 0 (buried) .. 1 (open sky): cosine-weighted share of free directions about the unit normal.
  double at(const std::array<double, 3>& point_mm, const std::array<double, 3>& normal) const;

 private:
  bool solid(double x, double y, double z) const;
  std::array<double, 3> origin_{};
  std::array<int, 3> size_{};
  double spacing_ = 1.0, reach_ = 0.0;
  std::vector<std::uint8_t> voxels_;
  std::vector<std::array<double, 3>> directions_;  ///< about +z, cosine-weighted
};

}  // namespace vallecula::gui
