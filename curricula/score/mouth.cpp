#include "curricula/score/mouth.h"

#include <cmath>

#include "curricula/score/vectors.h"

namespace vallecula::curricula {
namespace {

/// The tube's radius as a share of the way from gums to vallecula: 25 mm in a term infant, whose mouth corners lie 15
/// mm from the middle and whose pharynx wall lies 14 mm from the line.
constexpr double kRadiusShare = 0.6;
/// Gums nearer together than this share of that way (a closed mouth) give no usable gum line.
constexpr double kOpenShare = 0.1;

}  // namespace

bool Mouth::holds(const Point& tip_m) const noexcept {
  const Point way = plus(tip_m, gum_middle_m, -1.0);
  const double along = dot(way, axis);
  return dot(way, inward) > 0.0 && dot(way, way) - along * along < radius_m * radius_m;
}

std::optional<Mouth> mouth_from_landmarks(const std::map<std::string, Point>& landmarks_m) {
  const auto upper = landmarks_m.find("upper_gum_midline"), lower = landmarks_m.find("lower_gum_midline"),
             vallecula = landmarks_m.find("vallecula");
  if (upper == landmarks_m.end() || lower == landmarks_m.end() || vallecula == landmarks_m.end()) return std::nullopt;

  Mouth mouth;
  mouth.gum_middle_m = scaled(plus(upper->second, lower->second, 1.0), 0.5);
  const Point way = plus(vallecula->second, mouth.gum_middle_m, -1.0);
  const double depth_m = std::sqrt(dot(way, way));
  if (!(depth_m > 0.0) || !std::isfinite(depth_m)) return std::nullopt;
  mouth.axis = scaled(way, 1.0 / depth_m);
  mouth.radius_m = kRadiusShare * depth_m;

  mouth.inward = mouth.axis;
  const Point gum_line = plus(lower->second, upper->second, -1.0);
  const double opening_m = std::sqrt(dot(gum_line, gum_line));
  if (opening_m > kOpenShare * depth_m) {
    const Point direction = scaled(gum_line, 1.0 / opening_m);
    const Point facing = plus(mouth.axis, direction, -dot(mouth.axis, direction));
    const double length = std::sqrt(dot(facing, facing));
    if (!(length > 0.1)) return std::nullopt;  // the gums lie one behind the other: not a mouth
    mouth.inward = scaled(facing, 1.0 / length);
  }
  return mouth;
}

}  // namespace vallecula::curricula
