#include "curricula/score/motion_figures.h"

#include <algorithm>
#include <cmath>

#include "curricula/score/spectrum.h"
#include "curricula/score/stays.h"
#include "curricula/score/vectors.h"

namespace vallecula::curricula {
namespace {

constexpr double kLeastForSmoothnessS = 1.0;

/// Means over blocks of `block_s` of the working ticks from..to, where `pose` is a number.
std::vector<Point> means(const TrialLog& log, std::size_t from, std::size_t to, double block_s, LogPose LogTick::*pose) {
  const auto ticks = std::max<long>(1, std::lround(block_s / log.header.servo_period_s));
  std::vector<Point> all;
  Point sum{};
  long counted = 0;
  for (std::size_t i = from; i <= to; ++i) {
    const LogTick& tick = log.ticks[i];
    const Point& at = (tick.*pose).position_m;
    if (paused(tick) || tick.step_used < 0 || !std::isfinite(magnitude(at))) continue;
    sum = plus(sum, at);
    if (++counted < ticks) continue;
    all.push_back(scaled(sum, 1.0 / static_cast<double>(ticks)));
    sum = {};
    counted = 0;
  }
  return all;
}

std::vector<double> ways_between(const std::vector<Point>& points) {
  std::vector<double> ways;
  for (std::size_t i = 1; i < points.size(); ++i) ways.push_back(distance(points[i], points[i - 1]));
  return ways;
}

struct Stretch {
  std::size_t first = 0, count = 0;
};

Stretch longest_without_pause(const TrialLog& log, const std::vector<Stay>& attempts) {
  Stretch longest;
  for (const Stay& attempt : attempts) {
    Stretch one{attempt.first, 0};
    for (std::size_t i = attempt.first; i <= attempt.last; ++i) {
      one = paused(log.ticks[i]) ? Stretch{i + 1, 0} : Stretch{one.first, one.count + 1};
      if (one.count > longest.count) longest = one;
    }
  }
  return longest;
}

std::optional<double> tremor_of(const std::vector<Point>& tip, double rate_hz) {
  double variance = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> way;
    for (const Point& at : tip) way.push_back(at[axis]);
    const auto one = band_variance(way, rate_hz, kTremorLowHz, kTremorHighHz, kTremorSegment);
    if (!one) return std::nullopt;
    variance += *one;
  }
  return std::sqrt(variance);
}

}  // namespace

MotionFigures measure_motion(const TrialLog& log, const std::vector<Stay>& attempts) {
  MotionFigures figures;
  for (const Stay& attempt : attempts)
    for (const double way : ways_between(means(log, attempt.first, attempt.last, kPathBlockS, &LogTick::proxy_pose)))
      figures.tip_path_m += way;
  const Stretch hand = longest_without_pause(log, attempts);
  if (hand.count == 0) return figures;
  const std::size_t last = hand.first + hand.count - 1;
  // Speeds differ from ways by a factor, which the arc length does not see.
  const auto speeds = ways_between(means(log, hand.first, last, kPathBlockS, &LogTick::device_pose));
  if (static_cast<double>(speeds.size()) * kPathBlockS >= kLeastForSmoothnessS)
    figures.smoothness = spectral_arc_length(speeds, 1.0 / kPathBlockS);
  figures.tremor_m = tremor_of(means(log, hand.first, last, kTremorBlockS, &LogTick::device_pose), 1.0 / kTremorBlockS);
  return figures;
}

}  // namespace vallecula::curricula
