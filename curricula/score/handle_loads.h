// Lifting and levering apart, by statics along the handle: what the score sums up and what the bars show live.
#pragma once

#include <array>

#include "curricula/trial_log.h"

namespace vallecula::curricula {

/// What the blade bears at a moment, N.
struct HandleLoads {
  double borne_n = 0.0;    ///< L, of tongue and epiglottis
  double levered_n = 0.0;  ///< what of it the upper jaw bears: min(J, L)
  double lifted_n() const { return borne_n - levered_n; }  ///< what of it the hand itself bears
};

/// Along the handle's axis u (the blade's own z axis, along which a lift goes): tongue and epiglottis load the blade
/// with L = max(0, -(F_tongue + F_epiglottis) . u). A hand that lifts bears all of L. A blade that turns about the upper
/// jaw is held up by it: gum, palate and teeth push it with J = sum of max(0, F . u), and min(J, L) of the load is borne
/// by that fulcrum, by a turning moment of the hand and not by its lift. That the two are shown apart follows the
/// Imperial trainer (ICRA 2023); the definition is this program's own.
/// `forces_n`: on the blade by structure (LoadedStructure's order), world axes, N; `rotation_wxyz`: the blade's, tool to
/// world, of length 1.
HandleLoads handle_loads(const std::array<std::array<double, 3>, kStructures>& forces_n,
                         const std::array<double, 4>& rotation_wxyz);

}  // namespace vallecula::curricula
