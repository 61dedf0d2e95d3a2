#include "engine/tissue/implicit_step.h"

#include <algorithm>
#include <cmath>

#include "engine/tissue/coarse_space.h"
#include "engine/tissue/elasticity.h"
#include "engine/tissue/linear_solver.h"

namespace vallecula::engine {

namespace {

constexpr int kMostIterations = 8;       // of conjugate gradients; little moves in a tick, and each starts warm
constexpr double kTolerance = 1e-3;      // residual over the elastic forces at which the solver may stop early
constexpr double kLeastForce = 1e-4;     // N; scale of the tolerance in tissue at rest
constexpr double kFastest = 1.5;         // m/s; no tissue moves faster: what does is a body crushed beyond its law, braked here
constexpr int kLeastIterations = 3;      // once the contacts have changed: a force read off an unfinished system is a spike
constexpr double kUnknownForce = 0.01;   // N; contacts that change by less need no new solution
constexpr int kActivePasses = 3;         // the contacts that push are chosen anew at most this often in a tick
constexpr int kCoarseRefreshSteps = 8;
constexpr int kRefreshVisits = 4;        // a quarter of the packs is looked at in a tick,
constexpr int kRefreshShare = 64;        // and one tetrahedron in 64 gets new stiffness blocks at most

using Motion = SprungBody::Motion;

/// A contact is active if it pushes after the present increment. Returns the force of those for which that changed, N: what
/// the system just solved did not know of.
double choose_active(const TissueState& state, ContactConstraint* contacts, int contact_count) {
  double unknown = 0.0;
  for (int c = 0; c < contact_count; ++c) {
    ContactConstraint& contact = contacts[c];
    const float force = contact.multiplier - contact.stiffness * gap_after(contact, state.solution.data());
    if ((force > 0) != contact.active) unknown += std::abs(force);
    contact.active = force > 0;
  }
  return unknown;
}

/// The friction that came about (Coulomb): the sticking spring's at the new slip, no more than its limit allows.
void settle_friction(const TissueState& state, ContactConstraint& contact) {
  F4 way = splat(0.0f);
  for (int k = 0; k < 4; ++k) way += splat(contact.weight[k]) * state.solution[contact.node[k]].v;
  way -= splat(dot3(contact.normal, way)) * contact.normal;
  const F4 slip = contact.slip + way;
  const float size = std::sqrt(dot3(slip, slip));
  contact.friction = contact.active ? held_friction(contact, slip, size * contact.grip <= contact.friction_limit)
                                    : splat(0.0f);
}

}  // namespace

void follow_bodies(const TissueModel& model, TissueState& state) noexcept {
  for (const auto& a : model.anchored) {
    const Vec3& q = state.body_displacement[a.body];
    switch (model.bodies[a.body].motion) {
      case Motion::translation: state.displacement[a.node] = q; break;
      case Motion::hinge: state.displacement[a.node] = q[0] * to_vec3(a.arm); break;
      case Motion::fixed: break;
    }
  }
}

StepStatistics implicit_step(const TissueModel& model, TissueState& state, ContactConstraint* contacts,
                             int contact_count, StageTimes& times) noexcept {
  const double h = model.step_s;
  StageClock clock;
  elastic_forces(model, state);
  refresh_stiffness(model, state, static_cast<int>(model.packs.size()) / kRefreshVisits + 1,
                    std::max(32, model.tets / kRefreshShare));
  clock.add_to(times.elasticity_s);

  double elastic_squared = 0.0;
  for (std::int32_t i : model.moving) {
    const F4 f = state.force[i].v + state.external[i].v;
    state.rhs[i].v = f + splat(static_cast<float>(model.mass[i] / h)) * from_vec3(state.velocity[i]);
    elastic_squared += dot3(f, f);
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const SprungBody& body = model.bodies[b];
    const Vec3 own = body.motion == Motion::fixed
                         ? Vec3::Zero().eval()
                         : (body.inertia / h * state.body_velocity[b] - body.stiffness * state.body_displacement[b] +
                            state.body_load[b]).eval();
    state.rhs[model.nodes + b].v = from_vec3(own);
  }

  std::fill(state.external.begin(), state.external.end(), Float4{});

  if (state.steps % kCoarseRefreshSteps == 0)
    refresh_coarse(model, state, (1.0f + TissueModel::kMassDamping * static_cast<float>(h)) / static_cast<float>(h * h),
                   1.0f + TissueModel::kStiffnessDamping / static_cast<float>(h));
  ++state.steps;

  StepStatistics statistics;
  // The last increment is the first guess: the hand goes on much as it did a millisecond ago.
  build_preconditioner(model, state, contacts, contact_count);
  factor_coarse(model, state, contacts, contact_count);
  const double enough = kTolerance * std::max(kLeastForce, std::sqrt(elastic_squared));
  // Contacts that turn out to pull are let go, those that turn out to be inside are taken in, and the solver goes on from
  // where it is. Judged once a tick only, a contact may close and open in turns for ever.
  for (int pass = 0; pass < kActivePasses; ++pass) {
    const int left = kMostIterations - statistics.iterations;
    const SolveResult solved = solve(model, state, contacts, contact_count, enough,
                                     pass == 0 ? left : std::max(left, kLeastIterations));
    statistics.iterations += solved.iterations;
    statistics.residual_n = solved.residual_n;
    if (choose_active(state, contacts, contact_count) < kUnknownForce) break;
  }
  for (int c = 0; c < contact_count; ++c) {
    ContactConstraint& contact = contacts[c];
    contact.multiplier = std::max(0.0f, contact.multiplier - contact.stiffness * gap_after(contact, state.solution.data()));
    contact.active = contact.multiplier > 0;
    if (contact.grip > 0) settle_friction(state, contact);
  }

  float fastest_squared = 0.0f;
  const float most_squared = static_cast<float>(kFastest * h * kFastest * h);
  for (std::int32_t i : model.moving) {
    F4& way = state.solution[i].v;
    float squared = dot3(way, way);
    if (squared > most_squared) {
      way *= splat(std::sqrt(most_squared / squared));
      squared = most_squared;
    }
    fastest_squared = std::max(fastest_squared, squared);
    if (model.anchor[i] >= 0) continue;
    const Vec3 du = to_vec3(state.solution[i].v);
    state.displacement[i] += du;
    state.velocity[i] = du / h;
  }
  state.fastest_m = std::sqrt(double(fastest_squared));
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Vec3 dq = to_vec3(state.solution[model.nodes + b].v);
    state.body_displacement[b] += dq;
    state.body_velocity[b] = dq / h;
  }
  follow_bodies(model, state);
  clock.add_to(times.solve_s);
  return statistics;
}

}  // namespace vallecula::engine
