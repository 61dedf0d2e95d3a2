#include "curricula/score/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace vallecula::curricula {
namespace {

using Spectrum = std::vector<std::complex<double>>;

constexpr int kPadLevel = 4;
constexpr double kHighestHz = 10.0, kLeastShare = 0.05;

/// In place, radix two: the size is a power of two.
void fourier(Spectrum& x) {
  const std::size_t n = x.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; (j & bit) != 0; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(x[i], x[j]);
  }
  for (std::size_t size = 2; size <= n; size *= 2) {
    Spectrum turns(size / 2);
    for (std::size_t k = 0; k < turns.size(); ++k)
      turns[k] = std::polar(1.0, -2.0 * M_PI * static_cast<double>(k) / static_cast<double>(size));
    for (std::size_t at = 0; at < n; at += size)
      for (std::size_t k = 0; k < turns.size(); ++k) {
        const std::complex<double> a = x[at + k], b = turns[k] * x[at + k + size / 2];
        x[at + k] = a + b;
        x[at + k + size / 2] = a - b;
      }
  }
}

/// Samples from..from + n less their straight line (least squares), under a Hann window.
Spectrum windowed(const std::vector<double>& signal, std::size_t from, std::size_t n) {
  const double middle = 0.5 * static_cast<double>(n - 1);
  double mean = 0.0, slope = 0.0, spread = 0.0;
  for (std::size_t i = 0; i < n; ++i) mean += signal[from + i] / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double at = static_cast<double>(i) - middle;
    slope += at * signal[from + i];
    spread += at * at;
  }
  slope /= spread;
  Spectrum x(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double hann = 0.5 - 0.5 * std::cos(2.0 * M_PI * static_cast<double>(i) / static_cast<double>(n));
    x[i] = hann * (signal[from + i] - mean - slope * (static_cast<double>(i) - middle));
  }
  return x;
}

}  // namespace

std::optional<double> spectral_arc_length(const std::vector<double>& speed, double rate_hz) {
  if (speed.size() < 2) return std::nullopt;
  std::size_t size = 1;
  while (size < speed.size()) size *= 2;
  size <<= kPadLevel;
  Spectrum x(size);
  std::copy(speed.begin(), speed.end(), x.begin());
  fourier(x);
  const double step_hz = rate_hz / static_cast<double>(size);
  const std::size_t bins = std::min(size, static_cast<std::size_t>(kHighestHz / step_hz) + 1);
  double largest = 0.0;
  for (const auto& value : x) largest = std::max(largest, std::abs(value));
  if (!(largest > 0.0) || !std::isfinite(largest)) return std::nullopt;
  const auto share = [&](std::size_t bin) { return std::abs(x[bin]) / largest; };
  std::size_t first = 0, last = bins - 1;
  while (first < last && share(first) < kLeastShare) ++first;
  while (last > first && share(last) < kLeastShare) --last;
  if (first == last) return std::nullopt;
  double length = 0.0;
  for (std::size_t bin = first; bin < last; ++bin)
    length += std::hypot(1.0 / static_cast<double>(last - first), share(bin + 1) - share(bin));
  return -length;
}

std::optional<double> band_variance(const std::vector<double>& signal, double rate_hz, double low_hz, double high_hz,
                                    std::size_t segment) {
  if (signal.size() < segment) return std::nullopt;
  const double step_hz = rate_hz / static_cast<double>(segment);
  const auto low = static_cast<std::size_t>(std::lround(low_hz / step_hz));  // bins with their middle in the band
  const std::size_t high = std::min(segment / 2, static_cast<std::size_t>(std::lround(high_hz / step_hz)) + 1);
  const double window = 3.0 / 8.0 * static_cast<double>(segment);  // sum of the squared Hann window
  double sum = 0.0;
  int segments = 0;
  for (std::size_t from = 0; from + segment <= signal.size(); from += segment / 2, ++segments) {
    Spectrum x = windowed(signal, from, segment);
    fourier(x);
    for (std::size_t bin = low; bin < high; ++bin) sum += 2.0 * std::norm(x[bin]) / (window * static_cast<double>(segment));
  }
  return sum / segments;
}

}  // namespace vallecula::curricula
