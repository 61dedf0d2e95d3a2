// A tube within a canal: what the rings' walls push with.
//
// A wall is a spring per length of canal, soft mucosa and beyond its give the cartilage. Rings are the nodes of a
// trapezoidal rule along the canal; the interval that the tip stands in ends at the tip, where the ring is
// interpolated. So no contact begins with a jump, and forces do not depend on how closely the rings follow each other.
#pragma once

#include "engine/tube/passage.h"

namespace vallecula::engine {

void add_wall_contacts(const Passage& passage, const PassageState& state, const TubeOutside& outside, const Rod& rod,
                       const RodState& tube, const PassageInput& input, double dt_s, TubeContacts& contacts) noexcept;

}  // namespace vallecula::engine
