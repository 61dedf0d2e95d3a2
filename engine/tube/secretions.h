// The fluid on the throat's floor: how high it stands, and what a catheter draws of it.
#pragma once

#include "engine/tube/intubation.h"

namespace vallecula::engine {

/// Returns `secretions` as they are. Throws std::invalid_argument with the number at fault.
Secretions checked(const Secretions& secretions);

/// How high `volume_m3` stands above the floor, m: it has upright walls (a simplification).
inline double level(const Secretions& s, double volume_m3) noexcept { return volume_m3 / s.area_m2; }

/// What a catheter with its opening's middle at `tip` draws, m^3/s, which is nothing unless the opening dips into what
/// is there.
double drawn(const Secretions& s, double volume_m3, const Vec3& tip, double inner_diameter_m) noexcept;

}  // namespace vallecula::engine
