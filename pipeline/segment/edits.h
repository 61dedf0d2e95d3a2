// What a person says about a segmentation: points, thresholds, ready labels, moved landmarks.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "pipeline/package/patient_package.h"
#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// The highest HU of skin, which has none: what is denser and no other structure is skin too.
constexpr double kNoHighest = std::numeric_limits<double>::infinity();

/// All in the scan's own frame, mm LPS. Names of structures as in kLabelNames, of landmarks as in kLandmarks.
struct Edits {
  std::map<std::string, Point> seeds;                       ///< a point inside the structure
  std::map<std::string, std::array<double, 2>> thresholds;  ///< lowest and highest HU
  std::optional<Labels> labels;                             ///< made elsewhere; on any grid along the patient's axes
  std::set<std::uint8_t> replaced;                          ///< the labels of it that stand instead of what is found
  std::map<std::string, Point> landmarks;                   ///< these stand instead of what is found
};

/// Names the edit, what is wrong with it and how to mend it.
class EditError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Are the names known and the numbers sensible (finite, lowest below highest)? Throws EditError. Needs no scan.
void check_edits(const Edits& edits);
/// Do the seeds lie in the scan, and the landmarks no further from it than a carina below its end? Throws EditError.
void check_edits_in(const Edits& edits, const Grid& scan);

}  // namespace vallecula::pipeline
