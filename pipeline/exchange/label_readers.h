// One reader a format; read_label_image (label_image.h) chooses.
#pragma once

#include <optional>

#include "pipeline/exchange/label_image.h"
#include "pipeline/exchange/voxel_stream.h"

namespace vallecula::pipeline {

/// What the values of a file mean: one table a layer, from value (0..65535) to the set of labels.
class ValueTable {
 public:
  explicit ValueTable(int layers) : layers_(layers) {}
  void add(int layer, int value, std::uint8_t label);
  int layers() const { return static_cast<int>(layers_.size()); }
  std::uint16_t sets(int layer, double value) const {
    const auto v = static_cast<std::size_t>(value);
    const auto& table = layers_[layer];
    return v < table.size() ? table[v] : 0;
  }

 private:
  std::vector<std::vector<std::uint16_t>> layers_;
};

/// The label that a segment is, by name, else by code; an unknown one is counted.
std::optional<std::uint8_t> segment_label(const std::string& name, const std::string& snomed, int& left_out);

/// Fills `image.sets` from the voxels of a file. `unnamed`: the values come without names, so that one the table does
/// not know (0 apart) is refused rather than left out. Throws LabelMapError.
void fill_sets(LabelImage& image, const std::filesystem::path& file, const VoxelLayout& layout, const ValueTable& table,
               bool unnamed);

/// For files without names: `values`, or kLabelNames' own.
ValueTable unnamed_table(const std::map<int, std::uint8_t>& values);

LabelImage read_nrrd_labels(const std::filesystem::path& file, const std::map<int, std::uint8_t>& values);
LabelImage read_nifti_labels(const std::filesystem::path& file, const std::map<int, std::uint8_t>& values);
/// By the helper program: damaged files can end the process that reads them. Throws LabelMapError, also on its death.
LabelImage read_dicom_segmentation(const std::filesystem::path& file);
/// In this process: only the helper does it. Throws LabelMapError, std::bad_alloc. `image.labels` stays empty.
LabelImage parsed_dicom_segmentation(const std::filesystem::path& file);

}  // namespace vallecula::pipeline
