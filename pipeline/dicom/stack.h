// How pictures lie upon each other: their order, holes, doubles, and the grid they make.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/dicom/picture.h"

namespace vallecula::pipeline {

struct StackPlan {
  std::vector<std::vector<std::size_t>> places;  ///< pictures (by number) at each place, along the slices' normal
  CtGeometry geometry;                           ///< of the volume to be made
  /// For each slice of `geometry`: the place it comes from and the share of the next place in it, [0, 1).
  std::vector<std::pair<int, double>> sources;
  std::vector<std::string> notes;
  std::string fault;  ///< why no volume can be made of it, and the mend

  bool interpolated() const;  ///< is any slice of the volume not just one of those read?
};

/// Places closer than this are one (mm along the normal).
constexpr double kSamePlaceMm = 0.01;

/// The pictures have one matrix, spacing and orientation.
StackPlan plan_stack(const std::vector<Picture>& pictures);

/// Where a picture lies along the common normal, mm.
double place_of(const Picture& picture, const Picture& first);

/// "axial", "axial, 12.0 degrees off"
std::string orientation_words(const CtGeometry& geometry);

std::string millimetres_text(double value);  ///< "7.5 mm"
std::string degrees_text(double value);      ///< "12.3 degrees"

}  // namespace vallecula::pipeline
