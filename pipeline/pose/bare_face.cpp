#include "pipeline/pose/bare_face.h"

namespace vallecula::pipeline {
namespace {

// Thinner than any lip, between chin and nose, where nothing of a face has open air behind it (term).
constexpr double kThin = 4.0;
constexpr double kGap = 2.5;   ///< of air behind it at least: less is a crease of the lips (term)
constexpr double kBelowGum = 8.0;  ///< of the lower
constexpr double kAboveGum = 12.0;
constexpr double kAside = 22.0;

}  // namespace

double bare_face(Segmentation& s) {
  if (!s.head.lips.empty()) return 0.0;
  const double k = s.frame.scale;
  const auto& g = s.hu.grid;
  const Vector3 upper = s.landmarks.at("upper_gum_midline");
  const Vector3 lower = s.landmarks.at("lower_gum_midline");
  const auto box = box_between(g, {s.frame.mid_x - kAside * k, -1e6, lower[2] - kBelowGum * k},
                               {s.frame.mid_x + kAside * k, upper[1] + 10.0 * k, upper[2] + kAboveGum * k});
  std::size_t taken = 0;
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int x = box.low[0]; x <= box.high[0]; ++x) {
      int y = box.low[1];
      while (y <= box.high[1]) {
        while (y <= box.high[1] && s.head.inside.at(x, y, z) == 0) ++y;
        int end = y;
        while (end <= box.high[1] && s.head.inside.at(x, end, z) != 0) ++end;
        if (end > box.high[1] || (end - y) * g.spacing[1] > kThin * k) break;
        int face = end;
        while (face <= box.high[1] && s.head.inside.at(x, face, z) == 0) ++face;
        if (face > box.high[1] || (face - end) * g.spacing[1] < kGap * k) break;
        for (; y < end; ++y) {
          const auto i = g.index(x, y, z);
          s.head.body.voxels[i] = 0;
          s.head.inside.voxels[i] = 0;
          s.bones.skull.voxels[i] = 0;  // wire
          s.labels.voxels[i] = kBackground;
          ++taken;
        }
      }
    }
  }
  return static_cast<double>(taken) * g.voxel_mm3();
}

}  // namespace vallecula::pipeline
