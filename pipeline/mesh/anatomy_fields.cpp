#include "pipeline/mesh/anatomy_fields.h"

#include <algorithm>

#include "pipeline/segment/border_field.h"

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
    // Gas that is not airway; beside an airway drawn by a person its border is that one's (below).
    if (inside && v <= 0.0F && s.airway.lumen.voxels[i] == 0 && s.replaced.count(kAirway) == 0) v = 1.0F;
    f.solid.voxels[i] = std::clamp(v, -1.0F, 1.0F);
  }
  if (!s.replaced.empty()) f.solid = with_border_of(f.solid, without(s.head.inside, s.airway.lumen));
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

Volume<float> bone_field(const Segmentation& s, std::uint8_t label, const Mask& bone, const Mask& other_bone) {
  constexpr float kHuPerMm = 350.0F;
  const auto box = bounds_of(bone, 4.0 * s.frame.scale);
  const auto here = cropped(bone, box);
  const auto near = distance_to(here);
  auto other = cropped(other_bone, box);
  auto field = count(other) > 0 ? between(here, other, 0.4 * s.frame.scale) : Volume<float>(here.grid, 1.0F);
  const auto hu = cropped(s.hu, box);
  const float reach = static_cast<float>(1.8 * std::max({hu.grid.spacing[0], hu.grid.spacing[1], hu.grid.spacing[2]}));
  const auto own = s.bone_hu.find(label);
  const auto border = static_cast<float>(own != s.bone_hu.end() ? own->second : s.thresholds.bone);
  Volume<float> grey(hu.grid);
  for (std::size_t i = 0; i < grey.voxels.size(); ++i)
    grey.voxels[i] = std::clamp((hu.voxels[i] - border) / kHuPerMm, -1.0F, 1.0F);
  if (s.replaced.count(label) != 0)
    grey = with_border_of(grey, where(cropped(s.labels, box), [label](std::uint8_t v) { return v == label; }));
  for (std::size_t i = 0; i < field.voxels.size(); ++i)
    field.voxels[i] = near.voxels[i] > reach ? -1.0F : std::min(grey.voxels[i], field.voxels[i]);
  return smoothed(field, 0.35 * s.frame.scale);
}

}  // namespace vallecula::pipeline
