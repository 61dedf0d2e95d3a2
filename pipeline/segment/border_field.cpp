#include "pipeline/segment/border_field.h"

#include <algorithm>

namespace vallecula::pipeline {

Volume<float> with_border_of(const Volume<float>& grey, const Mask& mask) {
  auto out = grey;
  Mask against(grey.grid);
  for (std::size_t i = 0; i < out.voxels.size(); ++i) {
    out.voxels[i] = std::clamp(out.voxels[i], -1.0F, 1.0F);
    against.voxels[i] = (out.voxels[i] > 0.0F) != (mask.voxels[i] != 0) ? 1 : 0;
  }
  if (count(against) == 0) return out;
  const auto& s = grey.grid.spacing;
  const double voxel = std::max({s[0], s[1], s[2]});
  const auto box = bounds_of(against, 6.0 * voxel);
  auto own = signed_distance(cropped(mask, box));
  for (auto& v : own.voxels) v = std::clamp(v, -1.5F, 1.5F);
  own = smoothed(own, 0.6 * voxel);
  const auto share = smoothed(to_float(dilated(cropped(against, box), 1.5 * voxel)), 0.6 * voxel);
  auto here = cropped(out, box);
  for (std::size_t i = 0; i < here.voxels.size(); ++i) {
    const float w = share.voxels[i];
    here.voxels[i] = (1.0F - w) * here.voxels[i] + w * std::clamp(own.voxels[i], -1.0F, 1.0F);
  }
  paste(here, box, out);
  return out;
}

}  // namespace vallecula::pipeline
