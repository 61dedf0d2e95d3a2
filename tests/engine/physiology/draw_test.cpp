#include "engine/physiology/draw.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vallecula::engine {
namespace {

// The seeds' own tools against the C library.
TEST(Draw, TheExponentialIsTheLibrarys) {
  for (double x = -16.0; x <= 16.0; x += 0.37) EXPECT_NEAR(portable_exp(x) / std::exp(x), 1.0, 1e-12) << x;
}

TEST(Draw, TheQuantileIsTheNormals) {
  for (double p = 0.01; p < 1.0; p += 0.01)
    EXPECT_NEAR(0.5 * std::erfc(-normal_quantile(p) / std::sqrt(2.0)), p, 2e-4) << p;
}

TEST(Draw, NeighbouringSeedsLieEvenly) {
  for (int dimension = 0; dimension < 4; ++dimension) {
    int below[4] = {};
    for (std::uint64_t seed = 1; seed <= 100; ++seed) ++below[static_cast<int>(4 * even_uniform(seed, dimension))];
    for (const int quarter : below) EXPECT_NEAR(quarter, 25, 2);
  }
}

}  // namespace
}  // namespace vallecula::engine
