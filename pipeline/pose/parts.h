// What moves with what when the mouth is opened and the neck extended: said voxel by voxel of the scan.
#pragma once

#include "pipeline/pose/aim.h"

namespace vallecula::pipeline {

/// What a voxel is tied to. Of two in one place the later in this list counts.
enum class Tie : std::uint8_t { none = 0, neck = 1, hyoid = 2, jaw = 3, skull = 4 };

/// Where a soft place is drawn to; a spring, not a tie.
struct Pull {
  Vector3 at{};
  Vector3 way{};
  double radius_mm = 0.0;
  float weight = 1.0F;  ///< against the tissue's own springs; of several on a node the strongest counts
};

struct Parts {
  Mask lower;                     ///< tongue and lower lip, which part from the rest along `cut`
  Volume<std::uint8_t> ties;      ///< Tie
  Volume<float> stiffness;        ///< of the tissue against being sheared: 1 is soft tissue
  std::vector<Vector3> cut;       ///< middles of the voxel faces along which `lower` comes free
  std::vector<Pull> upper_pulls;  ///< of the upper lip
  std::vector<Pull> lower_pulls;  ///< of the lower lip
  std::vector<LipGap> lips;       ///< edges of the lips at rest, one above the other where they are closed
  double top_z = 0.0;             ///< nothing at or above this height moves
};

Parts parts_of(const Segmentation& s, const Aim& aim);

/// Where what is tied goes. The hyoid hangs between jaw and larynx.
Vector3 tied(Tie tie, const Aim& aim, const Vector3& p);

}  // namespace vallecula::pipeline
