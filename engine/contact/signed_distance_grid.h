// The signed distance field of a closed rigid surface, sampled on a grid and read by trilinear interpolation: of the
// distance and of its exact gradient, so that normals turn smoothly about edges and never jump from cell to cell. Cells
// that an edge bends the field in may be sampled more finely.
#pragma once

#include <limits>
#include <vector>

#include "engine/tissue/float4.h"
#include "engine/types.h"

namespace vallecula::engine {

class TriangleBvh;

class SignedDistanceGrid {
 public:
  /// class_at() where no triangle lies within the band.
  static constexpr std::uint8_t kNoClass = 255;

  struct Sample {
    double distance;      ///< m, negative inside; +-band beyond the band
    Vec3 gradient;        ///< out of the solid, unit; zero beyond the band and where no side is nearer
  };

  SignedDistanceGrid() = default;
  /// Samples the box [low, high] with `spacing` (m); distances are exact within `band` of the surface and clamped to
  /// +-band beyond. `triangle_class` (may be empty) is carried to the grid: class_at() gives that of the nearest triangle.
  /// Where the field is bent by more than `tolerance` (m) in a cell within 0.3 mm of the surface, that cell is sampled three
  /// times as finely; infinity: nowhere.
  SignedDistanceGrid(const TriangleMesh& mesh, const Vec3& low, const Vec3& high, double spacing, double band,
                     const std::vector<std::uint8_t>& triangle_class = {},
                     double tolerance = std::numeric_limits<double>::infinity());

  /// Outside the box: distance +band, gradient zero.
  Sample sample(const Vec3& p) const noexcept;
  double distance(const Vec3& p) const noexcept;
  std::uint8_t class_at(const Vec3& p) const noexcept;
  /// Does p lie in the box?
  bool covers(const Vec3& p) const noexcept;
  std::size_t bytes() const noexcept;  ///< of its samples
  double band() const noexcept { return band_; }
  double spacing() const noexcept { return spacing_; }

 private:
  bool locate(const Vec3& p, int cell[3], float frac[3]) const noexcept;
  F4 interpolate(const int cell[3], const float frac[3]) const noexcept;
  bool bent(std::size_t cell, double tolerance) const;
  void refine(const TriangleBvh& bvh, double tolerance);
  std::size_t index(int i, int j, int k) const noexcept {
    return (static_cast<std::size_t>(k) * size_[1] + j) * size_[0] + i;
  }

  Vec3 low_ = Vec3::Zero();
  double spacing_ = 1.0, inverse_spacing_ = 1.0, band_ = 0.0;
  int size_[3] = {0, 0, 0};
  std::vector<Float4> values_;   ///< gradient and distance
  std::vector<std::int32_t> refined_;   ///< per cell: its place in fine_values_, -1: none; empty: none at all
  std::vector<Float4> fine_values_;     ///< kFinePerCell a refined cell
  std::vector<std::uint8_t> classes_;
};

}  // namespace vallecula::engine
