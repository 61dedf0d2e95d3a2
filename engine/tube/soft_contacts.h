// The tube against tongue and epiglottis, both ways. Points of the tissue's surface (the sphere tree's) that lie in
// reach of the tube are springs between both: the rod's step solves them with the tissue going on as it does, the
// tissue's next step with the tube standing where its own step has put it. Each is implicit in its own motion, neither
// waits a tick for the other, and at rest both read the same spring.
//
// In a tick: find_soft_contacts, the rod's step, press_tissue, step_tissue of the next tick (which takes the state along).
#pragma once

#include "engine/contact/tissue_contact.h"
#include "engine/scene_data.h"
#include "engine/tube/rod.h"

namespace vallecula::engine {

/// What a point of the tissue's surface remembers between ticks.
struct SoftContactMemory {
  Vec3 side = Vec3::Zero();  ///< out of the tissue, world: last direction to the tube's axis that was no way through it
  float multiplier = 0.0f;   ///< N
  float let_in = 0.0f;       ///< m: how deep the tube may be in without pressing, of what it was when they met
  bool touching = false;
  double next_check = 0.0;  ///< of SoftContactState::travel: until then the tube cannot be in reach
};

/// A point of the tissue's surface in reach of the tube.
struct SoftContact {
  std::int32_t sphere = -1;
  std::int32_t segment = 0;  ///< of the tube; the point of its axis lies `weight` along it
  double weight = 0.0;
  double gap = 0.0;             ///< m; negative: pressed in
  Vec3 axis = Vec3::Zero();     ///< that point at the start of the tick, m
  Vec3 normal = Vec3::UnitZ();  ///< out of the tissue, unit
};

/// All there is of the tube's contacts with the tissue between two steps.
struct SoftContactState {
  explicit SoftContactState(const Scene& scene);
  void forget() noexcept;  ///< as before the first tick: when tissue or tube were put back to rest

  std::vector<SoftContactMemory> memory;       ///< per sphere of the tree
  std::vector<SoftContact> found;              ///< the first `count` are this tick's, in the order of the spheres
  std::vector<ContactConstraint> constraints;  ///< the same as the tissue's step takes them; with its result after it
  int count = 0;
  int left_out = 0;  ///< points in reach that the last search had no room for: the shallowest
  /// What tube and tissue can have moved towards each other since the first tick, m (as ContactState::travel).
  double travel = 0.0;
  double nothing_before = 0.0;        ///< of `travel`: until then no part of the tissue can be in reach
  std::vector<double> cluster_check;  ///< per cluster, likewise
  std::array<Vec3, kTubeNodes> tube;  ///< where it was in the last tick, m
  double outside_from_m = 0.0;        ///< in the last tick
  bool seen = false;                  ///< there was a last tick
};

/// Finds where the tube from `outside_from_m` along it (from the tip; what is nearer the tip lies in a canal) to the grip
/// is in reach of the tissue. Writes at most `capacity` contacts for the rod's step to `out` and returns how many (also
/// state.count), at most kMostSoftContacts; of more the deepest. The tip is taken as a half ball that ends where the tube
/// does. A tube that is not finite meets nothing, nor do points of the tissue that are not. No allocation, lock, I/O or
/// exception.
int find_soft_contacts(const Scene& scene, const TissueState& tissue, const Rod& rod, const RodState& tube,
                       double outside_from_m, double friction, SoftContactState& state, RodContact* out,
                       int capacity) noexcept;

/// After the rod's step: turns its reaction into state.constraints for the tissue's step. `in`: what find_soft_contacts
/// wrote, as the step left it.
void press_tissue(const Scene& scene, const RodState& tube, const RodContact* in, SoftContactState& state) noexcept;

/// After the tissue's step, whose results are in state.constraints: hands them to the points' memory.
void keep_soft_contacts(SoftContactState& state) noexcept;

}  // namespace vallecula::engine
