#include "pipeline/pose/aim.h"

#include <algorithm>
#include <cmath>

#include "pipeline/segment/mouth_bounds.h"

namespace vallecula::pipeline {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
// The design of the manikin, whose head is extended by 25 degrees, measured as a scan is.
constexpr double kExtendedDeg = 115.0;
constexpr double kWellExtended = 8.0;    ///< degrees short of that are let be: infants vary
constexpr double kSightDeg = 43.0;       ///< of its palate against the way from glottis to gum, measured alike
constexpr double kMostExtension = 35.0;  ///< degrees added at most (assumed: within a neck's range from neutral)
// CLINICAL, mouth opening below one month; and what counts as open.
constexpr double kOpenMm = 22.0;
constexpr double kOpenEnough = 0.75;
// Ridges that rest farther apart than this have lost the teeth between them: they are opened by the way that parts lips
// and tongue (assumed).
constexpr double kToothlessMm = 6.0;
constexpr double kToothlessWayMm = 14.0;
constexpr double kMostOpeningDeg = 35.0;
// The condyles slide down the eminence as the mouth opens: about 13 mm over the 30 degrees of a grown-up's widest.
constexpr double kSlideMmPerDeg = 0.27;
constexpr double kSlideForward = 0.92;
constexpr double kSlideDown = 0.39;

Turn jaw_turn(const Segmentation& s, double degrees) {
  const double slide = kSlideMmPerDeg * s.frame.scale * degrees;
  return {s.landmarks.at("condyle_axis"), degrees * kDegree, {0.0, -slide * kSlideForward, -slide * kSlideDown}};
}

double gap_after(const Segmentation& s, const Turn& jaw) {
  return distance(s.landmarks.at("upper_gum_midline"), jaw(s.landmarks.at("lower_gum_midline")));
}

/// The uppermost joints of the neck: in front of the spine a little below the level of the palate.
Vector3 neck_pivot(const Segmentation& s, const Roof& roof) {
  const double k = s.frame.scale;
  const auto& g = s.bones.spine.grid;
  Vector3 pivot{s.frame.mid_x, s.airway.glottis.centre[1] + 14.0 * k, roof.back[2] - 14.0 * k};
  const auto box = box_between(g, pivot + k * Vector3{-6.0, -1e4, -10.0}, pivot + k * Vector3{6.0, 1e4, 3.0});
  double front = 1e30;
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      for (int x = box.low[0]; x <= box.high[0]; ++x) {
        if (s.bones.spine.at(x, y, z) != 0) front = std::min(front, g.origin[1] + y * g.spacing[1]);
      }
    }
  }
  if (front < 1e29) pivot[1] = front + 5.0 * k;
  return pivot;
}

/// Between the palate and the way from the glottis, turned with the neck, past the upper jaw: what the operator needs.
double sight_angle(const Segmentation& s, const Roof& roof, const Turn& neck) {
  const auto sight = unit(roof.front - neck(s.airway.glottis.centre));
  return std::acos(std::clamp(dot(unit(roof.front - roof.back), sight), -1.0, 1.0)) / kDegree;
}

double angle_of(const Segmentation& s, const Roof& roof) {
  if (!roof.seen || s.airway.course.empty()) return -1.0;
  const auto palate = unit(roof.front - roof.back);
  const auto trachea = unit(s.airway.course.front().centre - s.airway.glottis.centre);
  return std::acos(std::clamp(dot(palate, trachea), -1.0, 1.0)) / kDegree;
}

}  // namespace

Vector3 Turn::operator()(const Vector3& p) const {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  const Vector3 d = p - pivot;
  return pivot + Vector3{d[0], c * d[1] - s * d[2], s * d[1] + c * d[2]} + shift;
}

Vector3 Turn::back(const Vector3& p) const {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  const Vector3 d = p - pivot - shift;
  return pivot + Vector3{d[0], c * d[1] + s * d[2], -s * d[1] + c * d[2]};
}

double neck_angle_deg(const Segmentation& s) { return angle_of(s, find_roof(s.bones.skull, s.bones.mandible, s.frame)); }

Aim aim_of(const Segmentation& s) {
  const double k = s.frame.scale;
  Aim aim;
  if (count(s.bones.mandible) == 0) return aim;  // nothing to be moved by
  const double rest = gap_after(s, {});
  const double wanted = kOpenMm * k;
  aim.part = s.head.lips.empty();
  if (aim.part || rest < kOpenEnough * wanted) {
    aim.gap_mm = rest > kToothlessMm * k ? std::max(wanted, rest + kToothlessWayMm * k) : wanted;
    double low = 0.0;
    double high = kMostOpeningDeg;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (gap_after(s, jaw_turn(s, middle)) < aim.gap_mm ? low : high) = middle;
    }
    aim.jaw = jaw_turn(s, 0.5 * (low + high));
    aim.part = true;
  }
  const auto roof = find_roof(s.bones.skull, s.bones.mandible, s.frame);
  const double now = angle_of(s, roof);
  const bool bent = now >= 0.0 && now < kExtendedDeg - kWellExtended;
  if (bent || (now >= 0.0 && sight_angle(s, roof, {}) > kSightDeg + kWellExtended)) {
    // A grown-up's larynx lies so much lower that the neck's angle alone gives no line of sight.
    aim.neck.pivot = neck_pivot(s, roof);
    aim.neck.angle_rad = std::max(kExtendedDeg - now, 0.0) * kDegree;
    while (aim.neck.angle_rad < kMostExtension * kDegree && sight_angle(s, roof, aim.neck) > kSightDeg)
      aim.neck.angle_rad += 0.25 * kDegree;
    aim.neck.angle_rad = std::min(aim.neck.angle_rad, kMostExtension * kDegree);
  }
  return aim;
}

}  // namespace vallecula::pipeline
