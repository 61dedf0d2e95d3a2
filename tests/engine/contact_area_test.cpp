// The contact area against shapes whose area is known: a plate's own, and Hertz' circle under a ball.
#include "engine/contact/contact_area.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/lab/experiment.h"
#include "engine/scene_data.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

constexpr double kHeight = 0.020, kWidth = 0.040;

/// Mean area over the last 50 ms of 0.15 s in which the tool's lowest point, `lowest` below its origin, is brought over
/// (x, y) to each depth in turn. Block of 40 x 40 x 20 mm, E 6000 Pa, nu 0.3, fixed at its base.
std::vector<double> areas(const TriangleMesh& tool, double lowest, const std::array<int, 3>& cells,
                          const std::vector<double>& depths, double x, double y, Collision collision = Collision::aist) {
  constexpr double kEach = 0.15, kWay = 0.08, kMean = 0.05;
  SceneDescription d;
  d.soft = testing::box_body(Vec3(kWidth, kWidth, kHeight), cells, {6000.0, 0.3, 1040.0});
  d.tool.surface = tool;
  d.collision = collision;
  const auto scene = build_scene(d);
  ExperimentSettings settings;
  settings.duration_s = kEach * static_cast<double>(depths.size()) - d.step_s;
  const auto depth_of = [&](double t) { return std::min(depths.size() - 1, static_cast<std::size_t>(t / kEach + 1e-9)); };
  const auto pose = [&](double t) {
    const std::size_t n = depth_of(t);
    const double from = n == 0 ? -0.001 : depths[n - 1], share = std::min(1.0, (t - kEach * static_cast<double>(n)) / kWay);
    Pose p;
    p.position = Vec3(x, y, kHeight + lowest - from - (depths[n] - from) * share);
    return p;
  };
  std::vector<double> sums(depths.size(), 0.0), counts(depths.size(), 0.0);
  for (const ExperimentStep& s : run_experiment(*scene, pose, settings).steps) {
    const std::size_t n = depth_of(s.time_s);
    if (s.time_s < kEach * static_cast<double>(n + 1) - kMean) continue;
    sums[n] += s.area_m2;
    counts[n] += 1;
  }
  for (std::size_t n = 0; n < sums.size(); ++n) sums[n] /= counts[n];
  return sums;
}

constexpr double kMiddle = kWidth / 2;

// A vertex belongs to the plate or it does not: each edge is known to half a cell on either side.
TEST(ContactArea, UnderAPlateItIsThePlates) {
  for (const int cells : {10, 14})
    for (const double side : {0.015, 0.020}) {
      const double cell = kWidth / cells;
      const TriangleMesh plate = testing::box_surface(Vec3::Zero(), Vec3(side, side, 0.004));
      const double area = areas(plate, 0.002, {cells, cells, 4}, {0.001}, kMiddle + 0.2 * cell, kMiddle)[0];
      EXPECT_NEAR(std::sqrt(area), side, cell) << cells << " cells, " << side;
    }
}

// a^2 = R d. The circle's edge, as the plate's, is known to half a cell; it was found a quarter of one too far out, for a
// vertex counts whole. How the area grows with depth does not suffer from that.
TEST(ContactArea, UnderABallItIsHertzCircle) {
  constexpr double kRadius = 0.020, kCell = kWidth / 14;
  const std::vector<double> depths = {0.0012, 0.0024};
  const TriangleMesh ball = testing::sphere_surface(kRadius, 3);
  for (const Collision collision : {Collision::aist, Collision::triangles}) {
    double grown = 0.0;
    std::vector<std::array<double, 2>> places = {{0.25, 0.4}};
    if (collision == Collision::aist) places.insert(places.end(), {{0.5, 0.5}});
    for (const auto& [x, y] : places) {
      const auto area = areas(ball, kRadius, {14, 14, 5}, depths, kMiddle + x * kCell, kMiddle + y * kCell, collision);
      for (std::size_t n = 0; n < depths.size(); ++n)
        EXPECT_NEAR(std::sqrt(area[n] / M_PI), std::sqrt(kRadius * depths[n]), 0.5 * kCell) << 1e3 * depths[n] << " mm";
      grown += (area[1] - area[0]) / static_cast<double>(places.size());
    }
    const double truth = M_PI * kRadius * (depths[1] - depths[0]);
    EXPECT_NEAR(grown, truth, 0.2 * truth);
  }
}

TEST(ContactArea, WithoutContactThereIsNone) {
  const TriangleMesh plate = testing::box_surface(Vec3::Zero(), Vec3(0.02, 0.02, 0.004));
  EXPECT_EQ(areas(plate, 0.002, {8, 8, 4}, {-0.001}, kMiddle, kMiddle)[0], 0.0);
}

}  // namespace
}  // namespace vallecula::engine
