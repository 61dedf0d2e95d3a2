#include "pipeline/exchange/edit_files.h"

#include <algorithm>

#include "pipeline/exchange/label_image.h"
#include "pipeline/exchange/label_names.h"
#include "pipeline/exchange/landmark_file.h"
#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {
namespace {

/// Structures of which more than a twentieth lies beside the scan.
void remark_on_cut(const LabelImage& image, const Labels& labels, std::vector<std::string>& remarks) {
  std::array<double, 256> on_scan{};
  for (const auto v : labels.voxels) on_scan[v] += labels.grid.voxel_mm3();
  for (const auto label : image.labels) {
    const auto bit = bit_of(label);
    const auto finer = static_cast<std::uint16_t>(~bit);
    // Overlaps go to the finer structure: only voxels of this label alone can be compared.
    const auto alone = std::count_if(image.sets.begin(), image.sets.end(),
                                     [&](std::uint16_t set) { return (set & bit) != 0 && (set & finer) == 0; });
    const double mm3 = static_cast<double>(alone) * image.place.voxel_mm3();
    if (on_scan[label] < 0.95 * mm3)
      remarks.push_back(name_of_label(label) + " of the label map reaches beyond the scan and was cut there");
  }
}

/// Of a structure in pieces only the largest is meshed.
void remark_on_pieces(const Labels& labels, std::vector<std::string>& remarks) {
  for (const auto label : {kTongue, kMandible, kAirway, kEpiglottis}) {
    const auto mask = where(labels, [label](std::uint8_t v) { return v == label; });
    const auto box = bounds_of(mask);
    if (box.empty()) continue;
    const auto parts = components(cropped(mask, box));
    if (parts.sizes.size() > 2 && parts.sizes[2] * 100 > parts.sizes[1])
      remarks.push_back(name_of_label(label) + " of the label map is in pieces; its surface is that of the largest");
  }
}

}  // namespace

std::vector<std::string> add_edit_files(const EditFiles& files, const Grid& scan, Edits& edits) {
  std::vector<std::string> remarks;
  if (!files.labels.empty()) {
    const auto image = read_label_image(files.labels, files.label_values);
    edits.labels = on_grid(image, scan, files.labels);
    edits.replaced = image.labels;
    std::string names;
    for (const auto label : image.labels) names += (names.empty() ? "" : ", ") + name_of_label(label);
    remarks.push_back("from the label map: " + names +
                      (same_place(image.place, placement_of(scan)) ? "" : "; resampled onto the scan's grid"));
    if (image.left_out > 0) {
      remarks.push_back(std::to_string(image.left_out) +
                        " segments of the label map have none of the names known and were left out");
    }
    remark_on_cut(image, *edits.labels, remarks);
    remark_on_pieces(*edits.labels, remarks);
  }
  if (!files.landmarks.empty()) {
    const auto given = read_landmark_file(files.landmarks);
    std::string names;
    for (const auto& [name, point] : given.moved) {
      edits.landmarks.emplace(name, point);
      names += (names.empty() ? "" : ", ") + name;
    }
    remarks.push_back(names.empty() ? "no landmark of the landmark file was moved" : "landmarks as given: " + names);
    if (given.left_out > 0) {
      remarks.push_back(std::to_string(given.left_out) +
                        " points of the landmark file have none of the names known and were left out");
    }
  }
  return remarks;
}

}  // namespace vallecula::pipeline
