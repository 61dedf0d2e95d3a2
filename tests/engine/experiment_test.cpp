// What the laboratory's runs promise: friction by Coulomb, volume, both collision methods alike, the limit, divergence told.
#include "engine/lab/experiment.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/scene_data.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

constexpr double kTongueHeight = 0.015;

SceneDescription block_under_plate(double poisson, const Vec3& plate) {
  SceneDescription d;
  d.soft = testing::box_body(Vec3(0.03, 0.03, kTongueHeight), {10, 10, 5}, {6000.0, poisson, 1040.0});
  d.tool.surface = testing::box_surface(Vec3(0, 0, plate.z() / 2), plate);
  return d;
}

Pose at(double x, double depth) {
  Pose pose;
  pose.position = Vec3(x, 0.015, kTongueHeight - depth);
  return pose;
}

// Pressed by 1 mm in 0.2 s, held to 0.4 s, then dragged along x at 20 mm/s by a plate without edges on the block: at first it
// sticks, once it slides tangential over normal force is mu.
TEST(Experiment, FrictionIsCoulombs) {
  for (double mu : {0.0, 0.1, 0.3}) {
    SceneDescription d = block_under_plate(0.45, Vec3(0.09, 0.06, 0.003));
    d.friction = mu;
    const auto scene = build_scene(d);
    ExperimentSettings settings;
    settings.duration_s = 1.0;
    settings.measure_tissue = false;
    const auto result = run_experiment(
        *scene, [](double t) { return at(0.015 + 0.02 * std::max(0.0, t - 0.4), 0.001 * std::min(1.0, t / 0.2)); }, settings);
    double most = 0.0, sliding = 0.0, count = 0.0;
    for (const ExperimentStep& s : result.steps) {
      if (s.time_s < 0.3) continue;
      const double ratio = std::hypot(s.force_n.x(), s.force_n.y()) / s.force_n.z();
      most = std::max(most, ratio);
      if (s.time_s > 0.85) {
        sliding += ratio;
        count += 1;
      }
    }
    EXPECT_NEAR(sliding / count, mu, 0.03 * mu + 0.002) << "mu " << mu;
    EXPECT_LT(most, 1.1 * mu + 0.01) << "mu " << mu;
  }
}

// A press by 35 % of the thickness: nothing is inverted on the way, and the whole loses less than a hundredth of its volume.
// Without the hold it loses what its compressibility allows, 4 % at nu 0.45.
TEST(Experiment, AStrongPressKeepsTheVolume) {
  const auto press = [](double poisson, bool hold, double& lost) {
    SceneDescription d = block_under_plate(poisson, Vec3(0.012, 0.012, 0.003));
    d.hold_volume = hold;
    ExperimentSettings settings;
    settings.duration_s = 0.8;
    const auto result = run_experiment(
        *build_scene(d), [](double t) { return at(0.015, 0.35 * kTongueHeight * std::min(1.0, t / 0.4)); }, settings);
    lost = 0.0;
    for (const ExperimentStep& s : result.steps) {
      EXPECT_EQ(s.inverted, 0) << "nu " << poisson << ", " << s.time_s << " s";
      lost = std::max(lost, -s.volume_change);
    }
    EXPECT_LT(result.steps.back().penetration_m, 0.0004) << "nu " << poisson;
  };
  double held = 0.0, free = 0.0;
  for (double poisson : {0.45, 0.49, 0.497}) {
    press(poisson, true, held);
    EXPECT_LT(held, 0.01) << "nu " << poisson;
  }
  press(0.45, false, free);
  EXPECT_GT(free, 0.03);
}

// Tissue that is meant to be compressible is let be.
TEST(Experiment, ASpongeIsNotHeld) {
  SceneDescription d = block_under_plate(0.3, Vec3(0.012, 0.012, 0.003));
  ExperimentSettings settings;
  settings.duration_s = 0.5;
  const auto run = [&] {
    return run_experiment(
        *build_scene(d), [](double t) { return at(0.015, 0.2 * kTongueHeight * std::min(1.0, t / 0.4)); }, settings);
  };
  const Vec3 with = run().steps.back().force_n;
  d.hold_volume = false;
  EXPECT_EQ(run().steps.back().force_n, with);
}

// A plate as wide as the block meets no edge: the sphere tree and the direct tests of primitives find the same force.
TEST(Experiment, BothCollisionMethodsFindTheSameForce) {
  double force[2];
  for (int i = 0; i < 2; ++i) {
    SceneDescription d = block_under_plate(0.45, Vec3(0.06, 0.06, 0.003));
    d.collision = i == 0 ? Collision::aist : Collision::triangles;
    const auto scene = build_scene(d);
    ExperimentSettings settings;
    settings.duration_s = 0.6;
    settings.measure_tissue = false;
    force[i] = run_experiment(*scene, [](double t) { return at(0.015, 0.001 * std::min(1.0, t / 0.2)); }, settings)
                   .steps.back()
                   .force_n.z();
  }
  EXPECT_GT(force[0], 0.2);
  EXPECT_NEAR(force[1], force[0], 0.03 * force[0]);
}

// Far in at 100 mm/s, held, back at once: over the limit the displayed force is clamped and changes gently, afterwards the
// tissue is where it was.
TEST(Experiment, OverTheLimitTheTissueReturns) {
  SceneDescription d = block_under_plate(0.45, Vec3(0.012, 0.012, 0.003));
  for (TissueMaterial& m : d.soft.materials) m.young_pa = 20000.0;
  const auto scene = build_scene(d);
  ExperimentSettings settings;
  settings.duration_s = 1.9;
  settings.force_limit_n = 3.0;
  const auto result = run_experiment(
      *scene, [](double t) { return at(0.015, t < 0.8 ? std::min(0.02, 0.1 * t) : -0.005); }, settings);
  EXPECT_TRUE(result.finite);
  EXPECT_TRUE(result.limit_entered);
  EXPECT_LT(result.residual_m, 1e-4);
  Vec3 last = Vec3::Zero();
  for (const ExperimentStep& s : result.steps) {
    EXPECT_LE(s.force_n.norm(), 3.0 * (1 + 1e-9));
    EXPECT_LE((s.force_n - last).norm(), settings.force_rate_n_s * 0.001 * (1 + 1e-9));
    last = s.force_n;
  }
}

// The same motion twice gives the same bits.
TEST(Experiment, TwiceTheSame) {
  const auto scene = build_scene(block_under_plate(0.45, Vec3(0.012, 0.012, 0.003)));
  ExperimentSettings settings;
  settings.duration_s = 0.3;
  settings.measure_tissue = false;
  const auto run = [&] {
    return run_experiment(*scene, [](double t) { return at(0.013 + 0.01 * t, 0.01 * t); }, settings).final_nodes;
  };
  const auto one = run(), two = run();
  for (std::size_t i = 0; i < one.size(); ++i) ASSERT_EQ(one[i], two[i]) << i;
}

}  // namespace
}  // namespace vallecula::engine
