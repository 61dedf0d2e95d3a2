// What a person says about a segmentation: points, thresholds, ready labels, moved landmarks.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "pipeline/package/patient_package.h"
#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// All in the scan's own frame, mm LPS. Names of structures as in kLabelNames, of landmarks as in kLandmarks.
struct Edits {
  std::map<std::string, Point> seeds;                       ///< a point inside the structure
  std::map<std::string, std::array<double, 2>> thresholds;  ///< lowest and highest HU of the structure
  std::optional<Labels> labels;                             ///< made elsewhere; on any grid along the patient's axes
  std::set<std::uint8_t> replaced;                          ///< the labels of it that stand instead of what is found
  std::map<std::string, Point> landmarks;                   ///< these stand instead of what is found
};

}  // namespace vallecula::pipeline
