// Draws that come out the same on every machine: nothing of <random>'s distributions, nothing of the C library's exp.
#pragma once

#include <cstdint>

namespace vallecula::engine {

/// e^x for |x| <= 16, within 1e-12 of itself: Taylor's series of x / 256, squared eight times.
inline double portable_exp(double x) noexcept {
  const double y = x / 256.0;
  double sum = 1.0, term = 1.0;
  for (int n = 1; n <= 8; ++n) {
    term *= y / n;
    sum += term;
  }
  for (int k = 0; k < 8; ++k) sum *= sum;
  return sum;
}

/// The standard normal's quantile of p, within -4 and 4, by the cumulative function 1 / (1 + exp(-1.5976 z - 0.070566
/// z^3)) (Page 1977; off by 0.00014 at most).
inline double normal_quantile(double p) noexcept {
  double low = -4.0, high = 4.0;
  for (int k = 0; k < 50; ++k) {
    const double z = (low + high) / 2;
    (1.0 / (1.0 + portable_exp(-1.5976 * z - 0.070566 * z * z * z)) < p ? low : high) = z;
  }
  return (low + high) / 2;
}

/// SplitMix64 (Steele, Lea and Flood 2014): neighbouring seeds give unrelated draws, and eight bytes are all its state.
struct Draw {
  std::uint64_t state = 0;

  std::uint64_t bits() noexcept {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double uniform() noexcept { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  double between(double low, double high) noexcept { return low + (high - low) * uniform(); }
  /// Median 1; sigma is the standard deviation of the logarithm.
  double lognormal(double sigma) noexcept { return portable_exp(sigma * normal_quantile(uniform())); }
};

/// Member `seed` of a sequence in [0, 1) whose members 1, 2, 3 ... lie evenly in each of four dimensions and in all of
/// them together (Richtmyer 1951: multiples of the square roots of 2, 3, 5, 7): a few infants are a fair sample.
inline double even_uniform(std::uint64_t seed, int dimension) noexcept {
  constexpr std::uint64_t kSteps[] = {0x6a09e667f3bcc909u, 0xbb67ae8584caa73bu, 0x3c6ef372fe94f82bu,
                                      0xa54ff53a5f1d36f1u};
  const std::uint64_t at = (std::uint64_t{1} << 63) + seed * kSteps[dimension];
  return static_cast<double>(at >> 11) * 0x1.0p-53;
}

}  // namespace vallecula::engine
