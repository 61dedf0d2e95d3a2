// The operations that the segmentation is made of, against brute force on small volumes.
#include "pipeline/segment/volume_ops.h"

#include <gtest/gtest.h>

#include <random>

namespace vallecula::pipeline {
namespace {

Mask random_mask(std::array<int, 3> size, double share, unsigned seed) {
  Grid g;
  g.size = size;
  g.spacing = {0.5, 0.7, 1.1};
  Mask m(g);
  std::mt19937 random(seed);
  for (auto& v : m.voxels) v = random() % 1000 < share * 1000 ? 1 : 0;
  return m;
}

TEST(VolumeOps, DistanceIsExactOnAnisotropicGrids) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const auto m = random_mask({13, 9, 11}, 0.02, seed);
    const auto d = distance_to(m);
    for (std::size_t i = 0; i < m.voxels.size(); ++i) {
      double best = 1e9;
      const auto p = m.grid.position(i);
      for (std::size_t j = 0; j < m.voxels.size(); ++j) {
        if (m.voxels[j] == 0) continue;
        const auto q = m.grid.position(j);
        best = std::min(best, std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                                        (p[2] - q[2]) * (p[2] - q[2])));
      }
      ASSERT_NEAR(d.voxels[i], best, 1e-4);
    }
  }
}

TEST(VolumeOps, DistanceToNothingIsFar) {
  const auto d = distance_to(random_mask({4, 5, 6}, 0.0, 1));
  for (const float v : d.voxels) EXPECT_GE(v, 1e8F);
}

TEST(VolumeOps, ComponentsAreSixConnectedAndSortedBySize) {
  const auto m = random_mask({20, 20, 20}, 0.3, 5);
  const auto c = components(m);
  std::size_t sum = 0;
  for (std::size_t id = 1; id < c.sizes.size(); ++id) {
    EXPECT_EQ(count(c.mask(static_cast<int>(id))), c.sizes[id]);
    if (id > 1) {
      EXPECT_LE(c.sizes[id], c.sizes[id - 1]);
    }
    sum += c.sizes[id];
    if (id > 3) continue;
    // Growing from one voxel of it gives all of it and nothing else.
    Mask seed(m.grid);
    for (std::size_t i = 0; i < seed.voxels.size(); ++i) {
      if (c.id.voxels[i] == static_cast<int>(id)) {
        seed.voxels[i] = 1;
        break;
      }
    }
    EXPECT_EQ(grown(seed, m).voxels, c.mask(static_cast<int>(id)).voxels);
  }
  EXPECT_EQ(sum, count(m)) << "every voxel belongs to one component";
}

TEST(VolumeOps, OpeningAndClosingAreOrdered) {
  const auto m = random_mask({24, 20, 16}, 0.4, 9);
  const auto o = opened(m, 0.8);
  const auto c = closed(m, 0.8);
  for (std::size_t i = 0; i < m.voxels.size(); ++i) {
    EXPECT_LE(o.voxels[i], m.voxels[i]);
    EXPECT_GE(c.voxels[i], m.voxels[i]);
  }
  EXPECT_EQ(opened(o, 0.8).voxels, o.voxels) << "opening twice is opening once";
}

TEST(VolumeOps, SmoothingKeepsTheMeanOfALineAndFlattens) {
  Grid g;
  g.size = {41, 41, 41};
  g.spacing = {0.5, 0.5, 0.5};
  Volume<float> v(g, 0.0F);
  v.at(20, 20, 20) = 1.0F;
  const auto s = smoothed(v, 1.0);
  double sum = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; i < s.voxels.size(); ++i) {
    sum += s.voxels[i];
    const auto p = g.position(i);
    second += s.voxels[i] * (p[0] - 10.0) * (p[0] - 10.0);
  }
  EXPECT_NEAR(sum, 1.0, 1e-3);
  EXPECT_NEAR(std::sqrt(second), 1.0, 0.03) << "its standard deviation is the one asked for, in mm";
}

TEST(VolumeOps, TravelMeetsOnTheRidgeAndAGapLeaksLittle) {
  Grid g;
  g.size = {60, 30, 30};
  Volume<float> cost(g, 1.0F);
  Mask allowed(g, 1);
  Volume<std::uint8_t> markers(g);
  for (int z = 0; z < 30; ++z) {
    for (int y = 0; y < 30; ++y) {
      for (int x = 40; x < 42; ++x) {
        if (std::abs(y - 15) > 1 || std::abs(z - 15) > 1) cost.at(x, y, z) = 60.0F;  // a wall with a hole
      }
      markers.at(59, y, z) = 2;
    }
  }
  markers.at(2, 15, 15) = 1;
  const auto shares = shared_by_travel(cost, markers, allowed);
  std::size_t leaked = 0;
  std::size_t inside = 0;
  for (int z = 0; z < 30; ++z) {
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        ++inside;
        leaked += shares.at(x, y, z) == 2 ? 1 : 0;
      }
      EXPECT_EQ(shares.at(45, y, z), 2);
    }
  }
  EXPECT_LT(static_cast<double>(leaked) / static_cast<double>(inside), 0.35);
  // Without the hole the wall is the border exactly.
  for (int z = 0; z < 30; ++z) {
    for (int y = 0; y < 30; ++y) cost.at(40, y, z) = cost.at(41, y, z) = 60.0F;
  }
  const auto tight = shared_by_travel(cost, markers, allowed);
  for (int z = 0; z < 30; ++z) {
    for (int y = 0; y < 30; ++y) {
      EXPECT_EQ(tight.at(39, y, z), 1);
      EXPECT_EQ(tight.at(42, y, z), 2);
    }
  }
}

TEST(VolumeOps, HolesAreFilledAndOpenHollowsAreNot) {
  Grid g;
  g.size = {12, 12, 12};
  Mask m(g);
  for (int z = 2; z < 10; ++z) {
    for (int y = 2; y < 10; ++y) {
      for (int x = 2; x < 10; ++x) m.at(x, y, z) = 1;
    }
  }
  m.at(5, 5, 5) = 0;
  m.at(8, 8, 9) = 0;
  const auto filled = with_holes_filled(m);
  EXPECT_EQ(filled.at(5, 5, 5), 1);
  EXPECT_EQ(filled.at(8, 8, 9), 0);
}

TEST(VolumeOps, CropAndPasteAreInverse) {
  const auto m = random_mask({9, 8, 7}, 0.5, 3);
  const Box box{{2, 1, 3}, {6, 5, 6}};
  auto copy = m;
  paste(cropped(m, box), box, copy);
  EXPECT_EQ(copy.voxels, m.voxels);
  const auto part = cropped(m, box);
  EXPECT_EQ(part.grid.position(0, 0, 0), m.grid.position(2, 1, 3));
}

}  // namespace
}  // namespace vallecula::pipeline
