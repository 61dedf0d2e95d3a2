// The manikin with its mouth shut: the tongue fills the mouth as in a closed one, the lips are joined. Made in the voxels
// of its scan from its true labels, so that the true tongue is known.
#pragma once

#include "pipeline/manikin/manikin.h"

namespace vallecula::pipeline {

/// `scan` of the unvaried term infant (seed 0): other seeds have other mouths.
inline void close_mouth(ManikinScan& scan) {
  const auto& g = scan.ct.grid;
  for (std::size_t i = 0; i < g.count(); ++i) {
    const auto [x, y, z] = g.position(i);
    auto& label = scan.labels.voxels[i];
    const double roof = 1.8 - 0.55 * std::max(0.0, y - 14.0);
    const bool mouth = label == kAirway && y < 27.5 && z > -33.0 && z < roof;
    const bool lips = label == kBackground && std::abs(x) < 18.0 && y > -4.5 && y < 12.0 && z > -25.0 && z < 6.0;
    if (!mouth && !lips) continue;
    const bool tongue = mouth && y > 5.5 && std::abs(x) < 14.0;
    label = tongue ? kTongue : kSkin;
    scan.ct.voxels[i] = static_cast<std::int16_t>(tongue ? 55 : 40);
  }
}

}  // namespace vallecula::pipeline
