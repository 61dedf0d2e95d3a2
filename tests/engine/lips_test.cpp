// The lips' membrane against its own law: force over a press, the halo of the tension, and coming back.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/state.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

constexpr double kBed = 2.5e6, kDepth = 0.003, kSpacing = 0.0008;
const Vec3 kMouthMiddle(0.10, 0.015, 0.01);  // far from the tissue

/// A flat lip of 24 x 24 mm facing up, its points kSpacing apart.
LipDescription flat_lip(double tension) {
  LipDescription lips;
  constexpr int kSide = 31;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i)
      lips.surface.points.push_back(kMouthMiddle + kSpacing * Vec3(i - kSide / 2, j - kSide / 2, 0));
  for (int j = 0; j + 1 < kSide; ++j)
    for (int i = 0; i + 1 < kSide; ++i) {
      const int a = j * kSide + i;
      lips.surface.triangles.push_back({a, a + 1, a + kSide + 1});
      lips.surface.triangles.push_back({a, a + kSide + 1, a + kSide});
    }
  lips.bed_pa_m = kBed;
  lips.tension_n_m = tension;
  lips.recovery_s = 0.15;
  return lips;
}

/// A plate whose lower face, kWide squared, is pressed kDepth into the lip.
constexpr double kWide = 0.0104;  // 13 by 13 points and half a spacing about them
SceneDescription lip_scene(double tension) {
  SceneDescription d = testing::block_scene();
  d.lips = flat_lip(tension);
  d.tool.surface = testing::box_surface(Vec3(0, 0, 0.0025), Vec3(kWide, kWide, 0.005));
  return d;
}

/// Brings the plate down in 0.2 s, holds it; the wrench at the end.
Wrench press(const Scene& scene, SceneState& state, double depth, int steps = 1500) {
  for (int n = 0; n < steps; ++n) {
    Pose tool;
    tool.position = kMouthMiddle + Vec3(0, 0, 0.001 - (depth + 0.001) * std::min(1.0, n / 200.0));
    scene.lips.step(scene.tool, tool, state.tissue.body_displacement, state.lips);
  }
  return state.lips.wrench;
}

TEST(Lips, ABedWithoutTensionAnswersByStiffnessTimesAreaTimesDepth) {
  const auto scene = build_scene(lip_scene(0.0));
  SceneState state(*scene);
  const Wrench held = press(*scene, state, kDepth);
  EXPECT_NEAR(held.force.z(), kBed * kWide * kWide * kDepth, 0.02 * held.force.z());
  EXPECT_LT(held.force.head<2>().norm(), 0.01 * held.force.z());  // symmetric
  EXPECT_LT(held.torque.norm(), 0.02 * held.force.z() * kWide);
}

// Beyond a straight edge a membrane falls off as exp(-x / l), l = sqrt(T / k): it adds k l per length of the edge and
// depth. A sharp plate without friction does not hold all of that: the lip slides on its rim.
TEST(Lips, TensionAddsItsHalo) {
  const double tension = kBed * 0.002 * 0.002;
  const auto scene = build_scene(lip_scene(tension));
  SceneState state(*scene);
  const Wrench held = press(*scene, state, kDepth);
  const double l = 0.002, bed = kBed * kDepth * kWide * kWide, halo = kBed * kDepth * 4 * kWide * l;
  EXPECT_GT(held.force.z(), bed + 0.5 * halo);
  EXPECT_LT(held.force.z(), bed + halo);
  EXPECT_LT(held.force.head<2>().norm(), 0.08 * held.force.z());
}

TEST(Lips, TheBladeLetGoFeelsNothingAndTheLipComesBack) {
  const auto scene = build_scene(lip_scene(kBed * 4e-6));
  SceneState state(*scene);
  press(*scene, state, kDepth);
  const double pressed = -state.lips.displacement[480].z();  // the middle
  EXPECT_NEAR(pressed, kDepth, 2e-5);
  Pose away;
  away.position = kMouthMiddle + Vec3(0, 0, 0.02);
  for (int n = 0; n < 150; ++n) scene->lips.step(scene->tool, away, state.tissue.body_displacement, state.lips);
  EXPECT_EQ(state.lips.wrench.force.norm(), 0.0);
  EXPECT_LT(-state.lips.displacement[480].z(), 0.5 * pressed);
  EXPECT_GT(-state.lips.displacement[480].z(), 0.02 * pressed);
  for (int n = 0; n < 3000; ++n) scene->lips.step(scene->tool, away, state.tissue.body_displacement, state.lips);
  EXPECT_TRUE(state.lips.at_rest);
}

TEST(Lips, TheHandFeelsThem) {
  const auto scene = build_scene(lip_scene(kBed * 4e-6));
  SceneState state(*scene);
  StepResult r;
  double change = 0.0;
  Vec3 last = Vec3::Zero();
  for (int n = 0; n < 1500; ++n) {
    StepInput input;
    input.device.position = kMouthMiddle + Vec3(0, 0, 0.005 - 0.009 * std::min(1.0, n / 400.0));
    r = step(*scene, state, input);
    if (n > 1200) change = std::max(change, (r.model_force_n - last).norm());
    last = r.model_force_n;
  }
  EXPECT_GT(r.model_force_n.z(), 0.3);
  // What the coupling pulls with is what the lips bear.
  const double pull = scene->proxy.stiffness_n_m * (r.proxy_pose.position - r.device_pose.position).z();
  EXPECT_NEAR(r.model_force_n.z(), pull, 0.02 * pull);
  EXPECT_LT(change, 0.005);
}

}  // namespace
}  // namespace vallecula::engine
