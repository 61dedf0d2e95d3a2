// One DICOM slice as it lies in its file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/volume.h"

namespace vallecula::pipeline {

struct SliceHeader {
  std::filesystem::path file;
  std::string series;  ///< series instance UID: for grouping only, never shown or kept
  std::string modality;
  bool has_pixels = false;
  int frames = 1;
};

struct Slice {
  std::filesystem::path file;
  int columns = 0;
  int rows = 0;
  std::array<double, 2> spacing{0, 0};  ///< mm along a row, along a column
  std::array<double, 3> position{};     ///< centre of the first voxel, mm LPS
  std::array<double, 3> row{};          ///< unit direction along a row
  std::array<double, 3> column{};       ///< unit direction along a column
  std::vector<std::int16_t> hu;
};

/// Without the pixels. Nothing when the file is no DICOM file; throws SeriesError when it claims to be one (by its
/// marker or by the ending .dcm) and cannot be parsed.
std::optional<SliceHeader> read_slice_header(const std::filesystem::path& file);

/// With the pixels, rescaled to HU; padding becomes -1024. Throws SeriesError.
Slice read_slice(const std::filesystem::path& file);

}  // namespace vallecula::pipeline
