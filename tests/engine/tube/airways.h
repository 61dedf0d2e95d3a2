// Airways for the tests, built in code: straight down (-z) from an inlet at the origin, or bent; and a tube stepped
// within one.
#pragma once

#include <memory>
#include <vector>

#include "engine/tube/passage.h"

namespace vallecula::engine::testing {

/// Half widths in m, of a term infant unless told otherwise.
struct AirwaySizes {
  double spacing = 0.001;
  double inlet = 0.0045, subglottis = 0.0031;
  double cricoid_side = 0.00225, cricoid_front = 0.00273;  // CLINICAL's 19.3 mm^2
  double trachea = 0.0032;
  double inlet_to_cords = 0.007, cords_to_cricoid = 0.006, cricoid_length = 0.003, cords_to_carina = 0.050;
  double cord_share = 0.0;  // of the larynx' way, from the inlet to the cricoid
};

inline AirwayRing ring_at(double z, double side, double front, AirwayPart part, double share = 0.0) {
  AirwayRing r;
  r.centre = Vec3(0, 0, z);
  r.to_left_m = r.to_right_m = side;
  r.to_front_m = r.to_back_m = front;
  r.part = part;
  r.larynx_share = share;
  return r;
}

/// Cuts `spacing` apart from `first` on, around a way that turns away from -z by `angle` (rad, towards x).
inline std::vector<AirwayRing> branch(const Vec3& first, double angle, double half_width, double length, double spacing,
                                      AirwayPart part) {
  std::vector<AirwayRing> rings;
  AirwayRing r = ring_at(0, half_width, half_width, part);
  r.along = Vec3(std::sin(angle), 0, -std::cos(angle));
  r.left = Vec3(std::cos(angle), 0, std::sin(angle));
  for (double way = 0; way <= length; way += spacing) {
    r.centre = first + way * r.along;
    rings.push_back(r);
  }
  return rings;
}

/// Its cords lie `inlet_to_cords` below the origin, front is -y, left +x; the oesophagus' mouth 10 mm behind the cords.
inline AirwayCourse straight_airway(const AirwaySizes& a = {}) {
  AirwayCourse c;
  const double cricoid = a.inlet_to_cords + a.cords_to_cricoid, carina = a.inlet_to_cords + a.cords_to_carina;
  for (int n = 0; n * a.spacing < carina + 1e-9; ++n) {
    const double deep = n * a.spacing;
    if (std::abs(deep - a.inlet_to_cords) < a.spacing / 2)
      c.airway.push_back(ring_at(-deep, 0.0030, 0.0035, AirwayPart::cords, a.cord_share));
    else if (deep < a.inlet_to_cords)
      c.airway.push_back(ring_at(-deep, a.inlet - 0.15 * deep, a.inlet, AirwayPart::vestibule, a.cord_share));
    else if (deep < cricoid - 1e-9)
      c.airway.push_back(ring_at(-deep, a.subglottis, a.subglottis, AirwayPart::subglottis, a.cord_share));
    else if (deep < cricoid + a.cricoid_length - 1e-9)
      c.airway.push_back(ring_at(-deep, a.cricoid_side, a.cricoid_front, AirwayPart::cricoid, a.cord_share));
    else
      c.airway.push_back(ring_at(-deep, a.trachea, a.trachea, AirwayPart::trachea));
  }
  c.bronchi[0] = branch(Vec3(-0.0025, 0, -carina - 0.002), -0.4, 0.0024, 0.02, a.spacing, AirwayPart::main_bronchus);
  c.bronchi[1] = branch(Vec3(0.003, 0, -carina - 0.002), 0.8, 0.0020, 0.03, a.spacing, AirwayPart::main_bronchus);
  c.oesophagus = branch(Vec3(0, 0.010, -a.inlet_to_cords), 0.0, 0.0005, 0.08, a.spacing, AirwayPart::oesophagus);
  return c;
}

/// Tube of TubeDesign without its curve, in a stiff hand, so stiff that it stays straight: what an airway asks of it
/// can be reckoned by hand.
inline RodDescription stiff_rod(const TubeDesign& tube, double length_m = 0.12) {
  RodDescription d = tube_rod(tube, nullptr, length_m);
  for (RodSection& s : d.section) s = {100.0, 100.0, 0.0};
  d.stretching_n = 2e5;
  d.grip_n_m = 1e6;
  d.grip_nm_rad = 1e4;
  return d;
}

/// The hand that holds a tube pointing down, its tip at `tip` if it is straight and `length` long, concave to the front
/// and turned about itself by `turn` rad.
inline Pose hand_above(const Vec3& tip, double length, double turn = 0.0) {
  Mat3 axes;
  axes.col(0) = Vec3::UnitZ();
  axes.col(2) = -Vec3::UnitY();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  Pose hand;
  hand.position = tip + length * Vec3::UnitZ();
  hand.rotation = Quat(axes) * Quat(Eigen::AngleAxisd(turn, Vec3::UnitX()));
  return hand;
}

/// The hand that holds a tube of whatever curve so that, hanging free, its tip is at `tip` and points down.
inline Pose hand_with_tip_at(const Rod& rod, const Vec3& tip, double turn = 0.0) {
  const RodState hanging(rod, Pose{});
  const Pose straight = hand_above(tip, 0.0, turn);
  Pose hand;
  hand.rotation = straight.rotation * hanging.rotation[0].conjugate();
  hand.position = tip - hand.rotation * hanging.position[0];
  return hand;
}

/// A tube in an airway, stepped together.
class TubeInAirway {
 public:
  TubeInAirway(const AirwayCourse& course, const TubeDesign& tube, const RodDescription& rod, const Pose& hand,
               const Glottis& glottis = {})
      : passage(course, glottis, Vec3(0, 0, 0.06), -Vec3::UnitZ()), outside(tube), rod(rod), state(this->rod, hand) {
    input.glottis_opening = 1.0;
  }

  RodStep step(const Pose& hand) {
    faults = find_contacts(passage, in, outside, rod, state, input, kStep, *contacts);
    const RodStep r = engine::step(rod, state, hand, contacts->contact.data(), contacts->count, kStep);
    loads = read_loads(input.rigid, state, input.blade_pose.position, *contacts);
    return r;
  }
  TipPlace tip_place() const { return place(passage, in, state); }
  double past_cords() const { return past_cords_m(passage, in, state, input.larynx_way); }

  static constexpr double kStep = 0.001;
  Passage passage;
  TubeOutside outside;
  Rod rod;
  RodState state;
  PassageState in;
  PassageInput input;
  std::unique_ptr<TubeContacts> contacts = std::make_unique<TubeContacts>();
  PassageLoads loads;
  std::uint32_t faults = 0;
};

}  // namespace vallecula::engine::testing
