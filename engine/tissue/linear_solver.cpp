#include "engine/tissue/linear_solver.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/tissue/coarse_space.h"

namespace vallecula::engine {

namespace {

using Motion = SprungBody::Motion;

struct Scales {
  explicit Scales(double step_s)
      : mass((1.0f + TissueModel::kMassDamping * static_cast<float>(step_s)) / static_cast<float>(step_s * step_s)),
        stiffness(1.0f + TissueModel::kStiffnessDamping / static_cast<float>(step_s)) {}
  float mass, stiffness;
};

/// Writes the anchored nodes' entries of x from the bodies' unknowns (behind the nodes).
void expand(const TissueModel& model, Float4* x) {
  for (const auto& a : model.anchored) {
    const F4 q = x[model.nodes + a.body].v;
    x[a.node].v = model.bodies[a.body].motion == Motion::translation ? q : splat(q[0]) * a.arm;
  }
}

/// The transpose: adds the anchored nodes' entries of y to the bodies' and clears them, and those of fixed nodes.
void reduce(const TissueModel& model, Float4* y) {
  for (const auto& a : model.anchored) {
    const F4 f = y[a.node].v;
    if (model.bodies[a.body].motion == Motion::translation) {
      y[model.nodes + a.body].v += f;
    } else {
      y[model.nodes + a.body].v[0] += dot3(f, a.arm);
    }
    y[a.node].v = splat(0.0f);
  }
  for (std::int32_t i : model.fixed_nodes) y[i].v = splat(0.0f);
}

/// A body's own share of the system matrix: inertia/h^2 + damping/h + stiffness, and that of what it is jammed against.
float body_matrix(const TissueModel& model, const TissueState& state, std::size_t b) {
  const SprungBody& body = model.bodies[b];
  if (body.motion == Motion::fixed) return 1.0f;
  const double h = model.step_s;
  return static_cast<float>(body.inertia / (h * h) + body.damping / h + body.stiffness + state.body_load_stiffness[b]);
}

VALLECULA_INLINE F8 load8(const Float4* from) {
  F8 v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
VALLECULA_INLINE void store8(Float4* to, F8 v) { std::memcpy(static_cast<void*>(to), &v, sizeof v); }

/// y = (mass_scale M + stiffness_scale K) x over the nodes with a row.
VALLECULA_KERNEL void multiply_nodes(const TissueModel& model, const BlockPair* blocks, float mass_scale,
                                     float stiffness_scale, const Float4* x, Float4* y) {
  const std::int32_t* column = model.column.data();
  const std::int32_t* row_start = model.row_start.data();
  const float* mass = model.mass.data();
  const F4 scale = splat(stiffness_scale);
  for (std::int32_t i : model.moving) {
    F8 sum = splat8(0.0f);
    for (std::int32_t b = row_start[i]; b < row_start[i + 1]; b += 2) {
      const F8 xj = join(x[column[b]].v, x[column[b + 1]].v);
      const BlockPair& pair = blocks[b / 2];
      sum += pair.column[0] * __builtin_shuffle(xj, I8{0, 0, 0, 0, 4, 4, 4, 4}) +
             pair.column[1] * __builtin_shuffle(xj, I8{1, 1, 1, 1, 5, 5, 5, 5}) +
             pair.column[2] * __builtin_shuffle(xj, I8{2, 2, 2, 2, 6, 6, 6, 6});
    }
    y[i].v = (low_half(sum) + high_half(sum)) * scale + splat(mass_scale * mass[i]) * x[i].v;
  }
}

void multiply(const TissueModel& model, const TissueState& state, const ContactConstraint* contacts, int contact_count,
              Float4* x, Float4* y) {
  const Scales scales(model.step_s);
  expand(model, x);
  multiply_nodes(model, state.stiffness.data(), scales.mass, scales.stiffness, x, y);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    y[model.nodes + b].v = splat(body_matrix(model, state, b)) * x[model.nodes + b].v;
  for (int c = 0; c < contact_count; ++c) {
    const ContactConstraint& contact = contacts[c];
    if (!contact.active) continue;
    F4 way = splat(0.0f);
    for (int k = 0; k < 4; ++k) way += splat(contact.weight[k]) * x[contact.node[k]].v;
    const float along = dot3(contact.normal, way);
    F4 force = splat(contact.stiffness * along) * contact.normal;
    if (contact.grip > 0 && contact.sticks) force += splat(contact.grip) * (way - splat(along) * contact.normal);
    for (int k = 0; k < 4; ++k) y[contact.node[k]].v += splat(contact.weight[k]) * force;
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

VALLECULA_KERNEL double dot(const Float4* a, const Float4* b, std::size_t size) {
  F8 sum[2] = {splat8(0.0f), splat8(0.0f)};
  std::size_t i = 0;
  for (; i + 4 <= size; i += 4) {
    sum[0] += load8(a + i) * load8(b + i);
    sum[1] += load8(a + i + 2) * load8(b + i + 2);
  }
  for (; i < size; i += 2) sum[0] += load8(a + i) * load8(b + i);
  const F8 all = sum[0] + sum[1];
  double total = 0.0;
  for (int k = 0; k < kLanes; ++k) total += all[k];
  return total;
}

/// x += alpha p, r -= alpha q, and the square of the new r.
VALLECULA_KERNEL double advance(Float4* x, Float4* r, const Float4* p, const Float4* q, float alpha, std::size_t size) {
  const F8 a = splat8(alpha);
  F8 sum = splat8(0.0f);
  for (std::size_t i = 0; i < size; i += 2) {
    store8(x + i, load8(x + i) + a * load8(p + i));
    const F8 rest = load8(r + i) - a * load8(q + i);
    store8(r + i, rest);
    sum += rest * rest;
  }
  double total = 0.0;
  for (int k = 0; k < kLanes; ++k) total += sum[k];
  return total;
}

VALLECULA_KERNEL void combine(Float4* p, const Float4* z, float beta, std::size_t size) {
  const F8 b = splat8(beta);
  for (std::size_t i = 0; i < size; i += 2) store8(p + i, load8(z + i) + b * load8(p + i));
}

VALLECULA_KERNEL void apply_blocks(const Block3* d, const Float4* r, Float4* z, std::size_t size) {
  for (std::size_t i = 0; i < size; i += 2) {
    const F8 v = load8(r + i);
    store8(z + i, join(d[i].column[0], d[i + 1].column[0]) * __builtin_shuffle(v, I8{0, 0, 0, 0, 4, 4, 4, 4}) +
                      join(d[i].column[1], d[i + 1].column[1]) * __builtin_shuffle(v, I8{1, 1, 1, 1, 5, 5, 5, 5}) +
                      join(d[i].column[2], d[i + 1].column[2]) * __builtin_shuffle(v, I8{2, 2, 2, 2, 6, 6, 6, 6}));
  }
}

void precondition(const TissueModel& model, TissueState& state) {
  apply_blocks(state.inverse_diagonal.data(), state.residual.data(), state.preconditioned.data(),
               state.residual.size());
  add_coarse_correction(model, state, state.residual, state.preconditioned);
}

/// A node's diagonal block without contacts.
Block3 diagonal_block(const TissueModel& model, const TissueState& state, const Scales& scales, int i) {
  Block3 d = state.stiffness_block(model.diagonal[i]);
  for (int a = 0; a < 3; ++a) {
    d.column[a] *= splat(scales.stiffness);
    d.column[a][a] += scales.mass * model.mass[i];
  }
  return d;
}

}  // namespace

void build_preconditioner(const TissueModel& model, TissueState& state, const ContactConstraint* contacts,
                          int contact_count) noexcept {
  const Scales scales(model.step_s);
  for (std::int32_t n = 0; n < state.contact_node_count; ++n) state.stale[state.contact_nodes[n]] = 1;
  state.contact_node_count = 0;
  for (int c = 0; c < contact_count; ++c) {
    const ContactConstraint& contact = contacts[c];
    if (!contact.active) continue;
    for (int k = 0; k < 4; ++k) {
      const std::int32_t i = contact.node[k];
      if (contact.weight[k] == 0.0f || model.diagonal[i] < 0) continue;
      if (!state.in_contact[i]) {
        state.in_contact[i] = 1;
        state.contact_nodes[state.contact_node_count++] = i;
        state.contact_diagonal[i] = diagonal_block(model, state, scales, i);
      }
      const float s = contact.stiffness * contact.weight[k] * contact.weight[k];
      const float grip = contact.sticks ? contact.grip * contact.weight[k] * contact.weight[k] : 0.0f;
      for (int a = 0; a < 3; ++a) {
        state.contact_diagonal[i].column[a] += splat((s - grip) * contact.normal[a]) * contact.normal;
        state.contact_diagonal[i].column[a][a] += grip;
      }
    }
  }
  const auto own_block = [&](int i) {
    return state.in_contact[i] ? state.contact_diagonal[i] : diagonal_block(model, state, scales, i);
  };

  // A body takes the sum over its nodes' own blocks: an overestimate of its diagonal, which only costs iterations.
  Block3* d = state.inverse_diagonal.data();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    Block3& own = d[model.nodes + b];
    own = Block3{};
    for (int a = 0; a < 3; ++a) own.column[a][a] = body_matrix(model, state, b);
  }
  for (const auto& a : model.anchored) {
    Block3& own = d[model.nodes + a.body];
    const Block3 node = own_block(a.node);
    if (model.bodies[a.body].motion == Motion::translation) {
      for (int k = 0; k < 3; ++k) own.column[k] += node.column[k];
    } else {
      F4 product = splat(0.0f);
      for (int k = 0; k < 3; ++k) product += node.column[k] * splat(a.arm[k]);
      own.column[0][0] += dot3(product, a.arm);
    }
  }
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

  for (std::int32_t i : model.moving) {
    if (!state.stale[i] && !state.in_contact[i]) continue;
    d[i] = inverse(own_block(i));
    state.stale[i] = 0;
  }
  for (std::int32_t n = 0; n < state.contact_node_count; ++n) state.in_contact[state.contact_nodes[n]] = 0;
}

SolveResult solve(const TissueModel& model, TissueState& state, const ContactConstraint* contacts, int contact_count,
                  double enough_n, int most) noexcept {
  Float4 *x = state.solution.data(), *r = state.residual.data(), *p = state.direction.data(),
         *z = state.preconditioned.data(), *q = state.product.data();
  const std::size_t size = state.solution.size();
  multiply(model, state, contacts, contact_count, x, q);
  std::copy(state.rhs.begin(), state.rhs.end(), r);
  for (int c = 0; c < contact_count; ++c) {
    const ContactConstraint& contact = contacts[c];
    if (!contact.active) continue;
    F4 force = splat(contact.multiplier - contact.stiffness * contact.gap) * contact.normal;
    if (contact.grip > 0) force += held_friction(contact, contact.slip, contact.sticks);
    for (int k = 0; k < 4; ++k) r[contact.node[k]].v += splat(contact.weight[k]) * force;
  }
  reduce(model, r);
  for (std::size_t i = 0; i < size; ++i) r[i].v -= q[i].v;
  double squared = dot(r, r, size);
  precondition(model, state);
  std::copy(z, z + size, p);
  double rz = dot(r, z, size);
  SolveResult result;
  while (result.iterations < most && squared > enough_n * enough_n && rz > 0) {
    multiply(model, state, contacts, contact_count, p, q);
    const double curvature = dot(p, q, size);
    if (!(curvature > 0)) break;
    squared = advance(x, r, p, q, static_cast<float>(rz / curvature), size);
    ++result.iterations;
    if (!(squared > enough_n * enough_n)) break;
    precondition(model, state);
    const double next = dot(r, z, size);
    combine(p, z, static_cast<float>(next / rz), size);
    rz = next;
  }
  expand(model, x);
  result.residual_n = static_cast<float>(std::sqrt(squared));
  return result;
}

}  // namespace vallecula::engine
