#include "curricula/score/handle_loads.h"

#include <algorithm>

#include "curricula/score/vectors.h"

namespace vallecula::curricula {

HandleLoads handle_loads(const std::array<std::array<double, 3>, kStructures>& forces_n,
                         const std::array<double, 4>& rotation_wxyz) {
  const Point up = z_axis(rotation_wxyz);
  const auto pushes = [&](LoadedStructure structure) { return dot(forces_n[structure], up); };
  HandleLoads loads;
  loads.borne_n = std::max(0.0, -pushes(kTongue) - pushes(kEpiglottis));
  const double jaw_n = std::max(0.0, pushes(kGum)) + std::max(0.0, pushes(kPalate)) + std::max(0.0, pushes(kTeeth));
  loads.levered_n = std::min(jaw_n, loads.borne_n);
  return loads;
}

}  // namespace vallecula::curricula
