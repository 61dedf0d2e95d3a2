// What a scenario asks of a manikin's shape, measured on its labels point by point and on its landmarks.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "pipeline/manikin/manikin.h"
#include "pipeline/manikin/variation.h"

namespace vallecula::pipeline {
namespace {

double apart(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Between the gums in the middle of a term manikin's mouth, down from the upper one: steps of 0.02 mm.
double opening(const Manikin& man) {
  double longest = 0.0;
  for (double y = 1.0; y < 5.0; y += 0.25) {
    double air = 0.0;
    for (double z = 1.0; z > -30.0; z -= 0.02)
      if (man.label_at({0.0, y, z}) == kAirway) air += 0.02;
    if (longest == 0.0 || air < longest) longest = air;
  }
  return longest;
}

/// Counted on a 0.5 mm lattice.
double volume(const Manikin& man, Label label) {
  int count = 0;
  for (double x = -16.0; x <= 16.0; x += 0.5)
    for (double y = 0.0; y <= 45.0; y += 0.5)
      for (double z = -60.0; z <= 0.0; z += 0.5)
        if (man.label_at({x, y, z}) == label) ++count;
  return count * 0.125;
}

TEST(ManikinShape, NothingAskedIsTheSeedsInfantToTheBit) {
  const Manikin plain(2.1, 5), asked(2.1, 5, ManikinShape{});
  EXPECT_EQ(plain.landmarks(), asked.landmarks());
  for (double y = -10.0; y < 50.0; y += 1.7)
    for (double z = -90.0; z < 30.0; z += 1.3)
      EXPECT_EQ(plain.hounsfield_at({1.1, y, z}), asked.hounsfield_at({1.1, y, z}));
}

TEST(ManikinShape, TheMouthOpensByWhatIsAsked) {
  const double usual = opening(Manikin(3.2, 0));
  // 0.8 of 22 mm is 4.4 mm less, 1.15 is 3.3 mm more; the gum turns about the condyles, 45.9 mm away, so that across it
  // hardly less than along the arc.
  EXPECT_NEAR(usual - opening(Manikin(3.2, 0, {0.8, {}, {}, {}, {}})), 4.4, 0.4);
  EXPECT_NEAR(opening(Manikin(3.2, 0, {1.15, {}, {}, {}, {}})) - usual, 3.3, 0.4);
  // It stands in place of the seed's.
  EXPECT_NEAR(opening(Manikin(3.2, 9, {0.9, {}, {}, {}, {}})), opening(Manikin(3.2, 4, {0.9, {}, {}, {}, {}})), 0.3);
}

TEST(ManikinShape, TheTongueGrowsByWhatIsAsked) {
  const double usual = volume(Manikin(3.2, 0), kTongue);
  // Width by the factor, the dorsum by that share of 18 mm: between the factor and its square.
  const double large = volume(Manikin(3.2, 0, {{}, 1.1, {}, {}, {}}), kTongue) / usual;
  EXPECT_GT(large, 1.08);
  EXPECT_LT(large, 1.22);
  const double small = volume(Manikin(3.2, 0, {{}, 0.9, {}, {}, {}}), kTongue) / usual;
  EXPECT_LT(small, 0.93);
  EXPECT_GT(small, 0.80);
}

TEST(ManikinShape, TheLarynxRisesAsAWholeAndTheMouthStays) {
  const auto usual = Manikin(3.2, 3).landmarks();
  for (const double rise : {-3.0, 1.0, 1.5}) {
    const Manikin man(3.2, 3, {{}, {}, rise, {}, {}});
    const auto marks = man.landmarks();
    for (const char* name : {"vallecula", "glottis_centre", "epiglottis_tip", "carina"}) {
      EXPECT_NEAR(marks.at(name)[2] - usual.at(name)[2], rise, 0.15) << name;
      EXPECT_NEAR(marks.at(name)[1], usual.at(name)[1], 0.15) << name;
    }
    for (const char* name : {"upper_gum_midline", "lower_gum_midline", "condyle_axis"})
      EXPECT_EQ(marks.at(name), usual.at(name)) << name;
    EXPECT_NEAR(apart(marks.at("operator_eye"), {0.0, 0.0, 0.0}), 320.2, 0.1);
    // The labels moved with the landmarks: the glottis is still a hole of air with cords beside it.
    const Point g = marks.at("glottis_centre");
    EXPECT_EQ(man.label_at(g), kAirway);
    EXPECT_EQ(man.label_at({3.5, g[1], g[2]}), kLarynx);
    for (const Point& p : man.glottis_outline()) EXPECT_LT(apart(p, g), 5.0);
  }
}

TEST(ManikinShape, NoBlockOfVoxelsIsSettledWrongWhenTheLarynxIsMoved) {
  ManikinOptions options;
  options.weight_kg = 0.9;
  options.noise_hu = 0.0;
  options.in_plane_mm = 0.6;
  options.slice_mm = 1.0;
  options.shape.larynx_height_mm = -3.0;
  const ManikinScan scan = scan_manikin(options);
  const Manikin man(options.weight_kg, options.seed, options.shape);
  const Grid& grid = scan.labels.grid;
  for (int z = 0; z < grid.size[2]; z += 2)
    for (int y = 0; y < grid.size[1]; y += 2)
      for (int x = 0; x < grid.size[0]; x += 2)
        ASSERT_EQ(scan.labels.voxels[grid.index(x, y, z)], man.label_at(grid.position(x, y, z)))
            << x << " " << y << " " << z;
}

TEST(ManikinShape, TheEpiglottisGrowsFromItsBase) {
  const auto length = [](const ManikinShape& shape) {
    return apart(Manikin(3.2, 0, shape).landmarks().at("epiglottis_tip"), {0.0, 29.0, -46.0});
  };
  const double usual = length({});
  EXPECT_NEAR(length({{}, {}, {}, 1.2, {}}), 1.2 * usual, 0.4);
  EXPECT_NEAR(length({{}, {}, {}, 0.8, {}}), 0.8 * usual, 0.4);
}

TEST(ManikinShape, GestationSetsTheWayFromTheCordsToTheCarina) {
  // Cords to mid-trachea = 2.831 + 0.6208 weeks (orbi.uliege.be 220819): 17.7 mm at 24, 26.4 at 38.
  for (const auto& [weeks, weight, half] : {std::tuple{24.0, 0.65, 17.73}, {29.0, 1.2, 20.83}, {38.0, 3.1, 26.42}}) {
    const auto marks = Manikin(weight, 7, {{}, {}, {}, {}, weeks}).landmarks();
    const double s = Manikin(weight, 7).scale();
    const Point subglottis{0.0, 34.8 * s, -53.7 * s};
    const double way = apart(marks.at("glottis_centre"), subglottis) + apart(subglottis, marks.at("carina"));
    EXPECT_NEAR(0.5 * way, half, 0.02) << weeks;
  }
}

TEST(ManikinShape, HiddenAtRestAndSeenWhenLiftedAtTheEndsOfEveryRange) {
  // A larger tongue, a longer epiglottis and a high larynx need more lift: that is what they are asked for. The expert
  // has about 15 mm of it.
  const ManikinShape shapes[] = {{0.8, {}, {}, {}, {}},    {1.15, {}, {}, {}, {}}, {{}, 0.9, {}, {}, {}},
                                 {{}, 1.1, {}, {}, {}},    {{}, {}, -3.0, {}, {}}, {{}, {}, 1.5, {}, {}},
                                 {{}, {}, {}, 0.8, {}},    {{}, {}, {}, 1.2, {}},  {{}, {}, {}, {}, 36.0},
                                 {0.9, 1.06, 1.5, 1.1, {}}};
  int i = 0;
  for (const ManikinShape& shape : shapes) {
    const Manikin man(3.2, 1, shape);
    EXPECT_LT(man.glottis_seen(0.0), 0.05) << i;
    EXPECT_GT(man.glottis_seen(15.0), 0.5) << i;
    ++i;
  }
}

TEST(ManikinShape, WhatIsOutOfRangeIsNamed) {
  const auto message = [](const ManikinShape& shape, double weight) -> std::string {
    try {
      const Manikin man(weight, 1, shape);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  const std::pair<ManikinShape, const char*> cases[] = {
      {{0.79, {}, {}, {}, {}}, "mouth opening (factor) of 0.79 is outside 0.8 to 1.15"},
      {{1.16, {}, {}, {}, {}}, "1.16"},
      {{{}, 0.89, {}, {}, {}}, "tongue's size (factor) of 0.89 is outside 0.9 to 1.1"},
      {{{}, {}, 3.1, {}, {}}, "larynx' height (mm) of 3.1 is outside -3 to 1.5"},
      {{{}, {}, {}, 1.21, {}}, "epiglottis' length (factor) of 1.21 is outside 0.8 to 1.2"},
      {{{}, {}, {}, {}, 45.0}, "gestation (weeks) of 45 is outside 22 to 44"},
      {{{}, {}, std::nan(""), {}, {}}, "larynx' height"}};
  for (const auto& [shape, words] : cases) EXPECT_NE(message(shape, 3.2).find(words), std::string::npos) << words;
  EXPECT_NE(message({{}, {}, {}, {}, 44.0}, 0.6).find("trachea's length for its gestation"), std::string::npos);
}

}  // namespace
}  // namespace vallecula::pipeline
