#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/tube/intubation_data.h"
#include "engine/tube/secretions.h"

namespace vallecula::engine {

namespace {

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument("intubation: " + why); }

std::string mm(double m) { return std::to_string(1e3 * m) + " mm"; }

void need_unit(const Vec3& v, const char* what) {
  if (!(std::abs(v.norm() - 1) < 1e-3))
    refuse(std::string(what) + " has a length of " + std::to_string(v.norm()) + " instead of 1");
}

/// Share of the larynx body's way that the cords take part in.
double cords_share(const AirwayCourse& course) {
  for (const AirwayRing& ring : course.airway)
    if (ring.part == AirwayPart::cords) return ring.larynx_share;
  return 0.0;
}

const IntubationDescription& checked(const IntubationDescription& d, const std::vector<SprungBody>& bodies) {
  if (d.glottis.relaxed != d.infant.premedicated)
    refuse(d.infant.premedicated ? "the infant has a muscle relaxant, its cords have none"
                                 : "the cords have a muscle relaxant, the infant has none");
  if (d.infant.premedicated && d.breathes) refuse("a premedicated infant does not breathe by itself");
  if (!(d.press_n >= 0 && d.press_n <= kMostPress))
    refuse("a press on the larynx of 0 to 10 N is needed, not " + std::to_string(d.press_n) + " N");
  need_unit(d.press_direction, "the press' direction");
  if (!(d.mouth_half_width_m >= 0) || !std::isfinite(d.mouth_half_width_m))
    refuse("half the mouth's width is " + mm(d.mouth_half_width_m) +
           "; it must be above 0, or 0 where it is not known");
  if (!(d.device_limit_n > 0) || !std::isfinite(d.device_limit_n))
    refuse("the limit of the second hand's device is " + std::to_string(d.device_limit_n) + " N; it must be above 0");
  if (!(d.mouth_gap_m >= 0) || !std::isfinite(d.mouth_gap_m))
    refuse("the gap between the gums is " + mm(d.mouth_gap_m) + "; it must be above 0, or 0 where it is not known");
  if (!(d.lips_before_gums_m >= 0) || !std::isfinite(d.lips_before_gums_m))
    refuse("the lips stand " + mm(d.lips_before_gums_m) +
           " before the gums; it must be above 0, or 0 where it is not known");
  if (d.mouth_gap_m > 0 && !(d.tube.outer_diameter < d.mouth_gap_m))
    refuse("a tube of " + mm(d.tube.outer_diameter) + " outside does not go between gums that are " +
           mm(d.mouth_gap_m) + " apart");
  if (!(d.catheter_outer_m >= 0 && d.catheter_outer_m <= 0.01))
    refuse("a suction catheter up to 10 mm thick is needed, or 0 for none, not " + mm(d.catheter_outer_m));
  if (d.course.larynx_body < -1 || d.course.larynx_body >= static_cast<int>(bodies.size()))
    refuse("the larynx goes with body " + std::to_string(d.course.larynx_body) + ", which is not there");
  if (d.course.larynx_body >= 0 &&
      bodies[static_cast<std::size_t>(d.course.larynx_body)].motion != SprungBody::Motion::translation)
    refuse("the larynx goes with body " + std::to_string(d.course.larynx_body) + ", which does not shift");
  checked(d.glottis);
  checked(d.secretions);
  return d;
}

IntubationRecord record_at_start(const IntubationDescription& d, const Infant& infant) {
  IntubationRecord r;
  const InfantState s = start(infant);
  r.in_hand = d.stylet ? InHand::tube_with_stylet : InHand::tube;
  r.glottis_opening = start(d.glottis).opening;
  r.spasm = start(d.glottis).spasm;
  r.secretions_ml = 1e6 * d.secretions.volume_m3;
  r.sao2 = s.oxygen.arterial;
  r.spo2 = s.oximeter.percent / 100.0;
  r.heart_per_min = s.heart.per_min;
  return r;
}

std::vector<std::array<int, 3>> sleeve_triangles() {
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i + 1 < kTubeNodes; ++i)
    for (int k = 0; k < kTubeSides; ++k) {
      const int a = i * kTubeSides + k, b = i * kTubeSides + (k + 1) % kTubeSides;
      triangles.push_back({a, b, b + kTubeSides});
      triangles.push_back({a, b + kTubeSides, a + kTubeSides});
    }
  return triangles;
}

}  // namespace

Intubation::Intubation(const IntubationDescription& d, const std::vector<SprungBody>& bodies)
    : description(checked(d, bodies)),
      infant(build_infant(d.infant)),
      passage(d.course, d.glottis, d.mouth, d.mouth_inward, d.mouth_axis, d.mouth_radius_m, d.mouth_half_width_m),
      at_start(record_at_start(d, infant)),
      sleeve(sleeve_triangles()),
      catheter_(suction_catheter(d.catheter_outer_m)),
      tube_outside_(d.tube),
      catheter_outside_(catheter_) {
  const auto make = [this](InHand what, const TubeDesign& design, const Stylet* stylet) {
    rods_[static_cast<std::size_t>(what)].emplace(tube_rod(design, stylet, usual_grip_from_tip(design)));
  };
  make(InHand::tube, d.tube, nullptr);
  if (d.stylet) make(InHand::tube_with_stylet, d.tube, &*d.stylet);
  if (d.catheter_outer_m > 0) make(InHand::catheter, catheter_, nullptr);
  larynx_share_ = d.course.larynx_body >= 0 ? cords_share(d.course) : 0.0;
}

double press_for(const IntubationDescription& d, const std::vector<SprungBody>& bodies, double way_m) {
  const double share = d.course.larynx_body >= 0 ? cords_share(d.course) : 0.0;
  if (!(share > 0)) return 0.0;
  // The larynx goes share times the body's way, which is share times the force over the body's stiffness.
  return way_m * bodies[static_cast<std::size_t>(d.course.larynx_body)].stiffness / (share * share);
}

}  // namespace vallecula::engine
