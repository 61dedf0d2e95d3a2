#include "engine/tissue/implicit_step.h"

#include <algorithm>
#include <cmath>

#include "engine/tissue/coarse_space.h"
#include "engine/tissue/elasticity.h"

namespace vallecula::engine {

namespace {

constexpr int kContactPasses = 1;       // the active set is judged anew before each; one a tick suffices at h = 1 ms
constexpr int kIterationsPerPass = 10;   // of conjugate gradients; little moves in a tick, and each starts warm
constexpr float kTolerance = 1e-4f;      // relative residual at which a pass may stop early
constexpr int kCoarseRefreshSteps = 8;
constexpr int kRefreshShare = 8;         // at most one tetrahedron in 8 gets new stiffness blocks a tick

using Motion = SprungBody::Motion;

/// Writes the anchored nodes' entries of x from the bodies' unknowns (behind the nodes).
void expand(const TissueModel& model, Float4* x) {
  for (const auto& a : model.anchored) {
    const F4 q = x[model.nodes + a.body].v;
    switch (model.bodies[a.body].motion) {
      case Motion::translation: x[a.node].v = q; break;
      case Motion::hinge: x[a.node].v = splat(q[0]) * a.arm; break;
      case Motion::fixed: x[a.node].v = splat(0.0f); break;
    }
  }
}

/// The transpose: adds the anchored nodes' entries of y to the bodies' and clears them.
void reduce(const TissueModel& model, Float4* y) {
  for (const auto& a : model.anchored) {
    const F4 f = y[a.node].v;
    switch (model.bodies[a.body].motion) {
      case Motion::translation: y[model.nodes + a.body].v += f; break;
      case Motion::hinge: y[model.nodes + a.body].v[0] += dot3(f, a.arm); break;
      case Motion::fixed: break;
    }
    y[a.node].v = splat(0.0f);
  }
}

/// A body's own share of the system matrix: inertia/h^2 + damping/h + stiffness.
float body_matrix(const TissueModel& model, int b) {
  const SprungBody& body = model.bodies[b];
  if (body.motion == Motion::fixed) return 1.0f;
  const double h = model.step_s;
  return static_cast<float>(body.inertia / (h * h) + body.damping / h + body.stiffness);
}

void multiply(const TissueModel& model, const TissueState& state, const ContactConstraint* contacts, int contact_count,
              Float4* x, Float4* y) {
  const float h = static_cast<float>(model.step_s);
  const float mass_scale = (1.0f + TissueModel::kMassDamping * h) / (h * h);
  const F4 stiffness_scale = splat(1.0f + TissueModel::kStiffnessDamping / h);
  expand(model, x);
  const Block3* blocks = state.stiffness.data();
  const std::int32_t* column = model.column.data();
  for (int i = 0; i < model.nodes; ++i) {
    F4 sum = {0, 0, 0, 0};
    for (std::int32_t b = model.row_start[i]; b < model.row_start[i + 1]; ++b) {
      const F4 xj = x[column[b]].v;
      const Block3& block = blocks[b];
      sum += block.column[0] * __builtin_shuffle(xj, I4{0, 0, 0, 0}) +
             block.column[1] * __builtin_shuffle(xj, I4{1, 1, 1, 1}) +
             block.column[2] * __builtin_shuffle(xj, I4{2, 2, 2, 2});
    }
    y[i].v = sum * stiffness_scale + splat(mass_scale * model.mass[i]) * x[i].v;
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    y[model.nodes + b].v = splat(body_matrix(model, static_cast<int>(b))) * x[model.nodes + b].v;
  for (int c = 0; c < contact_count; ++c) {
    const ContactConstraint& contact = contacts[c];
    if (!contact.active) continue;
    float along = 0.0f;
    for (int k = 0; k < 4; ++k) along += contact.weight[k] * dot3(contact.normal, x[contact.node[k]].v);
    along *= contact.stiffness;
    for (int k = 0; k < 4; ++k) y[contact.node[k]].v += splat(along * contact.weight[k]) * contact.normal;
  }
  reduce(model, y);
}

Block3 inverse(const Block3& m) {
  const Vec3 a = to_vec3(m.column[0]), b = to_vec3(m.column[1]), c = to_vec3(m.column[2]);
  const Vec3 r0 = b.cross(c), r1 = c.cross(a), r2 = a.cross(b);
  const double determinant = a.dot(r0);
  Block3 out;
  const double s = determinant > 0 ? 1.0 / determinant : 0.0;
  for (int k = 0; k < 3; ++k) out.column[k] = from_vec3(Vec3(r0[k], r1[k], r2[k]) * s);
  return out;
}

/// Inverse of the system's diagonal blocks (block Jacobi preconditioner). Bodies take the sum over their nodes' own
/// blocks: an overestimate of their diagonal, which only costs iterations.
void build_preconditioner(const TissueModel& model, TissueState& state, const ContactConstraint* contacts,
                          int contact_count) {
  const float h = static_cast<float>(model.step_s);
  const float mass_scale = (1.0f + TissueModel::kMassDamping * h) / (h * h);
  const F4 stiffness_scale = splat(1.0f + TissueModel::kStiffnessDamping / h);
  Block3* d = state.inverse_diagonal.data();
  for (int i = 0; i < model.nodes; ++i) {
    const Block3& k = state.stiffness[model.diagonal[i]];
    for (int a = 0; a < 3; ++a) {
      d[i].column[a] = k.column[a] * stiffness_scale;
      d[i].column[a][a] += mass_scale * model.mass[i];
    }
  }
  for (int c = 0; c < contact_count; ++c) {
    const ContactConstraint& contact = contacts[c];
    if (!contact.active) continue;
    for (int k = 0; k < 4; ++k) {
      const float s = contact.stiffness * contact.weight[k] * contact.weight[k];
      for (int a = 0; a < 3; ++a) d[contact.node[k]].column[a] += splat(s * contact.normal[a]) * contact.normal;
    }
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    Block3& own = d[model.nodes + b];
    own = Block3{};
    for (int a = 0; a < 3; ++a) own.column[a][a] = body_matrix(model, static_cast<int>(b));
  }
  for (const auto& a : model.anchored) {
    Block3& own = d[model.nodes + a.body];
    const Block3& node = d[a.node];
    if (model.bodies[a.body].motion == Motion::translation) {
      for (int k = 0; k < 3; ++k) own.column[k] += node.column[k];
    } else if (model.bodies[a.body].motion == Motion::hinge) {
      F4 product = splat(0.0f);
      for (int k = 0; k < 3; ++k) product += node.column[k] * splat(a.arm[k]);
      own.column[0][0] += dot3(product, a.arm);
    }
  }
  for (int i = 0; i < model.nodes; ++i) d[i] = inverse(d[i]);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    Block3& own = d[model.nodes + b];
    if (model.bodies[b].motion == Motion::translation) {
      own = inverse(own);
    } else {
      const float s = model.bodies[b].motion == Motion::hinge ? 1.0f / own.column[0][0] : 0.0f;
      own = Block3{};
      own.column[0][0] = s;  // a hinge has one unknown, a fixed body none
    }
  }
}

double dot(const std::vector<Float4>& a, const std::vector<Float4>& b) {
  double sum = 0.0;  // in double: the tolerance is judged on it
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot3(a[i].v, b[i].v);
  return sum;
}

void precondition(const TissueModel& model, TissueState& state, const std::vector<Float4>& r, std::vector<Float4>& z) {
  for (std::size_t i = 0; i < r.size(); ++i) {
    const F4 v = r[i].v;
    const Block3& d = state.inverse_diagonal[i];
    z[i].v = d.column[0] * splat(v[0]) + d.column[1] * splat(v[1]) + d.column[2] * splat(v[2]);
  }
  add_coarse_correction(model, state, r, z);
}

float gap_after(const ContactConstraint& contact, const Float4* du) {
  float along = 0.0f;
  for (int k = 0; k < 4; ++k) along += contact.weight[k] * dot3(contact.normal, du[contact.node[k]].v);
  return contact.gap + along;
}

/// Preconditioned conjugate gradients from state.solution; returns the iterations used.
int solve(const TissueModel& model, TissueState& state, const ContactConstraint* contacts, int contact_count,
          float* relative_residual) {
  auto& x = state.solution;
  auto& r = state.residual;
  auto& p = state.direction;
  auto& z = state.preconditioned;
  auto& q = state.product;
  multiply(model, state, contacts, contact_count, x.data(), q.data());
  r = state.rhs;
  for (int c = 0; c < contact_count; ++c) {
    const ContactConstraint& contact = contacts[c];
    if (!contact.active) continue;
    const float force = contact.multiplier - contact.stiffness * contact.gap;
    for (int k = 0; k < 4; ++k) r[contact.node[k]].v += splat(force * contact.weight[k]) * contact.normal;
  }
  reduce(model, r.data());
  double scale = 0.0;
  for (std::size_t i = 0; i < r.size(); ++i) scale += dot3(r[i].v, r[i].v);
  for (std::size_t i = 0; i < r.size(); ++i) r[i].v -= q[i].v;
  precondition(model, state, r, z);
  p = z;
  double rz = dot(r, z);
  int iteration = 0;
  double squared = dot(r, r);
  const double enough = double(kTolerance) * kTolerance * scale;
  while (iteration < kIterationsPerPass && squared > enough && rz > 0) {
    multiply(model, state, contacts, contact_count, p.data(), q.data());
    const double curvature = dot(p, q);
    if (!(curvature > 0)) break;
    const F4 alpha = splat(static_cast<float>(rz / curvature));
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i].v += alpha * p[i].v;
      r[i].v -= alpha * q[i].v;
    }
    precondition(model, state, r, z);
    const double next = dot(r, z);
    const F4 beta = splat(static_cast<float>(next / rz));
    for (std::size_t i = 0; i < p.size(); ++i) p[i].v = z[i].v + beta * p[i].v;
    rz = next;
    squared = dot(r, r);
    ++iteration;
  }
  expand(model, x.data());
  *relative_residual = scale > 0 ? static_cast<float>(std::sqrt(squared / scale)) : 0.0f;
  return iteration;
}

}  // namespace

