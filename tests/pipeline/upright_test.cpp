// Manikins that lie askew: the position found, and labels and landmarks against a truth turned with them.
#include "pipeline/segment/upright.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "pipeline/segment/segment.h"
#include "tests/pipeline/turned_manikin.h"

namespace vallecula::pipeline {
namespace {

struct Case {
  double weight_kg;
  std::uint64_t seed;
  Askew pose;
};

double dice(const Labels& a, const Labels& b, const std::vector<std::uint8_t>& which) {
  double both = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i) {
    const bool in_a = std::find(which.begin(), which.end(), a.voxels[i]) != which.end();
    const bool in_b = std::find(which.begin(), which.end(), b.voxels[i]) != which.end();
    both += in_a && in_b ? 1.0 : 0.0;
    sum += (in_a ? 1.0 : 0.0) + (in_b ? 1.0 : 0.0);
  }
  return 2.0 * both / sum;
}

class Upright : public ::testing::TestWithParam<Case> {};

TEST_P(Upright, LabelsAndLandmarksAreThoseOfTheInfantAsItLay) {
  const auto& in = GetParam();
  ManikinOptions options;
  options.weight_kg = in.weight_kg;
  options.seed = in.seed;
  const bool small = in.weight_kg < 2.0;
  const auto scan = scan_askew(options, in.pose, small ? 0.4 : 0.5, small ? 0.6 : 0.8);
  const auto s = segment(scan.ct, {});
  EXPECT_NEAR(s.pose.tilt_deg, in.pose.tilt_deg, 1.0);
  EXPECT_NEAR(s.pose.turn_deg, in.pose.turn_deg, 1.0);
  EXPECT_NEAR(s.pose.nod_deg, in.pose.nod_deg, 3.0);

  const auto found = on_series_grid(s, scan.ct.grid);
  const double tongue = dice(scan.labels, found, {kTongue});
  const double airway = dice(scan.labels, found, {kAirway});
  const double bone = dice(scan.labels, found, {kSkull, kMandible});
  const double skin = dice(scan.labels, found, {kSkin});
  const double leaf = dice(scan.labels, found, {kEpiglottis});
  EXPECT_GE(tongue, 0.95);
  EXPECT_GE(airway, 0.96);
  EXPECT_GE(bone, 0.95);
  EXPECT_GE(skin, 0.985);
  EXPECT_GE(leaf, 0.75);

  double worst = 0.0;
  for (const auto& [name, point] : Manikin(in.weight_kg, in.seed).landmarks()) {
    if (name == "operator_eye" || name == "glottis_normal") continue;
    const auto truth = moved(s.pose.scan_to_package, in.pose.to_scan(point));
    const double off = distance(Vector3(truth), Vector3(s.landmarks.at(name)));
    EXPECT_LE(off, 1.2) << name;
    worst = std::max(worst, off);
  }
  std::printf(
      "[ figures  ] tilt %.1f turn %.1f nod %.1f: tongue %.3f airway %.3f bone %.3f skin %.3f leaf %.3f, worst "
      "landmark %.2f mm\n",
      s.pose.tilt_deg, s.pose.turn_deg, s.pose.nod_deg, tongue, airway, bone, skin, leaf, worst);
}

std::vector<Case> cases() {
  std::vector<Case> list{{3.2, 1, {20.0, 30.0, 20.0, {7.0, -5.0, 11.0}}}, {0.6, 2, {-30.0, 40.0, -30.0, {}}}};
  if (std::getenv("VALLECULA_SLOW") != nullptr) {
    list.push_back({4.5, 5, {-15.0, -40.0, -20.0, {}}});
    list.push_back({1.5, 8, {5.0, 3.0, 0.0, {}}});
    list.push_back({2.2, 21, {30.0, 0.0, 0.0, {}}});
    list.push_back({3.2, 3, {0.0, -40.0, 0.0, {}}});
    list.push_back({0.9, 3, {0.0, 0.0, 30.0, {}}});
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(Askew, Upright, ::testing::ValuesIn(cases()));

TEST(UprightMaps, AnInverseUndoesItsMapAndWhatAPersonSaidMovesWithTheHead) {
  PoseChange pose;
  pose.tilt_deg = 90.0;
  pose.scan_to_package = {0, 0, 1, 5, 0, 1, 0, -2, -1, 0, 0, 3, 0, 0, 0, 1};
  const Point p{1.0, 2.0, 3.0};
  const auto q = moved(pose.scan_to_package, p);
  EXPECT_EQ(q, (Point{8.0, 0.0, 2.0}));
  const auto back = moved(inverse_of(pose.scan_to_package), q);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(back[a], p[a], 1e-12);

  Edits edits;
  edits.seeds["tongue"] = p;
  edits.landmarks["glottis_normal"] = {0.0, 0.0, 1.0};
  Grid scan;
  scan.size = {4, 4, 4};
  edits.labels = Labels(scan);
  edits.labels->at(1, 2, 3) = kTongue;
  Grid package = scan;
  package.origin = {5.0, -2.0, 0.0};
  const auto upright = put_upright(edits, pose, package);
  EXPECT_EQ(upright.seeds.at("tongue"), q);
  EXPECT_EQ(upright.landmarks.at("glottis_normal"), (Point{1.0, 0.0, 0.0}));
  EXPECT_EQ(upright.labels->at(3, 2, 2), kTongue);
  EXPECT_EQ(std::count(upright.labels->voxels.begin(), upright.labels->voxels.end(), kTongue), 1);
}

}  // namespace
}  // namespace vallecula::pipeline
