// A tube within a canal: which nodes are in, and what the rings' walls push with.
//
// A wall is a spring per length of canal, soft mucosa and beyond its give the cartilage. Rings are the nodes of a
// trapezoidal rule along the canal; the interval that the tip stands in ends at the tip, where the ring is
// interpolated. So no contact begins with a jump, and forces do not depend on how closely the rings follow each other.
#pragma once

#include "engine/tube/passage.h"

namespace vallecula::engine {

/// Index of the last ring of the first `rings` ones that x has passed, which was `before`; -1: none.
int last_passed(const Vec3& x, const Passage::Chain& chain, int rings, const Vec3& larynx_way, int before) noexcept;

/// Lets the tip in where it lies within a canal's first outline and just beyond its plane, nodes after it as they pass
/// that plane, and out in the reverse order. At the carina takes the side that the tip's point lies at.
void follow_canals(const Passage& passage, const Vec3& larynx_way, const TubeOutside& outside, const RodState& tube,
                   double dt_s, PassageState& state) noexcept;

void add_wall_contacts(const Passage& passage, const PassageState& state, const TubeOutside& outside, const Rod& rod,
                       const RodState& tube, const PassageInput& input, double dt_s, TubeContacts& contacts) noexcept;

}  // namespace vallecula::engine
