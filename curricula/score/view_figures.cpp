#include "curricula/score/view_figures.h"

#include <cmath>

#include "curricula/score/stays.h"

namespace vallecula::curricula {

ViewFigures measure_view(const TrialLog& log, const Scenario& scenario, const std::vector<Stay>& attempts) {
  const double period_s = log.header.servo_period_s;
  ViewFigures figures;
  double sum_percent = 0.0;
  long long any = 0, in_sight = 0;  // ticks
  for (const Stay& attempt : attempts) {
    double percent = 0.0;  // the newest sample's
    long long worked = 0, kept = 0;
    double since_s = 0.0;
    for (std::size_t i = attempt.first; i <= attempt.last; ++i) {
      const LogTick& tick = log.ticks[i];
      if (paused(tick)) continue;
      if (tick.has_sight && std::isfinite(tick.glottis_visible)) percent = 100.0 * tick.glottis_visible;
      ++worked;
      if (percent > 0.0) ++any, sum_percent += percent;
      if (percent < scenario.sight_percent) {
        kept = 0;
        continue;
      }
      ++in_sight;
      if (kept++ == 0) since_s = tick.time_s;
      if (!figures.time_to_stable_s && static_cast<double>(kept) * period_s >= kStableViewS - 0.5 * period_s) {
        figures.time_to_stable_s = static_cast<double>(worked - kept) * period_s;
        figures.stable_at_s = since_s;
      }
    }
  }
  if (any > 0) figures.mean_percent = sum_percent / static_cast<double>(any);
  figures.in_sight_s = static_cast<double>(in_sight) * period_s;
  return figures;
}

std::optional<int> cormack_lehane(double best_percent) noexcept {
  if (!(best_percent > 0.0)) return std::nullopt;
  return best_percent > 50.0 ? 1 : 2;
}

}  // namespace vallecula::curricula
