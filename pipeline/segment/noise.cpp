#include "pipeline/segment/noise.h"

#include <algorithm>
#include <cmath>

namespace vallecula::pipeline {

double noise_of(const Hounsfield& hu, const Mask& body, const Thresholds& t) {
  constexpr int kMost = 1000;
  constexpr int kApart = 4;  // the scanner's filter makes the grain of nearer neighbours alike
  std::vector<std::size_t> histogram(kMost + 1, 0);
  std::size_t n = 0;
  const auto& g = hu.grid;
  const auto soft = [&](std::size_t i) { return body.voxels[i] != 0 && std::abs(hu.voxels[i] - t.soft) < 250.0; };
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x + kApart < g.size[0]; ++x) {
        const auto i = g.index(x, y, z);
        if (!soft(i) || !soft(i + kApart)) continue;
        ++histogram[std::min(kMost, std::abs(hu.voxels[i] - hu.voxels[i + kApart]))];
        ++n;
      }
    }
  }
  std::size_t sum = 0;
  int median = 0;
  while (median < kMost && 2 * (sum += histogram[median]) < n) ++median;
  return median / 0.954;  // of the difference of two: 0.6745 times the square root of 2
}

}  // namespace vallecula::pipeline
