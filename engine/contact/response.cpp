#include "engine/contact/response.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

constexpr int kMaxIterations = 10;        // Algorithm 1, MaxIterationNumber
// Of a pressed distance's violation, what an iteration takes back. At a press of 1.5 mm half of it turned a thousand tetrahedra
// inside out, a tenth fewer than ten.
constexpr double kDistanceShare = 0.1;
constexpr double kDistanceSlack = 1e-6;   // of the distance: what single precision makes of tissue that is only turned
constexpr float kPenaltyShare = 0.01f;    // of the augmented Lagrangian's stiffness: an explicit penalty spring above it diverges at h = 1 ms

/// A point that corrections move by the nodes that carry it: a sphere's centre, or what triangles found of the surface.
struct CarriedPoint {
  const std::int32_t* node;
  const float* weight;
  int count;
};

CarriedPoint carried_centre(const SphereTree& tree, const InnerSphere& sphere) {
  return {tree.tied_nodes.data() + sphere.first_tied, tree.tied_weights.data() + sphere.first_tied, sphere.tied_count};
}

/// How far the point has come in this tick: the solution holds the free step's increments, external the corrections so far.
Vec3 way_of(const TissueState& tissue, const CarriedPoint& point) {
  Vec3 way = Vec3::Zero();
  for (int k = 0; k < point.count; ++k)
    way += point.weight[k] * to_vec3(tissue.solution[point.node[k]].v + tissue.external[point.node[k]].v);
  return way;
}

/// How far an impulse of 1 N s a second brings the point, 1/kg.
double mobility(const TissueModel& model, const CarriedPoint& point) {
  double sum = 0.0;
  for (int k = 0; k < point.count; ++k)
    sum += double(point.weight[k]) * point.weight[k] / model.mass[point.node[k]];
  return sum;
}

/// Moves the nodes as the mass times way `push` (kg m) at the point does. Anchored ones stay; what they do not do is left to
/// the next iteration: laid upon a node that hardly carries the point, it would throw that far out.
void correct(const TissueModel& model, TissueState& tissue, const CarriedPoint& point, const Vec3& push) {
  for (int k = 0; k < point.count; ++k) {
    const int node = point.node[k];
    if (model.anchor[node] < 0) tissue.external[node].v += from_vec3(point.weight[k] / model.mass[node] * push);
  }
}

/// Spheres that are pressed together are pushed apart (paper 3.1), by mass: no momentum is made.
void hold_distances(const SphereTree& tree, const TissueModel& model, TissueState& tissue) {
  const auto place = [&](const CarriedPoint& point) {
    Vec3 centre = Vec3::Zero();
    for (int k = 0; k < point.count; ++k) {
      const int node = point.node[k];
      centre += point.weight[k] * (model.rest[node] + tissue.displacement[node] + to_vec3(tissue.external[node].v));
    }
    return centre;
  };
  for (const SphereDistance& d : tree.distances) {
    const CarriedPoint a = carried_centre(tree, tree.spheres[d.a]), b = carried_centre(tree, tree.spheres[d.b]);
    const Vec3 between = place(b) - place(a);
    const double distance = between.norm(), pressed = d.rest - distance;
    if (!(pressed > kDistanceSlack * d.rest) || !(distance > 0)) continue;
    // Nodes that both hang on make this a little less than its share.
    const Vec3 push = kDistanceShare * pressed / (mobility(model, a) + mobility(model, b)) / distance * between;
    correct(model, tissue, a, -push);
    correct(model, tissue, b, push);
  }
}

/// The tube's contacts are always part of the implicit step, whatever the tool's response.
ContactConstraint* tube_contacts(ContactState& contacts) { return contacts.constraints.data() + contacts.count; }

