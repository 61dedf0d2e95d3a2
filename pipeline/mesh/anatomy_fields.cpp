#include "pipeline/mesh/anatomy_fields.h"

#include <algorithm>

namespace vallecula::pipeline {
namespace {

/// Positive nearer to `a` than to `b`, smoothed.
Volume<float> between(const Mask& a, const Mask& b, double sigma_mm) {
  const auto to_a = distance_to(a);
  auto field = distance_to(b);
  for (std::size_t i = 0; i < field.voxels.size(); ++i) {
    field.voxels[i] = std::clamp(field.voxels[i] - to_a.voxels[i], -6.0F, 6.0F);
  }
  return smoothed(field, sigma_mm);
}

}  // namespace

AnatomyFields fields_of(const Segmentation& s) {
  AnatomyFields f;
  const auto& g = s.hu.grid;
  // The scanner's blur spreads the step from air to tissue over about a millimetre: 700 HU a mm.
  constexpr float kHuPerMm = 700.0F;
  f.solid = Volume<float>(g);
  for (std::size_t i = 0; i < g.count(); ++i) {
    float v = (s.hu.voxels[i] - static_cast<float>(s.thresholds.air)) / kHuPerMm;
    const bool inside = s.head.inside.voxels[i] != 0;
    if (!inside && v > 0.0F) v = -1.0F;                                  // couch, mask
    if (inside && v <= 0.0F && s.airway.lumen.voxels[i] == 0) v = 1.0F;  // gas that is not airway
    f.solid.voxels[i] = std::clamp(v, -1.0F, 1.0F);
  }
  const auto labels = cropped(s.labels, s.throat);
  const auto soft = where(labels, [](std::uint8_t v) { return v == kTongue || v == kEpiglottis; });
  const auto rest = where(
      labels, [](std::uint8_t v) { return v != kTongue && v != kEpiglottis && v != kAirway && v != kBackground; });
  f.soft = between(soft, rest, 0.6 * s.frame.scale);

  const auto box = bounds_of(s.airway.lumen, 6.0 * s.frame.scale);
  const auto lumen = cropped(s.airway.lumen, box);
  const auto outer = inverted(cropped(s.head.inside, box));
  f.airway_side = count(outer) > 0 ? between(lumen, outer, 0.5 * s.frame.scale) : Volume<float>(lumen.grid, 1.0F);
  return f;
}

Volume<float> bone_field(const Segmentation& s, const Mask& bone, const Mask& other_bone) {
  constexpr float kHuPerMm = 350.0F;
  const auto box = bounds_of(bone, 4.0 * s.frame.scale);
  const auto here = cropped(bone, box);
  const auto near = distance_to(here);
  auto other = cropped(other_bone, box);
  auto field = count(other) > 0 ? between(here, other, 0.4 * s.frame.scale) : Volume<float>(here.grid, 1.0F);
  const auto hu = cropped(s.hu, box);
  const float reach = static_cast<float>(1.8 * std::max({hu.grid.spacing[0], hu.grid.spacing[1], hu.grid.spacing[2]}));
  for (std::size_t i = 0; i < field.voxels.size(); ++i) {
    const float v = std::clamp((hu.voxels[i] - static_cast<float>(s.thresholds.bone)) / kHuPerMm, -1.0F, 1.0F);
    field.voxels[i] = near.voxels[i] > reach ? -1.0F : std::min(v, field.voxels[i]);
  }
  return smoothed(field, 0.35 * s.frame.scale);
}

}  // namespace vallecula::pipeline
