// Figures of a motion by its spectrum (private to the library).
#pragma once

#include <optional>
#include <vector>

namespace vallecula::curricula {

/// Spectral arc length of a speed profile sampled at `rate_hz` (SPARC; Balasubramanian et al. 2012 and 2015): minus the
/// length of the normalised magnitude spectrum up to 10 Hz at most, and there up to the last bin with 5 % of the largest
/// or more, the frequencies made a unit long; zero-padded to 2^4 times the next power of two. The nearer to 0 the
/// smoother; a minimum-jerk reach has about -1.4. Nothing for fewer than two samples or where nothing moves.
std::optional<double> spectral_arc_length(const std::vector<double>& speed, double rate_hz);

/// Variance of a signal within low_hz to high_hz: Welch's periodogram of Hann windows of `segment` samples (a power of
/// two) that overlap by half, each freed of its straight line. A sinusoid of amplitude A well within the band gives
/// A^2 / 2. Nothing where there is not a whole segment.
std::optional<double> band_variance(const std::vector<double>& signal, double rate_hz, double low_hz, double high_hz,
                                    std::size_t segment);

}  // namespace vallecula::curricula
