// The skin outside of the box that the rigid anatomy is sampled in, on a head that is a ball: its distances are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "engine/scene_data.h"
#include "engine/tool/shapes.h"
#include "tests/engine/tube/airways.h"
#include "tests/engine/tube/intubation_scene.h"

namespace vallecula::engine {
namespace {

using namespace testing;  // airways.h

constexpr double kHeadRadius = 0.045;            // m: a head's
const Vec3 kHeadMiddle(0.2, 0, 0.05);            // far from the airway
constexpr double kHeadTop = 0.05 + kHeadRadius;  // z

TriangleMesh ball_head() {
  TriangleMesh mesh = sphere_surface(kHeadRadius, 5);
  for (Vec3& p : mesh.points) p += kHeadMiddle;
  return mesh;
}

double above_head_m(const Vec3& x) { return (x - kHeadMiddle).norm() - kHeadRadius; }

/// A straight tube that points down at the head's top, in a hand that gives by a millimetre for each half newton.
struct AtHead {
  explicit AtHead(double tip_z) : airway(straight_airway(), design, rod(), hand(tip_z)) { airway.input.skin = &skin; }
  static RodDescription rod() {
    RodDescription d = stiff_rod(tube_design("3.5"), 0.1);
    d.grip_n_m = 500;
    return d;
  }
  static Pose hand(double tip_z, double aside = 0.0) {
    return hand_above(Vec3(kHeadMiddle.x() + aside, 0, tip_z), 0.1);
  }
  RodStep go(double from_z, double to_z, double aside_from = 0.0, double aside_to = 0.0) {
    RodStep r;
    constexpr int kTicks = 400;
    for (int n = 1; n <= kTicks; ++n) {
      const double share = static_cast<double>(n) / kTicks;
      r = airway.step(hand(from_z + share * (to_z - from_z), aside_from + share * (aside_to - aside_from)));
      most_n = std::max(most_n, r.on_hand.force.norm());
    }
    return r;
  }
  /// How far beneath the skin the deepest of the tube's axis is, m.
  double beneath() const {
    double most = -1.0;
    for (const Vec3& x : airway.state.position) most = std::max(most, -above_head_m(x));
    return most;
  }
  TubeDesign design = tube_design("3.5");
  SkinField skin{ball_head()};
  TubeInAirway airway;
  double most_n = 0.0;
};

TEST(Skin, TheFieldIsTheBallsDistance) {
  const SkinField skin(ball_head());
  EXPECT_LT(skin.bytes(), 3e6);
  const Vec3 direction = Vec3(0.3, -0.8, 0.52).normalized();
  for (double away = -SkinField::kDeepest; away < 0.0035; away += 0.0001) {
    for (const Vec3& n : {direction, Vec3(-direction), Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitY())}) {
      const SignedDistanceGrid::Sample s = skin.sample(kHeadMiddle + (kHeadRadius + away) * n);
      EXPECT_NEAR(s.distance, away, 0.0001) << away;
      EXPECT_GT(s.gradient.dot(n), 0.999) << away;
    }
  }
  EXPECT_FLOAT_EQ(static_cast<float>(skin.sample(kHeadMiddle).distance), static_cast<float>(-SkinField::kBand));
  EXPECT_EQ(skin.sample(kHeadMiddle).gradient, Vec3::Zero());
  EXPECT_EQ(skin.sample(Vec3::Zero()).distance, SkinField::kBand);
  EXPECT_TRUE(SkinField().empty());
  EXPECT_EQ(SkinField().sample(kHeadMiddle).distance, SkinField::kBand) << "without a head there is no skin";
}

TEST(Skin, StopsATubeFromOutsideAndLetsItSlide) {
  AtHead a(kHeadTop + 0.005);
  EXPECT_NEAR(a.go(kHeadTop + 0.005, kHeadTop + 0.0005).on_hand.force.norm(), 0.0, 1e-3);
  const RodStep pressed = a.go(kHeadTop + 0.0005, kHeadTop - 0.006);
  EXPECT_GT(a.beneath(), 0.0);
  EXPECT_LT(a.beneath(), 0.002);
  EXPECT_NEAR(pressed.on_hand.force.z(), 500 * (0.006 - a.beneath()), 0.15) << "what the hand's own spring says";
  // It counts for nothing but the hand: no part of the airway was touched.
  EXPECT_EQ(std::accumulate(a.airway.loads.loads_n.begin(), a.airway.loads.loads_n.end(), 0.0), 0.0);
  EXPECT_EQ(a.airway.loads.tip_load_n, 0.0);
  EXPECT_EQ(a.airway.loads.tip_against, 255);
  // 20 mm aside and as much lower as the ball is there: along the skin, no deeper.
  const double lower = kHeadRadius - std::sqrt(kHeadRadius * kHeadRadius - 0.02 * 0.02);
  a.go(kHeadTop - 0.006, kHeadTop - 0.006 - lower, 0.0, 0.02);
  EXPECT_NEAR(a.airway.state.position[0].x(), kHeadMiddle.x() + 0.02, 0.003);
  EXPECT_GT(a.beneath(), 0.0);
  EXPECT_LT(a.beneath(), 0.002);
  EXPECT_LT(a.most_n, 4.0);
}

TEST(Skin, WhatIsWithinIsNotThrownOutAndMetAnewFromOutside) {
  AtHead a(kHeadTop - 0.020);
  EXPECT_LT(a.airway.step(a.hand(kHeadTop - 0.020)).on_hand.force.norm(), 1e-6) << "put there: no blow";
  a.go(kHeadTop - 0.020, kHeadTop - 0.020);
  a.go(kHeadTop - 0.020, kHeadTop + 0.005);
  // Its hand, which sets out with 62 mm/s at once, has the tube's own weight to draw: 500 N/m times what it goes in a
  // tick.
  EXPECT_LT(a.most_n, 500 * 0.025 / 400 + 1e-3) << "nothing else holds it on the way out";
  a.go(kHeadTop + 0.005, kHeadTop - 0.006);
  EXPECT_LT(a.beneath(), 0.002);
  EXPECT_GT(a.most_n, 1.5);
}

TEST(Skin, AThrustOfMetresPerSecondIsStopped) {
  AtHead a(kHeadTop + 0.030);
  double most = -1.0;
  for (int n = 0; n < 300; ++n) {
    a.airway.step(a.hand(std::max(kHeadTop - 0.010, kHeadTop + 0.030 - 0.004 * n)));  // 4 m/s
    most = std::max(most, a.beneath());
  }
  EXPECT_LT(most, SkinField::kDeepest);
  EXPECT_GT(a.beneath(), 0.0);
}

TEST(Skin, WhereTheAnatomyIsKnownItIsNotAsked) {
  // The same ball as anatomy: with the skin about it nothing changes, to the bit.
  RigidAnatomy anatomy;
  anatomy.surface = ball_head();
  anatomy.triangle_structure.assign(anatomy.surface.triangles.size(), Structure::other);
  const Vec3 margin = Vec3::Constant(0.02);
  const RigidField field(anatomy, {}, Vec3(kHeadMiddle - Vec3(kHeadRadius, kHeadRadius, -0.03) - margin),
                         Vec3(kHeadMiddle + Vec3::Constant(kHeadRadius) + margin), 0.001, 0.005);
  PartPoses parts;
  AtHead with(kHeadTop + 0.005), without(kHeadTop + 0.005);
  without.airway.input.skin = nullptr;
  for (AtHead* a : {&with, &without}) {
    a->airway.input.rigid = &field;
    a->airway.input.parts = &parts;
  }
  for (int n = 0; n < 400; ++n) {
    const Pose hand = AtHead::hand(kHeadTop + 0.005 - 0.00003 * n);
    const RodStep one = with.airway.step(hand), other = without.airway.step(hand);
    ASSERT_EQ(std::memcmp(one.on_hand.force.data(), other.on_hand.force.data(), 24), 0) << n;
  }
  EXPECT_GT(with.airway.loads.loads_n[kLoadPharynx], 0.5) << "else this shows nothing";
}

TEST(Skin, IsMadeForIntubationsAloneAndOnceForAHead) {
  int made = 0;
  const auto build = [&made](const SceneDescription& d, const Scene* before) {
    made = 0;
    return build_scene(d, before, [&made] { ++made; });
  };
  SceneDescription d = intubation_scene();
  const auto first = build(d, nullptr);
  EXPECT_EQ(made, 4) << "sphere tree, the tool's field, the rigid anatomy's, the skin's";
  EXPECT_FALSE(first->skin.empty());
  d.soft.materials[0].young_pa *= 1.2;
  EXPECT_FALSE(build(d, first.get())->skin.empty());
  EXPECT_EQ(made, 0);
  d.rigid.surface.points[0].x() += 1e-9;
  build(d, first.get());
  EXPECT_EQ(made, 2) << "both fields of that surface";
  d.intubation.reset();
  EXPECT_TRUE(build(d, first.get())->skin.empty());
}

}  // namespace
}  // namespace vallecula::engine
