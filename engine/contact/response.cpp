#include "engine/contact/response.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

constexpr int kMaxIterations = 10;        // Algorithm 1, MaxIterationNumber
constexpr float kPenaltyShare = 0.01f;    // of the augmented Lagrangian's stiffness: an explicit penalty spring above it diverges at h = 1 ms

/// The paper to the letter: free step, then each colliding sphere's centre is projected out along its normal and the
/// correction goes to the vertices of its tetrahedron; the velocity is taken from the corrected positions. Its force
/// reading is M dp / h^2, which depends on the step (DESIGN 4.3): shown, never scored.
StepStatistics projection(const SphereTree& tree, const std::vector<std::array<int, 4>>& tets, const TissueModel& model,
                          TissueState& tissue, ContactState& contacts, StageTimes& times) {
  const StepStatistics statistics = implicit_step(model, tissue, nullptr, 0, times);
  StageClock clock;
  const double h = model.step_s;
  for (int c = 0; c < contacts.count; ++c) contacts.constraints[c].multiplier = 0.0f;
  for (int i = 0; i < kMaxIterations; ++i)
    for (int c = 0; c < contacts.count; ++c) {
      ContactConstraint& contact = contacts.constraints[c];
      // Of a sphere the vertices of its tetrahedron are corrected, of a point found by triangles those it hangs on.
      const InnerSphere* sphere = contacts.of_spheres ? &tree.spheres[contact.memory] : nullptr;
      const auto node = [&](int k) { return sphere ? tets[sphere->tet][k] : contact.node[k]; };
      const auto weight = [&](int k) { return sphere ? sphere->weight[k] : double(contact.weight[k]); };
      const Vec3 n = to_vec3(contact.normal);
      // The gap at the tick's start plus the surface point's way since: solution holds the free step's increments,
      // external the corrections so far.
      double gap = contact.gap;
      for (int k = 0; k < 4; ++k)
        gap += contact.weight[k] * n.dot(to_vec3(tissue.solution[contact.node[k]].v + tissue.external[contact.node[k]].v));
      if (gap >= 0) continue;
      double squares = 0.0;
      for (int k = 0; k < 4; ++k) squares += weight(k) * weight(k);
      for (int k = 0; k < 4; ++k) {
        if (weight(k) == 0 || model.anchor[node(k)] >= 0) continue;
        const Vec3 move = -gap * weight(k) / squares * n;
        tissue.external[node(k)].v += from_vec3(move);
        contact.multiplier += static_cast<float>(model.mass[node(k)] * move.dot(n) / (h * h));
      }
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
  return implicit_step(model, tissue, nullptr, 0, times);
}

}  // namespace

StepStatistics respond(Response response, const SphereTree& tree, const std::vector<std::array<int, 4>>& tets,
                       const TissueModel& model, const Pose& tool, TissueState& tissue, ContactState& contacts,
                       StageTimes& times) noexcept {
  StepStatistics statistics;
  switch (response) {
    case Response::compliant:
      statistics = implicit_step(model, tissue, contacts.constraints.data(), contacts.count, times);
      break;
    case Response::projection: statistics = projection(tree, tets, model, tissue, contacts, times); break;
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
