// The head's outside where the rigid field, which is sampled about tongue and gums only, does not reach: face, cheeks,
// nose and neck, as a coarser distance field of the same surface. It stops what the second hand holds.
#pragma once

#include <memory>

#include "engine/contact/signed_distance_grid.h"

namespace vallecula::engine {

class SkinField {
 public:
  /// m; a face is round: between samples 2 mm apart it is off by 0.02 mm in the mean, by up to 0.9 mm in a nostril.
  static constexpr double kSpacing = 0.002, kBand = 0.005;
  /// m: what lies deeper beneath the skin than this is not met; not all of the band, whose last cells know one side
  /// only.
  static constexpr double kDeepest = 0.0035;

  SkinField() = default;  ///< none: everything is outside
  /// Samples all of a closed surface (m).
  explicit SkinField(const TriangleMesh& head);

  bool empty() const noexcept { return grid_ == nullptr; }
  /// kBand and more from the skin: its distance is +-kBand, without a gradient.
  SignedDistanceGrid::Sample sample(const Vec3& x) const noexcept {
    return grid_ ? grid_->sample(x) : SignedDistanceGrid::Sample{kBand, Vec3::Zero()};
  }
  std::size_t bytes() const noexcept { return grid_ ? grid_->bytes() : 0; }

 private:
  std::shared_ptr<const SignedDistanceGrid> grid_;  ///< with other scenes of the same head
};

}  // namespace vallecula::engine
