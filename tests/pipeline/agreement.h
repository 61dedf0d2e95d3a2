// How far a segmentation agrees with labels that it did not make: what `vallecula compare` would say of the two.
#pragma once

#include <map>

#include "pipeline/exchange/compare.h"
#include "pipeline/volume.h"

namespace vallecula::pipeline::test {

/// Structure by structure; both on one grid. `joined` gives a label another one's name in both, as where skull and
/// mandible are asked for as one bone.
inline std::map<std::uint8_t, LabelAgreement> agreement_of(const Labels& truth, const Labels& found,
                                                           const std::map<std::uint8_t, std::uint8_t>& joined = {}) {
  const auto image = [&](const Labels& labels) {
    LabelImage out;
    out.place = placement_of(labels.grid);
    out.sets.reserve(labels.voxels.size());
    for (const auto label : labels.voxels) {
      const auto as = joined.find(label);
      out.sets.push_back(label == kBackground ? 0 : bit_of(as == joined.end() ? label : as->second));
    }
    return out;
  };
  std::map<std::uint8_t, LabelAgreement> by_label;
  for (const auto& item : compare_labels(image(truth), image(found)).structures) by_label[item.label] = item;
  return by_label;
}

}  // namespace vallecula::pipeline::test
