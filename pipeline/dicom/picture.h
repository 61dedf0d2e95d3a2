// One picture (a slice, or a frame of a multi-frame file) as the header describes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/dicom/ct_volume.h"

namespace vallecula::pipeline {

struct Picture {
  int file = 0;    ///< number in the FileList
  int frame = 0;   ///< number in the file
  int frames = 1;  ///< of the file

  // For grouping only, never shown or kept.
  std::string series;    ///< series instance UID
  std::string instance;  ///< SOP instance UID
  /// What may tell repeated scans of one place apart, most telling first: temporal position, acquisition, trigger time,
  /// stack, image type, kernel, tube voltage.
  std::vector<std::string> phases;

  std::string modality;  ///< one of the standard's terms, or "other"
  std::string kernel;    ///< reconstruction kernel where it is one of the usual names, else empty
  bool has_pixels = false;
  bool localizer = false;
  bool colour = false;

  int columns = 0;
  int rows = 0;
  std::array<double, 2> spacing{0, 0};  ///< mm along a row, along a column
  Vector3 position{};                   ///< centre of the first voxel, mm LPS
  Vector3 row{};                        ///< unit direction along a row
  Vector3 column{};                     ///< unit direction along a column

  double slope = 1.0;
  double intercept = 0.0;
  std::optional<std::pair<double, double>> padding;  ///< stored values, from and to, that are no tissue

  std::string fault;  ///< why the picture cannot be used, and the mend; empty when it can
};

/// All pictures of a DICOM file, or one without pixels when it holds none; nothing when it is no image of DICOM. The
/// pixels stay unread. Never throws for what is in the file: see Picture::fault.
std::vector<Picture> read_pictures(std::string_view bytes, int file);

}  // namespace vallecula::pipeline
