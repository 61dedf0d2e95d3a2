// Label maps made elsewhere: NRRD and .seg.nrrd (3D Slicer), NIfTI, DICOM SEG, as they are on disk: any directions,
// overlapping segments, a part of the scan only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "pipeline/exchange/placement.h"
#include "pipeline/package/label_map.h"

namespace vallecula::pipeline {

struct LabelImage {
  Placement place;
  std::vector<std::uint16_t> sets;  ///< per voxel, bit (1 << label) for each label that holds it; i runs fastest
  std::set<std::uint8_t> labels;    ///< those that hold a voxel
  int left_out = 0;                 ///< segments with none of our names (their own are free text and not kept)
};

inline std::uint16_t bit_of(std::uint8_t label) { return static_cast<std::uint16_t>(1U << label); }

/// The format is told by the file's contents. Names are matched by label_of_name, then by SNOMED code; what has none of
/// our names is left out and counted. A file without names (NIfTI, a plain NRRD) is read by `values` (value in the file
/// to label), or when that is empty by the values of kLabelNames. Throws LabelMapError: what is wrong with the file and
/// how to mend it, also when it holds none of our structures.
LabelImage read_label_image(const std::filesystem::path& file, const std::map<int, std::uint8_t>& values = {});

/// Nearest neighbour, where two labels hold a voxel the finer structure (epiglottis before tongue ... skin last). Exact
/// when the grid is the image's own. Throws LabelMapError naming `file` when a label of the image has no voxel on the
/// grid: it belongs to another scan.
Labels on_grid(const LabelImage& image, const Grid& grid, const std::filesystem::path& file);

/// The image's voxels by the same rule on another image's, overlaps kept; 0 outside.
std::vector<std::uint16_t> sets_at(const LabelImage& image, const Placement& place);

}  // namespace vallecula::pipeline
