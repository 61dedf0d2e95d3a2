// The small mouth with what the second hand needs: a straight windpipe beside the tongue under the glottis, an
// oesophagus behind it, a larynx that gives way, an infant. The tube is nearly straight, so that a straight hand
// passes.
#pragma once

#include "tests/engine/mouth_scene.h"
#include "tests/engine/physiology/infants.h"

namespace vallecula::engine::testing {

constexpr int kSceneLarynx = 2;  // among the bodies
const Vec3 kInlet(0.040, 0.015, -0.004), kOesophagusMouth(0.040, 0.027, -0.008);
constexpr double kMouthZ = 0.030, kCordsZ = -0.010, kCarinaZ = -0.064;

/// Cuts along -z, 2 mm apart, of this half-width.
inline std::vector<AirwayRing> straight_canal(const Vec3& from, double length_m, double half_m, AirwayPart part) {
  std::vector<AirwayRing> rings;
  for (int i = 0; i <= static_cast<int>(length_m / 0.002 + 0.5); ++i) {
    AirwayRing ring;
    ring.centre = from - Vec3(0, 0, 0.002 * i);
    ring.to_left_m = ring.to_right_m = ring.to_front_m = ring.to_back_m = half_m;
    ring.part = part;
    rings.push_back(ring);
  }
  return rings;
}

inline AirwayCourse straight_course() {
  AirwayCourse course;
  course.airway = straight_canal(kInlet, kInlet.z() - kCarinaZ, 0.0035, AirwayPart::trachea);
  for (AirwayRing& ring : course.airway) {
    const double below = kCordsZ - ring.centre.z();
    if (below < 0.015) ring.larynx_share = 0.5;
    if (below < -0.0005) ring.part = AirwayPart::vestibule;
    if (std::abs(below) < 0.0005) ring.part = AirwayPart::cords;
    if (below > 0.0005 && below < 0.007) ring.part = AirwayPart::subglottis;
    if (std::abs(below - 0.008) < 0.0005) ring.part = AirwayPart::cricoid;
    if (ring.part == AirwayPart::vestibule) ring.to_left_m = ring.to_right_m = 0.006;
  }
  const Vec3 carina = course.airway.back().centre;
  for (int side = 0; side < 2; ++side) {
    const double angle = (side == 0 ? -1 : 1) * (side == 0 ? 0.35 : 0.75);  // the right one is the steeper
    const Vec3 along(std::sin(angle), 0, -std::cos(angle));
    for (int i = 0; i < 10; ++i) {
      AirwayRing ring;
      ring.centre = carina + 0.002 * (i + 1) * along;
      ring.along = along;
      ring.left = Vec3(std::cos(angle), 0, std::sin(angle));
      ring.part = AirwayPart::main_bronchus;
      course.bronchi[static_cast<std::size_t>(side)].push_back(ring);
    }
  }
  course.oesophagus = straight_canal(kOesophagusMouth, 0.060, 0.003, AirwayPart::oesophagus);
  course.larynx_body = kSceneLarynx;
  return course;
}

/// Size 3.5, an infant in apnoea, no stylet.
inline SceneDescription intubation_scene(const std::array<int, 3>& cells = {4, 4, 2}) {
  SceneDescription d = mouth_scene(cells);
  d.sight.occluders.clear();
  d.sight.followers.clear();
  d.sight.eye = Vec3(0.040, 0.010, 0.3);
  SprungBody larynx;
  larynx.motion = SprungBody::Motion::translation;
  larynx.stiffness = 80.0;
  larynx.inertia = 0.010;
  larynx.damping = 2 * std::sqrt(larynx.stiffness * larynx.inertia);
  d.soft.bodies.push_back(larynx);
  IntubationDescription in;
  in.tube = tube_design("3.5");
  in.tube.bend_radius = 5.0;
  in.course = straight_course();
  in.infant = preterm();
  in.glottis.relaxed = true;
  in.mouth = Vec3(0.040, 0.015, kMouthZ);
  in.secretions.floor = Vec3(0.040, 0.026, -0.006);
  d.intubation = in;
  return d;
}

/// A straight stylet in a tube too thick for the cricoid: what the hand pushes with stands against it.
inline SceneDescription jamming_scene() {
  SceneDescription d = intubation_scene();
  d.intubation->stylet = Stylet{};
  d.intubation->stylet->bend_rad = 0;
  for (AirwayRing& ring : d.intubation->course.airway)
    if (ring.part == AirwayPart::cricoid) ring.to_left_m = ring.to_right_m = ring.to_front_m = ring.to_back_m = 0.0018;
  return d;
}
const Vec3 kJammed(0.040, 0.015, kCordsZ - 0.012);

/// The hand whose rod, undeformed, has its tip at `tip` pointing to the lungs, its
/// concave side to the back: so its bevel faces the patient's right, and its point goes ahead on the left.
inline Pose hand_of_tip(const Rod& rod, const Vec3& tip) {
  const RodState rest(rod, Pose{});
  Mat3 axes;
  axes << Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY();
  Pose hand;
  hand.rotation = Quat(axes) * rest.rotation[0].conjugate();
  hand.position = tip - hand.rotation * rest.position[0];
  return hand;
}
const Vec3 kBeforeMouth(0.040, 0.015, 0.050);
const Vec3 kInTrachea(0.040, 0.015, kCordsZ - 0.028), kInBronchus(0.040, 0.015, kCarinaZ - 0.014);
const Vec3 kBeforeOesophagus(0.040, 0.027, 0.010), kInOesophagus(0.040, 0.027, -0.040);

/// A scene brought through time by two hands; the blade is far from everything unless it is told.
struct Trial {
  std::shared_ptr<const Scene> scene;
  LateLoop loop;
  TickRecord record;
  std::int64_t ticks = 0;
  Pose blade;

  explicit Trial(const SceneDescription& d) : scene(build_scene(d)), loop(*scene) {
    blade.position = Vec3(0.0, -0.1, 0.1);
  }
  PortInput hands(const Vec3& tip, std::uint32_t actions = 0) const {
    PortInput in;
    in.pose = blade;
    in.second_pose = hand_of_tip(scene->intubation->rod(loop.state.intubation->in_hand), tip);
    in.buttons = actions;
    return in;
  }
  const IntubationRecord& tick(const PortInput& in) {
    record = loop.tick(ticks++, in);
    return record.intubation;
  }
  const IntubationRecord& hold(double seconds, const Vec3& tip, std::uint32_t actions = 0) {
    for (int n = 0; n < static_cast<int>(1000 * seconds + 0.5); ++n) tick(hands(tip, actions));
    return record.intubation;
  }
  /// From where the tip was told to be to `tip` at 40 mm/s.
  const IntubationRecord& go(const Vec3& from, const Vec3& tip, std::uint32_t actions = 0) {
    const int n = static_cast<int>((tip - from).norm() / 0.04 * 1000) + 1;
    for (int i = 1; i <= n; ++i) tick(hands(from + (tip - from) * i / n, actions));
    return record.intubation;
  }
};

}  // namespace vallecula::engine::testing
