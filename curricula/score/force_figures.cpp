#include "curricula/score/force_figures.h"

#include <algorithm>

#include "curricula/score/handle_loads.h"
#include "curricula/score/vectors.h"

namespace vallecula::curricula {
namespace {

HandleLoads along_the_handle(const LogTick& tick) {
  std::array<std::array<double, 3>, kStructures> forces_n;
  std::transform(tick.loads.begin(), tick.loads.end(), forces_n.begin(), [](const LogLoad& load) { return load.force_n; });
  return handle_loads(forces_n, tick.proxy_pose.rotation_wxyz);
}

bool all_finite(const LogTick& tick) {
  return std::all_of(tick.loads.begin(), tick.loads.end(),
                     [](const LogLoad& load) { return std::isfinite(magnitude(load.force_n)); });
}

}  // namespace

ForceFigures measure_forces_beyond_peaks(const TrialLog& log, const Scenario& scenario) {
  const double period_s = log.header.servo_period_s;
  ForceFigures figures;
  long long touched = 0, over = 0;
  double tongue_n = 0.0, borne_n = 0.0, levered_n = 0.0;  // sums over ticks
  for (const LogTick& tick : log.ticks) {
    if (paused(tick) || !all_finite(tick)) continue;
    const double force_n = magnitude(tick.loads[kTongue].force_n);
    if (force_n > 0.0) ++touched;
    tongue_n += force_n;
    const double area_m2 = tick.loads[kTongue].area_m2;
    if (force_n >= kLeastPressingN && area_m2 > 0.0) {
      if (!figures.tongue_pressure_pa) figures.tongue_pressure_pa.emplace();
      figures.tongue_pressure_pa->take(force_n / area_m2, tick.time_s);
    }
    const HandleLoads loads = along_the_handle(tick);
    borne_n += loads.borne_n;
    levered_n += loads.levered_n;
    figures.levered_n.take(loads.levered_n, tick.time_s);
    if (loads.levered_n > scenario.targets.gum_force_n && over++ == 0) figures.levered_over_target_at_s = tick.time_s;
  }
  figures.tongue_contact_s = static_cast<double>(touched) * period_s;
  figures.tongue_integral_ns = tongue_n * period_s;
  if (touched > 0) figures.mean_tongue_n = tongue_n / static_cast<double>(touched);
  if (borne_n * period_s >= kLeastLiftedNs) figures.lift_share = 1.0 - levered_n / borne_n;
  figures.levered_over_target_s = static_cast<double>(over) * period_s;
  return figures;
}

}  // namespace vallecula::curricula
