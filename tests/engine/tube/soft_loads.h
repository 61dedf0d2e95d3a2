// What the tube presses on the tissue with, read from the tissue's own multipliers: the other side of what the rod's
// contacts say.
#pragma once

#include "engine/contact/response.h"
#include "engine/tube/soft_contacts.h"

namespace vallecula::engine::testing {

/// Of the tube on the tissue in the last step.
struct SoftLoads {
  double tongue_n = 0.0, epiglottis_n = 0.0;  ///< sums of the magnitudes, N
  Vec3 force_n = Vec3::Zero();                ///< sum, world, N
};

inline SoftLoads soft_loads(const Scene& scene, const SoftContactState& state) noexcept {
  SoftLoads loads;
  for (int i = 0; i < state.count; ++i) {
    const ContactConstraint& c = state.constraints[i];
    if (!(c.multiplier > 0)) continue;
    const Vec3 force = c.multiplier * to_vec3(c.normal) + to_vec3(c.friction);
    const Structure of = scene.description.soft.tet_structure[scene.surface.tet[c.triangle]];
    (of == Structure::epiglottis ? loads.epiglottis_n : loads.tongue_n) += force.norm();
    loads.force_n += force;
  }
  return loads;
}

}  // namespace vallecula::engine::testing
