// The tube above the canals: a wall of rigid anatomy and a blade, reckoned by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/tool/shapes.h"
#include "tests/engine/tube/airways.h"

namespace vallecula::engine {
namespace {

using namespace testing;  // airways.h

constexpr double kWallFace = 0.010;  // m: the box' face towards the tube, at x

/// A box of one structure at the patient's left of a tube that points down, 30 mm above the inlet.
RigidField wall(Structure structure, const std::vector<SprungBody>& bodies = {}) {
  RigidAnatomy anatomy;
  anatomy.surface = box_surface(Vec3::Zero(), Vec3(0.02, 0.06, 0.06));
  for (Vec3& p : anatomy.surface.points) p += Vec3(kWallFace + 0.01, 0, 0.05);
  anatomy.triangle_structure.assign(anatomy.surface.triangles.size(), structure);
  if (!bodies.empty()) {
    anatomy.parts.push_back({0, 0.5});
    anatomy.triangle_part.assign(anatomy.surface.triangles.size(), 0);
  }
  return RigidField(anatomy, bodies, Vec3(-0.005, -0.04, 0.01), Vec3(0.04, 0.04, 0.09), 0.0007, 0.005);
}

struct AtWall {
  explicit AtWall(const char* size)
      : design(tube_design(size)), d(stiff_rod(design, 0.08)), airway(straight_airway(), design, d, hand(0.0)) {}
  /// The axis at x, the tip 25 mm above the inlet.
  Pose hand(double x) const { return hand_above(Vec3(x, 0, 0.025), 0.08); }
  /// Brings the axis to x within 100 ticks and leaves it there.
  RodStep settle(double x) {
    RodStep r;
    for (int n = 0; n < 300; ++n) r = airway.step(hand(x * std::min(1.0, n / 100.0)));
    return r;
  }
  TubeDesign design;
  RodDescription d;
  TubeInAirway airway;
};

TEST(TubeSurfaces, AWallPushesByLengthAndDepth) {
  const RigidField bone = wall(Structure::gum), cheek = wall(Structure::other), larynx = wall(Structure::larynx);
  PartPoses parts;
  for (const char* size : {"2.5", "3.5"}) {
    double on_bone = 0.0;
    for (const RigidField* field : {&bone, &larynx, &cheek}) {
      AtWall a(size);
      a.airway.input.rigid = field;
      a.airway.input.parts = &parts;
      const double touching = kWallFace - a.design.outer_diameter / 2;
      EXPECT_NEAR(a.settle(touching - 0.0001).on_hand.force.x(), 0.0, 1e-6);
      const double once = -a.settle(touching + 0.0002).on_hand.force.x();
      const double twice = -a.settle(touching + 0.0004).on_hand.force.x();
      EXPECT_NEAR(twice, 2 * once, 0.1 * once) << size;  // the bevel's balls join in
      EXPECT_GT(once, 0.5);
      // By its length along the wall: the tube is 80 mm long, the last 5 mm of it above the box.
      const Vec3 sum = [&] {
        Vec3 f = Vec3::Zero();
        for (int i = 0; i < a.airway.contacts->count; ++i) {
          const RodContact& c = a.airway.contacts->contact[static_cast<std::size_t>(i)];
          f += c.force;
          EXPECT_LT(c.depth_m, 0.00045);
          EXPECT_LT(c.force.norm() * std::abs(c.normal.x() + 1.0), 0.05);  // away from it, but at its edge
        }
        return f;
      }();
      EXPECT_NEAR(sum.x(), -twice, 0.02 * twice);
      const int load = field == &larynx ? static_cast<int>(AirwayPart::vestibule) : static_cast<int>(kLoadPharynx);
      EXPECT_NEAR(a.airway.loads.loads_n[static_cast<std::size_t>(load)], twice, 0.02 * twice);
      EXPECT_NEAR(a.airway.loads.glottis_n, field == &larynx ? twice : 0.0, 0.02 * twice);
      if (field == &bone)
        on_bone = once;
      else
        EXPECT_LT(once, 0.4 * on_bone);
    }
  }
}

TEST(TubeSurfaces, LipsYieldMoreThanCheek) {
  const RigidField cheek = wall(Structure::other);
  PartPoses parts;
  // The mouth's front is at z = 60 mm: the balls up to 4 mm behind it and all before it meet lips.
  AtWall a("3.5");
  a.airway.input.rigid = &cheek;
  a.airway.input.parts = &parts;
  a.settle(kWallFace - a.design.outer_diameter / 2 + 0.0003);
  double at_lip = 0.0, in_cheek = 0.0;
  for (int i = 0; i < a.airway.contacts->count; ++i) {
    const RodContact& c = a.airway.contacts->contact[static_cast<std::size_t>(i)];
    const double z =
        frame_at(a.airway.rod, a.airway.state, (c.node + c.weight) * a.airway.rod.segment_m()).position.z();
    if (z > 0.06 && z < 0.075) at_lip = std::max(at_lip, c.force.norm());
    if (z > 0.035 && z < 0.05) in_cheek = std::max(in_cheek, c.force.norm());
  }
  EXPECT_GT(at_lip, 0.0);
  EXPECT_LT(at_lip, 0.5 * in_cheek);
}

TEST(TubeSurfaces, AMovingPartCarriesTheTubeAndBearsIt) {
  SprungBody body;
  body.motion = SprungBody::Motion::translation;
  body.stiffness = 250;
  body.inertia = 0.01;
  const RigidField field = wall(Structure::larynx, {body});
  PartPoses parts;
  AtWall a("3.5");
  a.airway.input.rigid = &field;
  a.airway.input.parts = &parts;
  const double touching = kWallFace - a.design.outer_diameter / 2;
  const double force = -a.settle(touching + 0.0004).on_hand.force.x();
  EXPECT_NEAR(a.airway.loads.on_part[0].x(), 0.5 * force, 0.02 * force);  // the part goes half of its body's way
  EXPECT_GT(a.airway.loads.on_part_stiffness[0], 0.25 * force / 0.0004 * 0.8);
  EXPECT_EQ(a.airway.loads.on_larynx, Vec3::Zero());
  // The body steps aside by 1 mm, the part by half of that: nothing touches.
  field.place({Vec3(0.001, 0, 0)}, {Vec3::Zero()}, parts);
  RodStep free;
  for (int n = 0; n < 100; ++n) free = a.airway.step(a.hand(touching + 0.0004));
  EXPECT_NEAR(free.on_hand.force.x(), 0.0, 1e-3);
}

TEST(TubeSurfaces, TheBladeIsMetAndMeetsBack) {
  // A blade as a plate: 2 mm thick, its faces across x of the world, beside the tube.
  const TriangleMesh plate = box_surface(Vec3::Zero(), Vec3(0.002, 0.012, 0.03));
  const ToolField blade(plate, Vec3::Constant(-1), Vec3::Constant(1));
  for (const char* size : {"2.5", "4.0"}) {
    AtWall a(size);
    a.airway.input.blade = &blade;
    a.airway.input.blade_pose.position = Vec3(kWallFace + 0.001, 0, 0.060);
    const double touching = kWallFace - a.design.outer_diameter / 2;
    EXPECT_NEAR(a.settle(touching - 0.00005).on_hand.force.x(), 0.0, 1e-6) << size;
    const double once = -a.settle(touching + 0.0001).on_hand.force.x();
    const RodStep r = a.settle(touching + 0.0002);
    const double twice = -r.on_hand.force.x();
    EXPECT_GT(once, 0.5);
    EXPECT_NEAR(twice, 2 * once, 0.15 * once);
    EXPECT_NEAR(a.airway.loads.on_blade.force.x(), twice, 0.02 * twice);
    EXPECT_NEAR(a.airway.loads.loads_n[kLoadBlade], twice, 0.03 * twice);
    // About the blade's origin it turns by where along it the tube presses: evenly, so not much.
    EXPECT_LT(a.airway.loads.on_blade.torque.norm(), 0.004 * twice);
    EXPECT_GT(a.airway.loads.on_blade_stiffness(0, 0), 0.8 * twice / 0.0002);

    // A blade that goes along the tube draws it along by friction, at most mu times what presses.
    a.airway.input.blade_velocity = Vec3(0, 0, 0.05);
    const RodStep drawn = a.settle(touching + 0.0002);
    EXPECT_NEAR(drawn.on_hand.force.z(), 0.1 * twice, 0.03 * twice);

    a.airway.input.blade_pose.position.x() = std::numeric_limits<double>::quiet_NaN();
    a.airway.step(a.hand(touching));
    EXPECT_EQ(a.airway.faults, kPassageFaultBlade);
    EXPECT_EQ(a.airway.loads.loads_n[kLoadBlade], 0.0);
  }
}

TEST(TubeSurfaces, WhatIsInACanalMeetsNoSurface) {
  // A wall across the airway itself: a tube inside meets only its rings.
  PartPoses parts;
  const TubeDesign design = tube_design("2.5");
  const RodDescription d = stiff_rod(design);
  TubeInAirway a(straight_airway(), design, d, hand_above(Vec3(0, 0, 0.002), d.length_m));
  RigidAnatomy anatomy;
  anatomy.surface = box_surface(Vec3::Zero(), Vec3(0.04, 0.04, 0.02));
  for (Vec3& p : anatomy.surface.points) p += Vec3(0.0, 0.0, -0.025);
  anatomy.triangle_structure.assign(anatomy.surface.triangles.size(), Structure::gum);
  const RigidField across(anatomy, {}, Vec3(-0.03, -0.03, -0.04), Vec3(0.03, 0.03, 0.0), 0.0007, 0.005);
  a.input.rigid = &across;
  a.input.parts = &parts;
  for (double z = 0.002; z > -0.04; z -= 0.0001) a.step(hand_above(Vec3(0, 0, z), d.length_m));
  EXPECT_EQ(a.loads.loads_n[kLoadPharynx], 0.0);
  EXPECT_GT(a.past_cords(), 0.03);
  // A tip that is not in meets it.
  TubeInAirway outside(straight_airway(), design, d, hand_above(Vec3(0.012, 0, 0.002), d.length_m));
  outside.input.rigid = &across;
  outside.input.parts = &parts;
  double most = 0.0;
  for (double z = 0.002; z > -0.0160; z -= 0.00002) {
    outside.step(hand_above(Vec3(0.012, 0, z), d.length_m));
    most = std::max(most, outside.loads.loads_n[kLoadPharynx]);
  }
  EXPECT_GT(most, 0.5);
  EXPECT_GT(outside.loads.tip_load_n, 0.5);
  EXPECT_EQ(outside.loads.tip_against, kLoadPharynx);
}

}  // namespace
}  // namespace vallecula::engine
