// The pictures of a folder sorted into series, each with what can be made of it; and the one that is meant.
#pragma once

#include <string>
#include <vector>

#include "pipeline/dicom/file_list.h"
#include "pipeline/dicom/series_entry.h"
#include "pipeline/dicom/stack.h"

namespace vallecula::pipeline {

struct SeriesGroup {
  std::vector<Picture> pictures;
  std::string series;  ///< UID, never shown
  StackPlan plan;      ///< of a CT
  SeriesEntry entry;
  std::string mend;       ///< goes with entry.reason
  bool readable = false;  ///< makes a volume, though perhaps not one to import
  int slices() const { return static_cast<int>(plan.places.size()); }
};

/// One group for what shares series, matrix, spacing, orientation and scan (a series that holds several phases or
/// acquisitions of one place is taken apart). Numbered: usable ones first, then by slices.
std::vector<SeriesGroup> group_pictures(std::vector<Picture> pictures, const FileList& files);

/// What is needed of a series.
enum class Purpose { import, volume };

/// `choice`: a number of the list, a series instance UID, or empty for the only series that can be meant. Notes on what
/// was left out are appended to the group's plan. Throws SeriesError.
SeriesGroup& choose(std::vector<SeriesGroup>& groups, const std::string& choice, Purpose purpose);

}  // namespace vallecula::pipeline
