// Reads one CT series from a folder into Hounsfield units on a grid along the patient's axes.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// Says what is wrong, with which file, and how to mend it. File names appear, contents of identifying fields never.
class SeriesError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CtSeries {
  Hounsfield hu;  ///< HU, axial order; x to the left, y to the back, z to the head
  int slices = 0;
  std::array<int, 2> matrix{0, 0};                ///< columns, rows of the source
  std::array<double, 3> source_spacing{0, 0, 0};  ///< mm: along a row, along a column, between slices (from positions)
  bool resampled = false;                         ///< the source was oblique, so voxels were interpolated
  std::vector<std::string> notes;                 ///< what a person should know, for instance files left out
};

/// Sorts by position along the slice normal, takes the spacing from the positions, applies the rescale of each slice,
/// turns or resamples the volume onto the patient's axes (tilted gantries included). Files of `folder` that are no
/// DICOM images are ignored. `progress` gets 0..1. Throws SeriesError.
CtSeries read_ct_series(const std::filesystem::path& folder, const std::function<void(double)>& progress = {});

}  // namespace vallecula::pipeline
