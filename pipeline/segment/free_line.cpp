#include "pipeline/segment/free_line.h"

#include <algorithm>
#include <cmath>

namespace vallecula::pipeline {
namespace {

bool is_free(const Segmentation& s, const Vector3& from, const Vector3& eye) {
  const auto& g = s.labels.grid;
  const auto way = unit(eye - from);
  const double length = distance(eye, from);
  const double step = 0.5 * std::min({g.spacing[0], g.spacing[1], g.spacing[2]});
  for (double t = 2.0 * s.frame.scale; t < length; t += step) {
    const auto p = from + t * way;
    const auto c = g.nearest(p);
    if (!g.contains(c[0], c[1], c[2])) break;  // it has left the head
    const auto label = s.labels.at(c[0], c[1], c[2]);
    if (label == kBackground || label == kAirway || label == kTongue || label == kEpiglottis) continue;
    if (grey_at(s.hu, p) > s.thresholds.air) return false;
  }
  return true;
}

}  // namespace

double free_share(const Segmentation& s, const Vector3& eye) {
  const auto& centre = s.airway.glottis.centre;
  const auto& outline = s.airway.glottis_outline;
  int seen = is_free(s, centre, eye) ? 1 : 0;
  int all = 1;
  const std::size_t stride = std::max<std::size_t>(1, outline.size() / 16);
  for (std::size_t i = 0; i < outline.size(); i += stride) {
    for (const double f : {0.45, 0.85}) {
      seen += is_free(s, centre + f * (outline[i] - centre), eye) ? 1 : 0;
      ++all;
    }
  }
  return static_cast<double>(seen) / all;
}

}  // namespace vallecula::pipeline