/// The paper to the letter: free step, then each colliding sphere's centre is projected out along its normal and the
/// correction goes to the vertices of its tetrahedra; the velocity is taken from the corrected positions. Its force
/// reading is M dp / h^2, which depends on the step (DESIGN 4.3): shown, never scored.
StepStatistics projection(bool sphere_distances, const SphereTree& tree, const TissueModel& model, TissueState& tissue,
                          ContactState& contacts, StageTimes& times) {
  const StepStatistics statistics = implicit_step(model, tissue, tube_contacts(contacts), contacts.of_tube, times);
  StageClock clock;
  const double h = model.step_s;
  for (int c = 0; c < contacts.count; ++c) contacts.constraints[c].multiplier = 0.0f;
  for (int i = 0; i < kMaxIterations && contacts.count > 0; ++i) {
    for (int c = 0; c < contacts.count; ++c) {
      ContactConstraint& contact = contacts.constraints[c];
      const CarriedPoint point = contacts.of_spheres ? carried_centre(tree, tree.spheres[contact.memory])
                                                     : CarriedPoint{contact.node, contact.weight, 4};
      const Vec3 n = to_vec3(contact.normal);
      // (c' - q) . n - (r + g): the gap at the tick's start plus the way since of what is corrected.
      const double gap = contact.gap + n.dot(way_of(tissue, point));
      if (gap >= 0) continue;
      const double push = -gap / mobility(model, point);
      correct(model, tissue, point, push * n);
      contact.multiplier += static_cast<float>(push / (h * h));
    }
    if (sphere_distances) hold_distances(tree, model, tissue);
  }
  for (int i = 0; i < model.nodes; ++i) {
    const Vec3 correction = to_vec3(tissue.external[i].v);
    tissue.displacement[i] += correction;
    tissue.velocity[i] += correction / h;
    tissue.fastest_m = std::max(tissue.fastest_m, correction.norm() + h * tissue.velocity[i].norm());
  }
  std::fill(tissue.external.begin(), tissue.external.end(), Float4{});
  clock.add_to(times.response_s);
  return statistics;
}

/// The baseline of the paper's Figure 7(a): springs on the penetration depth, applied explicitly.
StepStatistics penalty(const TissueModel& model, TissueState& tissue, ContactState& contacts, StageTimes& times) {
  StageClock clock;
  for (int c = 0; c < contacts.count; ++c) {
    ContactConstraint& contact = contacts.constraints[c];
    contact.multiplier = std::max(0.0f, -contact.gap * contact.stiffness * kPenaltyShare);
    for (int k = 0; k < 4; ++k)
      tissue.external[contact.node[k]].v += splat(contact.multiplier * contact.weight[k]) * contact.normal;
  }
  clock.add_to(times.response_s);
  return implicit_step(model, tissue, tube_contacts(contacts), contacts.of_tube, times);
}

}  // namespace

StepStatistics respond(Response response, bool sphere_distances, const SphereTree& tree, const TissueModel& model,
                       const Pose& tool, TissueState& tissue, ContactState& contacts, StageTimes& times) noexcept {
  StepStatistics statistics;
  switch (response) {
    case Response::compliant:
      statistics = implicit_step(model, tissue, contacts.constraints.data(), contacts.count + contacts.of_tube, times);
      break;
    case Response::projection:
      statistics = projection(sphere_distances, tree, model, tissue, contacts, times);
      break;
    case Response::penalty: statistics = penalty(model, tissue, contacts, times); break;
  }
  keep_multipliers(tool, contacts);
  return statistics;
}

float contact_stiffness_per_area(const TissueModel& model, const SoftSurface& surface) {
  const double h = model.step_s;
  double area = 0.0;
  std::vector<char> on_surface(model.nodes, 0);
  for (const auto& t : surface.triangles) {
    area += (model.rest[t[1]] - model.rest[t[0]]).cross(model.rest[t[2]] - model.rest[t[0]]).norm() / 2;
    for (int v : t) on_surface[v] = 1;
  }
  // A node's own stiffness: its inertia over a step and the shear part of its elastic diagonal. The volumetric part is
  // left out: nearly incompressible tissue gives way sideways, however stiff its volume is.
  double stiffness = 0.0;
  for (int i = 0; i < model.nodes; ++i) stiffness += on_surface[i] ? model.mass[i] / (h * h) : 0.0;
  for (const TetPack& pack : model.packs)
    for (int c = 0; c < 4; ++c)
      for (int lane = 0; lane < kLanes; ++lane) {
        if (!on_surface[pack.node[c][lane]]) continue;
        double squared = 0.0;
        for (int a = 0; a < 3; ++a) squared += double(pack.gradient[c][a][lane]) * pack.gradient[c][a][lane];
        stiffness += 4.0 / 3.0 * pack.volume[lane] * pack.mu[lane] * squared;
      }
  return static_cast<float>(kContactAugmentation * stiffness / area);
}

}  // namespace vallecula::engine
