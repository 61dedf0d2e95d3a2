// The manikin's scan: voxels against the anatomy they were made from, noise, blur, determinism.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <queue>
#include <random>

#include "pipeline/manikin/manikin.h"

namespace vallecula::pipeline {
namespace {

/// Coarse and small, for speed; everything tested holds at any spacing.
ManikinOptions coarse_scan(double noise = 12.0, std::uint64_t seed = 3) {
  ManikinOptions options;
  options.weight_kg = 0.6;
  options.seed = seed;
  options.noise_hu = noise;
  options.in_plane_mm = 0.6;
  options.slice_mm = 1.0;
  return options;
}

const ManikinScan& quiet_scan() {
  static const ManikinScan scan = scan_manikin(coarse_scan(0.0));
  return scan;
}
const ManikinScan& noisy_scan() {
  static const ManikinScan scan = scan_manikin(coarse_scan());
  return scan;
}

TEST(ManikinScan, EveryVoxelSaysWhatLiesAtItsCentre) {
  // The scanner fills whole blocks from bounds; the labels must equal the anatomy asked point by point.
  const auto& scan = quiet_scan();
  const auto options = coarse_scan(0.0);
  const Manikin man(options.weight_kg, options.seed);
  std::mt19937 random(7);
  std::size_t wrong = 0;
  const std::size_t kSamples = 100000;
  std::uniform_int_distribution<std::size_t> pick(0, scan.labels.voxels.size() - 1);
  for (std::size_t i = 0; i < kSamples; ++i) {
    const std::size_t v = pick(random);
    if (man.label_at(scan.labels.grid.position(v)) != scan.labels.voxels[v]) ++wrong;
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(ManikinScan, EveryLabelIsThere) {
  std::array<std::size_t, 11> count{};
  for (const auto l : quiet_scan().labels.voxels) {
    ASSERT_LE(l, 10);
    ++count[l];
  }
  const double voxel = quiet_scan().labels.grid.voxel_mm3();
  for (const auto& label : kLabelNames) EXPECT_GT(count[label.value] * voxel, 15.0) << label.name;
  // The tongue's volume: about 38 x 28 x 18 at term as an ellipsoid (assumed), here scaled down.
  const double s = Manikin(0.6, 3).scale();
  EXPECT_NEAR(count[kTongue] * voxel / (s * s * s), M_PI / 6.0 * 38.0 * 28.0 * 18.0, 3000.0);
}

TEST(ManikinScan, AirwayAndTongueAreEachOnePiece) {
  const auto& labels = quiet_scan().labels;
  const Grid& grid = labels.grid;
  for (const Label wanted : {kAirway, kTongue, kEpiglottis}) {
    std::size_t all = 0;
    std::size_t start = 0;
    for (std::size_t i = 0; i < labels.voxels.size(); ++i)
      if (labels.voxels[i] == wanted) {
        ++all;
        start = i;
      }
    // From the highest voxel of the label; small specks of the voxel grid may lie apart (below 1 %).
    std::vector<std::uint8_t> seen(labels.voxels.size(), 0);
    std::size_t largest = 0;
    for (std::size_t first = start + 1; first-- > 0;) {
      if (labels.voxels[first] != wanted || seen[first]) continue;
      std::queue<std::size_t> front;
      front.push(first);
      seen[first] = 1;
      std::size_t size = 0;
      while (!front.empty()) {
        const auto c = grid.cell(front.front());
        front.pop();
        ++size;
        for (int d = 0; d < 6; ++d) {
          std::array<int, 3> n = c;
          n[d / 2] += d % 2 ? 1 : -1;
          if (!grid.contains(n[0], n[1], n[2])) continue;
          const std::size_t j = grid.index(n[0], n[1], n[2]);
          if (labels.voxels[j] != wanted || seen[j]) continue;
          seen[j] = 1;
          front.push(j);
        }
      }
      largest = std::max(largest, size);
    }
    EXPECT_GT(static_cast<double>(largest), 0.99 * static_cast<double>(all)) << int(wanted);
  }
}

TEST(ManikinScan, TheSameSeedGivesTheSameScanAndAnotherDoesNot) {
  const auto again = scan_manikin(coarse_scan());
  EXPECT_EQ(again.ct.voxels, noisy_scan().ct.voxels);
  EXPECT_EQ(again.labels.voxels, noisy_scan().labels.voxels);
  const auto other = scan_manikin(coarse_scan(12.0, 4));
  EXPECT_NE(other.labels.voxels, again.labels.voxels);
}

TEST(ManikinScan, NoiseHasTheLevelAskedFor) {
  const auto& noisy = noisy_scan();
  const auto& quiet = quiet_scan();
  double sum = 0.0;
  double square = 0.0;
  double beside = 0.0;
  std::size_t n = 0;
  for (std::size_t i = 0; i + 1 < noisy.ct.voxels.size(); ++i) {
    // Inside soft tissue, where nothing is clipped.
    if (quiet.ct.voxels[i] < 30 || quiet.ct.voxels[i] > 60 || quiet.ct.voxels[i + 1] < 30 ||
        quiet.ct.voxels[i + 1] > 60)
      continue;
    const double a = noisy.ct.voxels[i] - quiet.ct.voxels[i];
    const double b = noisy.ct.voxels[i + 1] - quiet.ct.voxels[i + 1];
    sum += a;
    square += a * a;
    beside += a * b;
    ++n;
  }
  ASSERT_GT(n, 100000u);
  const double mean = sum / n;
  EXPECT_NEAR(mean, 0.0, 0.2);
  EXPECT_NEAR(std::sqrt(square / n - mean * mean), 12.0, 0.3);
  // Grainy like reconstructed CT: neighbours go together, kernel (0.2, 0.6, 0.2): 0.24 / 0.44.
  EXPECT_NEAR(beside / square, 0.545, 0.03);
}

TEST(ManikinScan, EdgesAreBlurredOverAboutAVoxel) {
  // Across the skin of the forehead from the front: between air and tissue there is partial volume, never a jump.
  const auto& scan = quiet_scan();
  const Grid& grid = scan.ct.grid;
  const double s = Manikin(0.6, 3).scale();
  const auto at = grid.nearest({0.0, 0.0, 45.0 * s});
  int between = 0;
  bool tissue = false;
  for (int y = 0; y < grid.size[1] && !tissue; ++y) {
    const int hu = scan.ct.at(at[0], y, at[2]);
    if (hu > -950 && hu < -50) ++between;
    tissue = hu > 20;
  }
  EXPECT_TRUE(tissue);
  EXPECT_GE(between, 2);
  EXPECT_LE(between, 5);
}

TEST(ManikinScan, ABadOptionIsRefusedByName) {
  const auto message = [](const ManikinOptions& options) -> std::string {
    try {
      scan_manikin(options);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  auto options = coarse_scan();
  options.weight_kg = 9.0;
  EXPECT_NE(message(options).find("weight"), std::string::npos);
  options = coarse_scan();
  options.noise_hu = -1.0;
  EXPECT_NE(message(options).find("noise"), std::string::npos);
  options = coarse_scan();
  options.in_plane_mm = 2.0;
  EXPECT_NE(message(options).find("pixel spacing"), std::string::npos);
  options = coarse_scan();
  options.slice_mm = 0.1;
  EXPECT_NE(message(options).find("slice spacing"), std::string::npos);
}

}  // namespace
}  // namespace vallecula::pipeline
