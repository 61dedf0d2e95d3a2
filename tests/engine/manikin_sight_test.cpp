// The line of sight on the manikin's worked mid-sagittal design, whose table was made by a script of its own in the plane: the
// outlines are drawn out sideways, the glottis is a narrow slit about the mid-plane.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/sight/line_of_sight.h"

namespace vallecula::engine {
namespace {

using Outline = std::vector<std::array<double, 2>>;  // (y, z), mm

constexpr double kHalfWidth = 0.015, kSlit = 0.0001;  // m

Vec3 at(double x, const std::array<double, 2>& yz) { return Vec3(x, 1e-3 * yz[0], 1e-3 * yz[1]); }

TriangleMesh drawn_out(const Outline& outline) {
  TriangleMesh wall;
  for (const auto& p : outline)
    for (double x : {-kHalfWidth, kHalfWidth}) wall.points.push_back(at(x, p));
  for (int i = 0; i + 1 < static_cast<int>(outline.size()); ++i) {
    wall.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
    wall.triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
  }
  return wall;
}

/// What stands still: the upper lip, which hides the glottis' back from the eye, and what lies behind it.
const Outline kUpperLip = {{-1.7, 3.5}, {-5.3, 4.1}, {-5.8, 7.7}, {-1.3, 13.8}};
const Outline kGumAndPalate = {{-0.2, 5.6}, {-1.3, 1.9}, {0, 0}, {2.4, 0}, {5.6, 0.2}, {10.7, 1.6}, {16.8, 0.5}, {22.9, -3},
                               {27.7, -6.8}, {32.5, -10.7}, {34.9, -17.4}, {34.7, -25}};

/// The design's tongue with its base lifted by `lift` mm along the handle.
Outline tongue(double lift) {
  const Outline rest = {{6.5, -19}, {11, -17}, {17, -18}, {22.5, -20.5}, {26, -24}, {28.5, -28}, {29.8, -32}, {29.5, -36.5}, {28.5, -41.5}};
  const double share[] = {0, .35, .75, 1, 1, 1, .95, .75, .4};
  Outline lifted;
  for (std::size_t i = 0; i < rest.size(); ++i)
    lifted.push_back({rest[i][0] - 0.788 * lift * share[i], rest[i][1] - 0.616 * lift * share[i]});
  return lifted;
}

/// The epiglottis: its base follows by a fifth of the lift, it turns forward by 6 degrees a mm.
Outline epiglottis(double lift) {
  const Outline rest = {{29, -46}, {30.6, -41.5}, {33.6, -38}, {36.5, -34.8}};
  const double turn = 6.0 * lift * M_PI / 180, move = 0.2 * lift;
  Outline lifted;
  for (const auto& p : rest) {
    const double y = p[0] - rest[0][0], z = p[1] - rest[0][1];
    lifted.push_back({rest[0][0] - 0.788 * move + y * std::cos(turn) - z * std::sin(turn),
                      rest[0][1] - 0.616 * move + y * std::sin(turn) + z * std::cos(turn)});
  }
  return lifted;
}

TEST(ManikinSight, TheEngineSeesWhatTheDesignsTableSays) {
  SightDescription sight;
  sight.eye = Vec3(0, -0.200, 0.250);
  const std::array<double, 2> front = {29.6, -48.9}, back = {36.4, -47.1};
  sight.glottis_outline = {at(-kSlit, front), at(kSlit, front), at(kSlit, back), at(-kSlit, back)};
  sight.occluders = {drawn_out(kUpperLip), drawn_out(kGumAndPalate)};
  const LineOfSight eye(sight, {}, 400);
  auto scratch = eye.make_scratch(64);
  const auto seen = [&](double lift) {
    eye.begin(scratch, {});
    for (const Outline& part : {tongue(lift), epiglottis(lift)}) {
      const TriangleMesh wall = drawn_out(part);
      eye.add(scratch, static_cast<int>(wall.points.size()), wall.triangles, [&](int i) -> Vec3 { return wall.points[i]; });
    }
    return 100 * eye.visible(scratch);
  };
  struct Row {
    double lift, pogo;
  };
  for (const Row& row : {Row{0, 0}, {4, 0}, {6, 0}, {8, 5}, {9, 29}, {10, 46}, {11, 63}, {12, 78}, {13, 83}, {15, 85}}) {
    std::printf("lift %4.0f mm: %5.1f %% seen, table %3.0f %%\n", row.lift, seen(row.lift), row.pogo);
    EXPECT_NEAR(seen(row.lift), row.pogo, 2.5) << "lift " << row.lift;
  }
}

}  // namespace
}  // namespace vallecula::engine
