// A thin blade at 1 m/s goes a third of its thickness in a tick. Whatever it meets stays in front of it.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/lab/experiment.h"
#include "engine/scene_data.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

constexpr double kThickness = 0.003, kSpeed = 1.0, kWay = 0.006;

/// Sweeps `blade` (about its own origin) along `direction` from just before the tissue `kWay` into it, and stays there.
/// `front`: nodes that it meets. Fails where one of them comes to lie behind the blade's middle, in any tick.
void expect_in_front(const SceneDescription& description, const Vec3& start, const Vec3& direction,
                     const std::function<bool(const Vec3&)>& front) {
  const auto scene = build_scene(description);
  std::vector<int> met;
  for (int i = 0; i < scene->model.nodes; ++i)
    if (front(scene->model.rest[i])) met.push_back(i);
  ASSERT_GT(met.size(), 10u);
  ExperimentSettings settings;
  settings.duration_s = 0.05;
  settings.measure_tissue = false;
  const auto pose = [&](double t) {
    Pose p;
    p.position = start + std::min(kSpeed * t, kWay) * direction;
    return p;
  };
  double least = 1.0, force = 0.0;
  const auto result = run_experiment(*scene, pose, settings, [&](const ExperimentStep& s, const std::vector<Vec3>& nodes) {
    for (int i : met) least = std::min(least, (nodes[i] - s.proxy_m).dot(direction));
    force = std::max(force, s.force_n.norm());
  });
  EXPECT_TRUE(result.finite);
  EXPECT_GT(least, 0.0) << "a node lies " << -1e3 * least << " mm behind the blade's middle";
  EXPECT_GT(least, kThickness / 2 - 0.0005) << "a node is more than half a millimetre inside the blade";
  EXPECT_GT(force, 0.1) << "the blade met nothing";
}

SceneDescription block(const Vec3& blade) {
  SceneDescription d;
  d.soft = testing::box_body(Vec3(0.03, 0.03, 0.015), {10, 10, 5}, {6000.0, 0.45, 1040.0});
  d.tool.surface = testing::box_surface(Vec3::Zero(), blade);
  return d;
}

TEST(Tunnelling, ABladePressedDownAtAMetreASecond) {
  expect_in_front(block(Vec3(0.06, 0.010, kThickness)), Vec3(0.015, 0.015, 0.015 + kThickness / 2 + 0.0004), -Vec3::UnitZ(),
                  [](const Vec3& p) { return p.z() > 0.0149 && std::abs(p.y() - 0.015) < 0.004; });
}

TEST(Tunnelling, ABladeSweptSidewaysAtAMetreASecond) {
  expect_in_front(block(Vec3(kThickness, 0.06, 0.010)), Vec3(-kThickness / 2 - 0.0004, 0.015, 0.012), Vec3::UnitX(),
                  [](const Vec3& p) { return p.x() < 1e-6 && p.z() > 0.0085; });
}

}  // namespace
}  // namespace vallecula::engine