void follow_bodies(const TissueModel& model, TissueState& state) noexcept {
  for (const auto& a : model.anchored) {
    const Vec3& q = state.body_displacement[a.body];
    switch (model.bodies[a.body].motion) {
      case Motion::translation: state.displacement[a.node] = q; break;
      case Motion::hinge: state.displacement[a.node] = q[0] * to_vec3(a.arm); break;
      case Motion::fixed: state.displacement[a.node].setZero(); break;
    }
  }
}

StepStatistics implicit_step(const TissueModel& model, TissueState& state, ContactConstraint* contacts,
                             int contact_count, StageTimes& times) noexcept {
  const double h = model.step_s;
  StageClock clock;
  elastic_forces(model, state);
  refresh_stiffness(model, state, std::max(64, model.tets / kRefreshShare));
  clock.add_to(times.elasticity_s);

  for (int i = 0; i < model.nodes; ++i)
    state.rhs[i].v = state.force[i].v + state.external[i].v +
                     splat(static_cast<float>(model.mass[i] / h)) * from_vec3(state.velocity[i]);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const SprungBody& body = model.bodies[b];
    const Vec3 own = body.motion == Motion::fixed
                         ? Vec3::Zero().eval()
                         : (body.inertia / h * state.body_velocity[b] - body.stiffness * state.body_displacement[b]).eval();
    state.rhs[model.nodes + b].v = from_vec3(own);
  }

  std::fill(state.external.begin(), state.external.end(), Float4{});

  if (state.steps % kCoarseRefreshSteps == 0)
    refresh_coarse(model, state, (1.0f + TissueModel::kMassDamping * static_cast<float>(h)) / static_cast<float>(h * h),
                   1.0f + TissueModel::kStiffnessDamping / static_cast<float>(h));
  ++state.steps;

  StepStatistics statistics;
  // The last increment is the first guess: the hand goes on much as it did a millisecond ago.
  for (int pass = 0; pass < (contact_count > 0 ? kContactPasses : 1); ++pass) {
    for (int c = 0; c < contact_count; ++c)
      contacts[c].active = contacts[c].multiplier - contacts[c].stiffness * gap_after(contacts[c], state.solution.data()) > 0;
    build_preconditioner(model, state, contacts, contact_count);
    factor_coarse(model, state, contacts, contact_count);
    statistics.iterations += solve(model, state, contacts, contact_count, &statistics.relative_residual);
  }
  for (int c = 0; c < contact_count; ++c) {
    ContactConstraint& contact = contacts[c];
    contact.multiplier = std::max(0.0f, contact.multiplier - contact.stiffness * gap_after(contact, state.solution.data()));
    contact.active = contact.multiplier > 0;
  }

  for (int i = 0; i < model.nodes; ++i) {
    if (model.anchor[i] >= 0) continue;
    const Vec3 du = to_vec3(state.solution[i].v);
    state.displacement[i] += du;
    state.velocity[i] = du / h;
  }
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
