// A tube's way into, along and out of the canals: which nodes are in, and which ring each has passed.
#pragma once

#include "engine/tube/passage.h"

namespace vallecula::engine {

/// Index of the last ring of the first `rings` ones that x has passed, which was `before`; -1: none.
int last_passed(const Vec3& x, const Passage::Chain& chain, int rings, const Vec3& larynx_way, int before) noexcept;

/// Lets the tip in where it lies within a canal's first outline and just beyond its plane, nodes after it as they pass
/// that plane, and out in the reverse order. At the carina takes the side that the tip's point lies at.
void follow_canals(const Passage& passage, const Vec3& larynx_way, const TubeOutside& outside, const RodState& tube,
                   double dt_s, PassageState& state) noexcept;

}  // namespace vallecula::engine
