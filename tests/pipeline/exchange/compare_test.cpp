// Overlap and distances of boxes and balls, whose truth is geometry.
#include "pipeline/exchange/compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/pipeline/exchange/exchange_folder.h"

namespace vallecula::pipeline {
namespace {

using test::expect_message;

class CompareLabels : public test::ExchangeFolder {};

LabelImage boxes(std::array<int, 3> low, std::array<int, 3> high, std::uint8_t label) {
  LabelImage image;
  image.place.size = {40, 30, 20};
  image.place.step = {{{0.5, 0, 0}, {0, 1.0, 0}, {0, 0, 2.0}}};
  image.sets.assign(image.place.count(), 0);
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i)
        image.sets[static_cast<std::size_t>((k * 30 + j) * 40 + i)] = bit_of(label);
    }
  }
  return image;
}

TEST_F(CompareLabels, ComparisonOfShiftedBoxesIsExact) {
  // 20 x 10 x 5 voxels moved by 4 along i (2 mm): overlap 16 of 20.
  const auto a = boxes({5, 5, 5}, {24, 14, 9}, kTongue);
  const auto b = boxes({9, 5, 5}, {28, 14, 9}, kTongue);
  auto c = compare_labels(a, b);
  ASSERT_EQ(c.structures.size(), 1u);
  EXPECT_FALSE(c.resampled);
  EXPECT_EQ(c.structures[0].voxels, (std::array<std::size_t, 2>{1000, 1000}));
  EXPECT_NEAR(c.structures[0].millilitres[0], 1.0, 1e-12);
  EXPECT_NEAR(c.structures[0].dice, 0.8, 1e-12);
  EXPECT_NEAR(c.structures[0].hausdorff_mm, 2.0, 1e-6);
  EXPECT_NEAR(c.structures[0].hausdorff_95_mm, 2.0, 1e-6) << "a face of 50 is more than a twentieth of 704";
  // Boxes one in the other, 1 mm (i: 2 voxels) larger on the i side alone: that face of 50 voxels is 1 mm away.
  const auto grown = boxes({5, 5, 5}, {26, 14, 9}, kTongue);
  c = compare_labels(a, grown);
  EXPECT_NEAR(c.structures[0].hausdorff_mm, 1.0, 1e-6);
  EXPECT_NEAR(c.structures[0].dice, 2.0 * 1000 / 2100, 1e-12);
  const auto same = compare_labels(a, a);
  EXPECT_EQ(same.structures[0].dice, 1.0);
  EXPECT_EQ(same.structures[0].mean_surface_mm, 0.0);

  // The same box said from the other end of the axis: another grid, the same place.
  auto mirrored = a;
  mirrored.place.origin = a.place.position(39, 0, 0);
  mirrored.place.step[0] = -1.0 * a.place.step[0];
  for (std::size_t i = 0; i < a.sets.size(); ++i) mirrored.sets[i - i % 40 + 39 - i % 40] = a.sets[i];
  c = compare_labels(a, mirrored);
  EXPECT_TRUE(c.resampled);
  EXPECT_EQ(c.structures[0].dice, 1.0);

  const auto other = boxes({5, 5, 5}, {6, 6, 6}, kAirway);
  c = compare_labels(a, other);
  ASSERT_EQ(c.structures.size(), 2u);
  EXPECT_EQ(c.structures[0].voxels[1], 0u);
  EXPECT_EQ(c.structures[0].dice, 0.0);
  EXPECT_TRUE(std::isnan(c.structures[0].hausdorff_mm));
  auto far = a;
  far.place.origin = {900, 0, 0};
  expect_message([&] { compare_labels(a, far); }, "same scan");
}

TEST_F(CompareLabels, ComparisonOfConcentricBallsIsTheirRadiiApart) {
  const auto ball = [](double radius) {
    LabelImage image;
    image.place.size = {61, 61, 61};
    image.place.step = {{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}};
    image.sets.assign(image.place.count(), 0);
    std::size_t at = 0;
    for (int k = 0; k < 61; ++k) {
      for (int j = 0; j < 61; ++j) {
        for (int i = 0; i < 61; ++i, ++at)
          image.sets[at] = std::hypot(0.5 * (i - 30), 0.5 * (j - 30), 0.5 * (k - 30)) <= radius ? bit_of(kTongue) : 0;
      }
    }
    return image;
  };
  const auto c = compare_labels(ball(9.0), ball(12.0));
  const double ratio = std::pow(9.0 / 12.0, 3);
  EXPECT_NEAR(c.structures[0].dice, 2.0 * ratio / (1.0 + ratio), 0.01);
  EXPECT_NEAR(c.structures[0].hausdorff_mm, 3.0, 0.5) << "within a voxel";
  EXPECT_NEAR(c.structures[0].mean_surface_mm, 3.0, 0.15);
  EXPECT_LE(c.structures[0].hausdorff_95_mm, c.structures[0].hausdorff_mm);
}

}  // namespace
}  // namespace vallecula::pipeline
