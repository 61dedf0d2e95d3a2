#include "gui/views/slice_measure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vallecula::gui {

double length_mm(const pipeline::Point& a, const pipeline::Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double angle_deg(const pipeline::Point& a, const pipeline::Point& corner, const pipeline::Point& b) {
  const double legs = length_mm(a, corner) * length_mm(b, corner);
  if (legs == 0.0) return 0.0;
  double dot = 0.0;
  for (int i = 0; i < 3; ++i) dot += (a[i] - corner[i]) * (b[i] - corner[i]);
  return std::acos(std::clamp(dot / legs, -1.0, 1.0)) * 180.0 / M_PI;
}

std::string text_of(const Measure& measure) {
  const auto& p = measure.points;
  char text[40] = "";
  if (p.size() == 2) std::snprintf(text, sizeof text, "%.1f mm", length_mm(p[0], p[1]));
  if (p.size() == 3) std::snprintf(text, sizeof text, "%.1f\xc2\xb0", angle_deg(p[0], p[1], p[2]));
  return text;
}

}  // namespace vallecula::gui
