// The tube above the canals: balls along it against the rigid anatomy, the skin about it and the blade.
#pragma once

#include "engine/tube/passage.h"

namespace vallecula::engine {

void add_surface_contacts(const Passage& passage, PassageState& state, const TubeOutside& outside, const Rod& rod,
                          const RodState& tube, const PassageInput& input, double dt_s,
                          TubeContacts& contacts) noexcept;

}  // namespace vallecula::engine
