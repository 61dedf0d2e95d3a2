#include "pipeline/exchange/label_image.h"

#include <algorithm>
#include <cmath>

#include "pipeline/exchange/label_names.h"
#include "pipeline/exchange/label_readers.h"
#include "pipeline/parallel.h"

namespace vallecula::pipeline {
namespace {

/// Where two labels hold a voxel the later of these has it.
constexpr std::array<std::uint8_t, 10> kCoarseToFine = {kSkin,       kSpine,  kSkull,      kMandible, kAirway,
                                                        kOesophagus, kLarynx, kSoftPalate, kTongue,   kEpiglottis};

std::uint8_t finest(std::uint16_t set) {
  std::uint8_t label = kBackground;
  for (const auto candidate : kCoarseToFine) {
    if ((set & bit_of(candidate)) != 0) label = candidate;
  }
  return label;
}

/// Calls set_at(i of `onto`, set) for each voxel of `onto` in rows side by side.
template <class Write>
void resample(const LabelImage& image, const Placement& onto, const Write& write) {
  const auto rows = index_rows(image.place);
  const auto& size = image.place.size;
  // Per step along an axis of `onto`: so many voxels of the image.
  std::array<Vector3, 3> per_step{};
  Vector3 start{};
  for (int a = 0; a < 3; ++a) {
    start[a] = dot(rows[a], onto.origin - image.place.origin);
    for (int b = 0; b < 3; ++b) per_step[b][a] = dot(rows[a], onto.step[b]);
  }
  parallel_for(onto.size[2], [&](int k) {
    std::size_t at = static_cast<std::size_t>(k) * onto.size[0] * onto.size[1];
    for (int j = 0; j < onto.size[1]; ++j) {
      const Vector3 row = start + static_cast<double>(k) * per_step[2] + static_cast<double>(j) * per_step[1];
      for (int i = 0; i < onto.size[0]; ++i, ++at) {
        std::array<int, 3> c{};
        bool inside = true;
        for (int a = 0; a < 3 && inside; ++a) {
          const double v = std::floor(row[a] + i * per_step[0][a] + 0.5);
          inside = v >= 0.0 && v < size[a];
          c[a] = inside ? static_cast<int>(v) : 0;
        }
        if (!inside) continue;
        const auto from = (static_cast<std::size_t>(c[2]) * size[1] + c[1]) * size[0] + c[0];
        if (image.sets[from] != 0) write(at, image.sets[from]);
      }
    }
  });
}

std::set<std::uint8_t> labels_in(const std::vector<std::uint16_t>& sets) {
  unsigned all = 0;
  for (const auto set : sets) all |= set;
  std::set<std::uint8_t> labels;
  for (const auto& label : kLabelNames) {
    if ((all & bit_of(label.value)) != 0) labels.insert(label.value);
  }
  return labels;
}

}  // namespace

void ValueTable::add(int layer, int value, std::uint8_t label) {
  auto& table = layers_.at(static_cast<std::size_t>(layer));
  if (table.size() <= static_cast<std::size_t>(value)) table.resize(static_cast<std::size_t>(value) + 1, 0);
  table[static_cast<std::size_t>(value)] |= bit_of(label);
}

std::optional<std::uint8_t> segment_label(const std::string& name, const std::string& snomed, int& left_out) {
  if (const auto label = label_of_name(name)) return label;
  if (const auto label = label_of_code(snomed)) return label;
  ++left_out;
  return std::nullopt;
}

void fill_sets(LabelImage& image, const std::filesystem::path& file, const VoxelLayout& layout, const ValueTable& table,
               bool unnamed) {
  const int layers = table.layers();
  check_enough_bytes(file, layout, image.place.count() * static_cast<std::size_t>(layers));
  image.sets.assign(image.place.count(), 0);
  std::size_t voxel = 0;
  int layer = 0;
  const auto count = image.place.count() * static_cast<std::size_t>(layers);
  read_voxels(file, layout, count, [&](const double* values, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      const double v = values[i];
      if (v != 0.0) {
        if (!(v > 0.0 && v < 65536.0) || v != std::floor(v))
          fail_label_file(file, "it holds values that are no labels (whole numbers from 0 to 65535)");
        const auto set = table.sets(layer, v);
        if (set == 0 && unnamed) {
          fail_label_file(file, "it holds the value " + std::to_string(static_cast<int>(v)) +
                                    " and no names; say what its values mean: --label-value tongue=" +
                                    std::to_string(static_cast<int>(v)) + " (those named are read, the rest left out)");
        }
        image.sets[voxel] |= set;
      }
      if (++layer == layers) {
        layer = 0;
        ++voxel;
      }
    }
  });
}

ValueTable unnamed_table(const std::map<int, std::uint8_t>& values) {
  ValueTable table(1);
  for (const auto& [value, label] : values) table.add(0, value, label);
  if (values.empty()) {
    for (const auto& label : kLabelNames) table.add(0, label.value, label.value);
  }
  return table;
}

LabelImage read_label_image(const std::filesystem::path& file, const std::map<int, std::uint8_t>& values) {
  const auto head = first_bytes(file, 600);
  LabelImage image;
  if (head.rfind("NRRD000", 0) == 0) {
    image = read_nrrd_labels(file, values);
  } else if (head.size() >= 132 && head.compare(128, 4, "DICM") == 0) {
    image = read_dicom_segmentation(file);
  } else if (head.size() >= 348 &&
             (head.compare(344, 4, std::string("n+1\0", 4)) == 0 || head.compare(4, 4, std::string("n+2\0", 4)) == 0)) {
    image = read_nifti_labels(file, values);
  } else {
    fail_label_file(file,
                    "not a label map this program reads; expected NRRD (.nrrd, .seg.nrrd), NIfTI (.nii, .nii.gz) "
                    "or a DICOM segmentation");
  }
  image.labels = labels_in(image.sets);
  if (image.labels.empty()) fail_label_file(file, "it holds none of the structures known here: " + known_label_names());
  return image;
}

Labels on_grid(const LabelImage& image, const Grid& grid, const std::filesystem::path& file) {
  Labels out(grid);
  const auto onto = placement_of(grid);
  std::vector<std::uint16_t> rows(static_cast<std::size_t>(grid.size[2]), 0);  // what each slice holds
  const auto slice = static_cast<std::size_t>(grid.size[0]) * grid.size[1];
  resample(image, onto, [&](std::size_t i, std::uint16_t set) {
    out.voxels[i] = finest(set);
    rows[i / slice] |= set;
  });
  const auto there = labels_in(rows);
  for (const auto label : image.labels) {
    if (there.count(label) != 0) continue;
    fail_label_file(file, name_of_label(label) +
                              " lies outside the scan; is this the label map of another scan, or in another frame than "
                              "the scan's own?");
  }
  return out;
}

std::vector<std::uint16_t> sets_at(const LabelImage& image, const Placement& place) {
  std::vector<std::uint16_t> out(place.count(), 0);
  resample(image, place, [&](std::size_t i, std::uint16_t set) { out[i] = set; });
  return out;
}

}  // namespace vallecula::pipeline
