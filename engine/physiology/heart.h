// The heart rate: slowed early by the vagus when larynx or epiglottis are pressed, until it has got used to that load;
// late by lack of oxygen, freed by the first breaths. Time constants and gains are assumed; what they must show is in
// tests/engine/physiology.
#pragma once

namespace vallecula::engine {

/// Fixed for an infant.
struct Heart {
  double resting_per_min = 0.0;
  double first_per_min = 0.0;  ///< at the start: at birth the heart is slow until the lungs are aerated
  double half_load_n = 0.0;    ///< load on the larynx that draws half of the vagal reflex
  double reflex = 1.0;         ///< what atropine leaves of the reflexes, 0..1
};

struct HeartState {
  double per_min = 0.0;
  double awakening = 0.0;  ///< 0 as at birth, 1 as at rest: grows by breaths
  double tissue = 0.0;     ///< saturation as heart and chemoreceptors have it
  double inflation = 0.0;  ///< 0..1: how much the last breaths hold the vagus back
  /// Of the load on larynx and epiglottis: what the vagus no longer answers, and what that is on its way to.
  double used_to_n = 0.0, getting_used_to_n = 0.0;
  double driven_per_min = 0.0;  ///< by which drive() holds it off; breaths bring it back
};

HeartState start(const Heart& h, double arterial) noexcept;

/// A breath that reached `share` (0..1) of the lungs.
void breathe(HeartState& s, double share) noexcept;

/// dt_s (s) with this arterial saturation and this load on larynx and epiglottis (N, of blade and tube together).
void beat(const Heart& h, HeartState& s, double arterial, double load_n, double dt_s) noexcept;

/// From outside, as an instructor does: the rate changes by this, within what a heart does (assumed), and stays off by as
/// much until breaths reach the lungs.
void drive(HeartState& s, double by_per_min) noexcept;

/// Blood flow as a share of the flow at rest: an infant's stroke volume hardly changes.
double flow(const Heart& h, const HeartState& s) noexcept;

}  // namespace vallecula::engine
