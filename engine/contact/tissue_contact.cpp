#include "engine/contact/tissue_contact.h"

#include <algorithm>
#include <cmath>

namespace vallecula::engine {

namespace {

constexpr double kReach = 0.00012;    // constraints are set up this far ahead of touch, plus the tool's way in the tick
constexpr double kTouching = 0.0001;  // within it a sphere counts as in contact and keeps its side
constexpr double kShallow = 0.0002;   // up to this depth the field's gradient is still that of the near side
constexpr double kSameSide = 0.3;     // cosine between the kept side and the field's gradient
constexpr int kNearTicks = 8;         // a cluster the tool is at is not asked again before whether it still is
constexpr int kExitSteps = 24;
constexpr float kGripShare = 0.1f;  // of the contact stiffness: how firmly a point sticks to the tool
// Share of a tick's contact force that is taken over into the kept multiplier. A multiplier that took over all of it
// would be an undamped integrator on top of the tissue's inertia: it oscillates once the contact stiffness exceeds
// about twice the nodes' own (seen: a 4-fold force reading on a plate at rest). A twentieth settles in some 20 ms.
constexpr float kCarriedShare = 0.05f;
// And what a kept multiplier loses a tick: where a gap cannot be closed, on tissue crushed against what it hangs on, it
// would grow for ever (seen: 7 N/s under a blade at rest). It leaves a twentieth of a gap that is 1 % of the force's
// way.
constexpr float kLeak = 0.0025f;

Vec3 node_position(const TissueModel& model, const TissueState& tissue, int node) {
  return model.rest[node] + tissue.displacement[node];
}

/// Way out of the tool along `side` from a point inside, m; found by walking the field (each step is safe: |distance|).
double exit_distance(const SignedDistanceGrid& field, const Vec3& p, const Vec3& side) {
  double way = 0.0;
  for (int i = 0; i < kExitSteps; ++i) {
    const double d = field.distance(p + way * side);
    if (d >= 0) break;
    way += std::max(-d, 1e-5);
  }
  return way;
}

}  // namespace

void ContactState::forget() {
  std::fill(memory.begin(), memory.end(), SphereContact{});
  std::fill(cluster_check.begin(), cluster_check.end(), 0.0);
  std::fill(cluster_near.begin(), cluster_near.end(), 0);
  count = of_tube = 0;
  travel = 0.0;
}

void find_contacts(const SphereTree& tree, const SoftSurface& surface, const std::vector<std::array<int, 4>>& tets,
                   const TissueModel& model, const TissueState& tissue, const ToolField& field, const Pose& tool,
                   const Pose& previous, float contact_stiffness_per_area, float friction,
                   ContactState& contacts) noexcept {
  contacts.count = 0;
  const Mat3 to_world = tool.rotation.toRotationMatrix();
  const Mat3 to_tool = to_world.transpose();
  // How far any part of the tool moved in this tick, and any node in the last.
  const double moved =
      (tool.position - previous.position).norm() + field.radius * tool.rotation.angularDistance(previous.rotation);
  const double approach = moved + tissue.fastest_m;
  contacts.travel += approach;
  const double reach = std::min(kReach + moved, field.fine.band() * 0.9);

  for (std::size_t n = 0; n < tree.clusters.size(); ++n) {
    const SphereCluster& cluster = tree.clusters[n];
    if (contacts.travel < contacts.cluster_check[n]) continue;
    if (contacts.cluster_near[n] > 0) {
      --contacts.cluster_near[n];
    } else {
      Vec3 low = node_position(model, tissue, tree.cluster_nodes[cluster.first_node]), high = low;
      for (int i = 1; i < cluster.node_count; ++i) {
        const Vec3 p = node_position(model, tissue, tree.cluster_nodes[cluster.first_node + i]);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      const double half = 0.5 * (high - low).norm();
      const double clear = field.coarse.distance(to_tool * (0.5 * (low + high) - tool.position)) - half - kReach;
      if (clear > moved) {
        contacts.cluster_check[n] = contacts.travel + clear;
        for (int s = cluster.first; s < cluster.first + cluster.count; ++s)
          if (contacts.memory[s].touching) contacts.memory[s] = SphereContact{};
        continue;
      }
      contacts.cluster_near[n] = kNearTicks;
    }
    for (int s = cluster.first; s < cluster.first + cluster.count; ++s) {
      const InnerSphere& sphere = tree.spheres[s];
      SphereContact& memory = contacts.memory[s];
      if (!sphere.touchable || contacts.travel < memory.next_check) continue;
      ContactConstraint& c = contacts.constraints[contacts.count];  // taken only if it turns out to be in reach
      Vec3 world = Vec3::Zero();
      for (int k = 0; k < 4; ++k) {
        c.node[k] = sphere.core ? tets[sphere.tet][k] : surface.triangles[sphere.triangle][std::min(k, 2)];
        c.weight[k] = static_cast<float>(sphere.core ? sphere.weight[k] : k < 3 ? sphere.surface_weight[k] : 0.0);
        world += c.weight[k] * node_position(model, tissue, c.node[k]);
      }
      const Vec3 local = to_tool * (world - tool.position);
      const SignedDistanceGrid::Sample here = field.fine.sample(local);
      if (here.distance - sphere.standoff > reach && !(memory.touching && memory.multiplier > 0)) {
        memory = SphereContact{};
        memory.next_check = contacts.travel + here.distance - sphere.standoff - kReach;
        continue;
      }
      double gap = here.distance;  // of the point; the offset is taken off at the end
      if (!memory.touching) {
        // Met within the tick: the side is where the point was seen from a tick ago if it is inside by now.
        const Vec3 before = gap < 0 ? field.fine.sample(previous.to_local(world)).gradient : here.gradient;
        memory.side = before.squaredNorm() > 0 ? before : here.gradient;
        memory.gap = 0.0f;  // it was outside
      } else if (gap > -kShallow) {
        // Outside, or so little inside that the nearest way out is still on the near side: the side turns with the
        // field.
        if (here.gradient.squaredNorm() > 0) memory.side = here.gradient;
      }
      if (!(memory.side.squaredNorm() > 0.5)) {
        memory = SphereContact{};
        continue;
      }
      if (gap <= -kShallow || (gap < 0 && here.gradient.dot(memory.side) <= kSameSide))
        gap = -exit_distance(field.fine, local, memory.side);
      gap -= sphere.standoff;
      gap = std::max(gap, std::min(0.0, double(memory.gap)) - approach);
      memory.gap = static_cast<float>(gap);
      memory.touching = gap < kTouching || memory.multiplier > 0;

      ++contacts.count;
      c.normal = from_vec3(to_world * memory.side);
      c.gap = static_cast<float>(gap);
      c.stiffness = static_cast<float>(contact_stiffness_per_area * sphere.area);
      c.multiplier = memory.multiplier;
      c.memory = s;
      c.triangle = sphere.triangle;
      c.grip = 0.0f;
      c.friction = F4{0, 0, 0, 0};
      if (friction > 0) {
        const Vec3 before = previous.to_local(world);
        const Vec3 slip = memory.slip + local - before;
        c.slip = from_vec3(to_world * (slip - slip.dot(memory.side) * memory.side));
        c.grip = kGripShare * c.stiffness;
        c.friction_limit = friction * memory.force;
        c.sticks = dot3(c.slip, c.slip) * c.grip * c.grip <= c.friction_limit * c.friction_limit;
      }
      c.active = memory.pushing || gap < 0;
    }
  }
}

void keep_multipliers(const Pose& tool, ContactState& contacts) noexcept {
  for (int i = 0; i < contacts.count; ++i) {
    const ContactConstraint& c = contacts.constraints[i];
    if (c.memory < 0) continue;
    SphereContact& memory = contacts.memory[c.memory];
    memory.multiplier += kCarriedShare * (c.multiplier - memory.multiplier) - kLeak * memory.multiplier;
    memory.pushing = c.multiplier > 0;
    memory.force = c.multiplier;
    if (c.grip > 0)  // what the friction that came about holds of the slip
      memory.slip = tool.rotation.conjugate() * (to_vec3(c.friction) / -double(c.grip));
  }
}

}  // namespace vallecula::engine
