// What the blade did to the tissue beyond its peaks: part of every trial's score.
#pragma once

#include <optional>

#include "curricula/scenario.h"
#include "curricula/score/peak.h"
#include "curricula/trial_log.h"

namespace vallecula::curricula {

/// Forces are model forces; ticks that are paused, or whose force is no number, count for nothing.
struct ForceFigures {
  double tongue_contact_s = 0.0;        ///< time with any force on the tongue, in the whole trial
  double tongue_integral_ns = 0.0;      ///< of the magnitude over that time (PMID 1519691)
  std::optional<double> mean_tongue_n;  ///< the integral by that time, not by the attempt's; never touched: nothing
  /// Largest mean pressure over the contact, force by area, of ticks with kLeastPressingN or more on the tongue. The
  /// area is the surface's at rest, in grains of a mesh point's share; within it pressure is higher at edges. Nothing
  /// where the log knows no areas or the tongue was not pressed.
  std::optional<Peak> tongue_pressure_pa;
  /// Share (0..1) of the load on the blade that the hand itself lifts; the rest is levered. Nothing where the load was
  /// too little to tell (kLeastLiftedNs).
  std::optional<double> lift_share;
  Peak levered_n;                          ///< largest load that the upper jaw bore for the hand
  double levered_over_target_s = 0.0;      ///< time with more of it than the scenario's target for the gums
  double levered_over_target_at_s = -1.0;  ///< the first of it; -1: never
};

constexpr double kLeastLiftedNs = 0.1;   ///< assumed
constexpr double kLeastPressingN = 0.5;  ///< assumed: below it a contact is a grain or two

/// Lifting and levering by handle_loads (curricula/score/handle_loads.h): lift_share is 1 - (integral of the levered
/// part) / (integral of what is borne).
ForceFigures measure_forces_beyond_peaks(const TrialLog& log, const Scenario& scenario);

}  // namespace vallecula::curricula
