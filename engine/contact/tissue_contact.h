// Where the tool meets the tissue: the sphere tree is queried against the tool's distance field and each sphere in reach
// gives one constraint.
#pragma once

#include <vector>

#include "engine/aist/sphere_tree.h"
#include "engine/contact/contact_constraint.h"
#include "engine/contact/tool_field.h"
#include "engine/tissue/tissue_state.h"

namespace vallecula::engine {

/// What a sphere remembers between ticks.
struct SphereContact {
  Vec3 side = Vec3::Zero();  ///< tool frame: outward normal of the last side that was not penetrating
  float multiplier = 0.0f;   ///< N
  float gap = 0.0f;          ///< m, of the last tick in which it was looked at
  bool touching = false;
  bool pushing = false;      ///< carried force in the last tick: where the solver's choice of contacts begins
  Vec3 slip = Vec3::Zero();  ///< tool frame, as ContactConstraint::slip
  float force = 0.0f;        ///< normal force of the last tick, N
  double next_check = 0.0;   ///< of ContactState::travel: until then the tool cannot be in reach
};

/// Contacts between the tissue and the tube are at most so many at once.
constexpr int kMostSoftContacts = 192;

struct ContactState {
  /// For the sphere tree.
  explicit ContactState(const SphereTree& tree)
      : memory(tree.spheres.size()), constraints(tree.spheres.size() + kMostSoftContacts),
        cluster_check(tree.clusters.size(), 0.0), cluster_near(tree.clusters.size(), 0) {}
  /// For `vertices` surface vertices that give at most `most` constraints.
  ContactState(std::size_t vertices, std::size_t most)
      : memory(vertices), of_spheres(false), constraints(most + kMostSoftContacts) {}

  std::vector<SphereContact> memory;           ///< per sphere, or per surface vertex where triangles are tested
  bool of_spheres = true;                      ///< which of the two
  std::vector<ContactConstraint> constraints;  ///< the first `count` are this tick's
  int count = 0;
  int of_tube = 0;  ///< behind these, so many of the tube's: solved in the same system, but none of the tool's
  /// What tool and tissue can have moved towards each other since rest, m: the sum over the ticks of the tool's way and
  /// of the fastest node's. A sphere or cluster seen far away need not be looked at before the travel has used up the
  /// distance.
  double travel = 0.0;
  std::vector<double> cluster_check;           ///< per cluster, as SphereContact::next_check
  std::vector<std::int8_t> cluster_near;       ///< per cluster: ticks for which the tool is taken to be at it

  void forget();                               ///< as before the first tick
};

/// Finds this tick's constraints with the tool at `tool` (it was at `previous` a tick ago). A constraint's gap is that of
/// the tissue's surface point next to the sphere. DESIGN 4.3 writes (c' - q) . n >= r + g with the rest values of r and
/// g; here the offset r + g is taken as the tissue carries it now (c minus its surface point), since a rigid offset stops
/// the tool early by the strain times r + g: 0.3 mm under a 30 % press with 1 mm spheres.
/// Where the surface has spheres of its own, the grid's spheres within are the second line: they keep the tool's edges
/// and tip, which may slip between surface points, from cutting into the tissue.
/// The normal is that of the tool's field on the last side that was not penetrating, kept while in contact. A gap falls
/// from tick to tick by no more than tool and tissue moved: a side that is lost at an edge cannot turn into a blow.
void find_contacts(const SphereTree& tree, const SoftSurface& surface, const std::vector<std::array<int, 4>>& tets,
                   const TissueModel& model, const TissueState& tissue, const ToolField& field, const Pose& tool,
                   const Pose& previous, float contact_stiffness_per_area, float friction, ContactState& contacts) noexcept;

/// Hands the constraints' multipliers and slips back to the spheres' memory (after the step with the tool at `tool`).
void keep_multipliers(const Pose& tool, ContactState& contacts) noexcept;

}  // namespace vallecula::engine
