// The tube against tongue and epiglottis, both ways. Points of the tissue's surface (the sphere tree's) that lie in reach
// of the tube are springs between both: the rod's step solves them with the tissue going on as it does, the tissue's next
// step with the tube standing where its own step has put it. Each is implicit in its own motion, neither waits a tick for
// the other, and at rest both read the same spring.
//
// In a tick: find_soft_contacts, the rod's step, press_tissue, step_tissue (which takes the state along), soft_loads.
#pragma once

#include "engine/contact/contact_constraint.h"
#include "engine/scene_data.h"
#include "engine/tissue/tissue_state.h"
#include "engine/tube/rod.h"

namespace vallecula::engine {

/// At most so many at once; of more the deepest are kept.
constexpr int kMostSoftContacts = 192;

/// What a point of the tissue's surface remembers between ticks.
struct SoftContactMemory {
  Vec3 side = Vec3::Zero();  ///< out of the tissue, world: the last direction to the tube's axis while it was outside
  float multiplier = 0.0f;   ///< N
  float gap = 0.0f;          ///< m, of the last tick in which it was looked at
  bool touching = false;
};

/// All there is of the tube's contacts with the tissue between two steps.
struct SoftContactState {
  explicit SoftContactState(const Scene& scene);

  std::vector<SoftContactMemory> memory;       ///< per sphere of the tree
  std::vector<ContactConstraint> constraints;  ///< the first `count` are this tick's; their memory is the sphere's index
  std::vector<Vec3> point;                     ///< of the tube's axis at the start of the tick, per constraint, m
  std::vector<std::int32_t> touched, touching; ///< spheres that touch: work space, and since the last tick
  int count = 0;
  int touching_count = 0;
  int left_out = 0;  ///< points in reach that the last search had no room for

  void forget() noexcept;  ///< as before the first tick
};

/// Finds where the tube from `outside_from_m` along it (from the tip; what is nearer the tip lies in a canal) to the grip
/// is in reach of the tissue. Writes at most `capacity` contacts for the rod's step to `out` and returns how many (also
/// state.count), in the order of the tree's spheres. The tip is a half ball that ends where the tube does. Tissue or rod
/// that is not finite is met by nothing. No allocation, lock, I/O or exception.
int find_soft_contacts(const Scene& scene, const TissueState& tissue, const Rod& rod, const RodState& tube,
                       double outside_from_m, double friction, SoftContactState& state, RodContact* out,
                       int capacity) noexcept;

/// After the rod's step: turns its reaction into state.constraints for the tissue's step. `in`: what find_soft_contacts
/// wrote, with the forces the step left.
void press_tissue(const Scene& scene, const RodState& tube, const RodContact* in, SoftContactState& state) noexcept;

/// After the tissue's step: its multipliers go back to the memory of the points.
void keep_soft_multipliers(const ContactConstraint* solved, SoftContactState& state) noexcept;

/// Sums of the magnitudes of the tube's forces on the tissue in the last step, N.
struct SoftLoads {
  double tongue_n = 0.0, epiglottis_n = 0.0;
  Vec3 force_n = Vec3::Zero();  ///< all of it on the tissue, world
};
SoftLoads soft_loads(const Scene& scene, const SoftContactState& state) noexcept;

}  // namespace vallecula::engine
