#include "gui/import/given_labels.h"

#include <QCoreApplication>
#include <array>
#include <stdexcept>

#include "pipeline/package/label_map.h"

namespace vallecula::gui {

EditState with_given_labels(const EditState& before, const pipeline::Labels& map,
                            const std::set<std::uint8_t>& wanted) {
  std::array<bool, 256> present{};
  for (const std::uint8_t v : map.voxels) present[v] = true;
  std::set<std::uint8_t> taken;
  for (const auto& label : pipeline::kLabelNames)
    if (present[label.value] && (wanted.empty() || wanted.count(label.value) != 0)) taken.insert(label.value);
  if (taken.empty())
    throw std::runtime_error(
        (wanted.empty() ? QCoreApplication::translate(
                              "GivenLabels",
                              "the label map has none of the structures this program knows inside the scan; name its "
                              "segments as the list here does (tongue, airway, ...)")
                        : QCoreApplication::translate(
                              "GivenLabels",
                              "the label map has no voxel of this structure inside the scan; name its segment as it is "
                              "named in the list here"))
            .toStdString());

  auto labels = std::make_shared<pipeline::Labels>(before.labels ? *before.labels : pipeline::Labels(map.grid));
  for (std::size_t i = 0; i < map.voxels.size(); ++i) {
    std::uint8_t& v = labels->voxels[i];
    if (taken.count(map.voxels[i]) != 0)
      v = map.voxels[i];
    else if (taken.count(v) != 0)
      v = 0;
  }
  EditState next = before;
  next.labels = std::move(labels);
  next.replaced.insert(taken.begin(), taken.end());
  for (const auto& label : pipeline::kLabelNames)
    if (taken.count(label.value) != 0) next.accepted.erase(label.name);
  return next;
}

}  // namespace vallecula::gui
