// Lengths and angles taken on a slice, in the scan's own millimetres.
#pragma once

#include <string>
#include <vector>

#include "gui/views/slice_plane.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// Two points: a length. Three: the angle at the second.
struct Measure {
  SlicePlane plane = SlicePlane::axial;
  std::vector<pipeline::Point> points;  ///< mm, LPS
};

double length_mm(const pipeline::Point& a, const pipeline::Point& b);
/// Between the legs from `corner`, 0..180; 0 when a leg has no length.
double angle_deg(const pipeline::Point& a, const pipeline::Point& corner, const pipeline::Point& b);
/// "12.3 mm", "45.0°"; empty for one point.
std::string text_of(const Measure& measure);

}  // namespace vallecula::gui
