// A volume as a DICOM series of CT Image Storage, one file a slice.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// What a series says about itself. Dates stay empty (type 2 attributes), so that equal input gives equal files.
struct SeriesDescription {
  std::string patient_id;
  std::string patient_name;
  double patient_weight_kg = 0.0;  ///< left out when 0
  std::string study_description;
  std::string series_description;
  std::string unique_key;  ///< the UIDs are made from this: equal keys give equal UIDs, different keys different ones
};

/// Writes `volume` (axis aligned, LPS, -1024 .. 3071 HU) as ct-0001.dcm ... from the feet to the head into `dir`, which
/// exists. Explicit VR little endian, 12 bits stored, rescale intercept -1024. Throws std::runtime_error naming the
/// file when it cannot be written; files already written are left to the caller.
void write_ct_series(const Hounsfield& volume, const SeriesDescription& description, const std::filesystem::path& dir,
                     const std::function<void(double fraction)>& progress = {});

}  // namespace vallecula::pipeline
