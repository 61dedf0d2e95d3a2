#include "engine/tissue/elasticity.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

constexpr int kRotationIterations = 1;
// Share of its rest volume below which a tetrahedron resists by itself: the nodes' mean does not see one that is turned
// inside out between swollen neighbours. Its pressure is lambda (x + kHardening x^3) of what is missing, x = det F - least.
// Tissue that was turned inside out by more than kTangled all the same goes without barrier until it is whole again:
// squashed neighbours would bar the way back (seen under a blade 25 mm deep without a force limit).
constexpr float kLeastVolume = 0.3f;
constexpr float kHardening = 60.0f;
constexpr float kTangled = -0.4f;
constexpr double kHoldNow = 2.0, kHoldSeconds = 0.003, kMostHoldGain = 0.3;  // of the volume hold
// Half of a bound on a curvature is enough for an implicit step to be stable, stretches beyond one ask for a little more.
constexpr float kPressureShare = 0.7f;
VALLECULA_INLINE void rotation_from_quaternion(const F8 q[4], F8 r[9]) {
  const F8 w = q[0], x = q[1], y = q[2], z = q[3];
  const F8 two = splat8(2.0f), one = splat8(1.0f);
  r[0] = one - two * (y * y + z * z);
  r[1] = two * (x * y - w * z);
  r[2] = two * (x * z + w * y);
  r[3] = two * (x * y + w * z);
  r[4] = one - two * (x * x + z * z);
  r[5] = two * (y * z - w * x);
  r[6] = two * (x * z - w * y);
  r[7] = two * (y * z + w * x);
  r[8] = one - two * (x * x + y * y);
}

/// One step of Mueller, Bender, Chentanez and Macklin (2016), "A robust method to extract the rotational part of
/// deformations": turn R towards F by the axis sum_k r_k x f_k over the columns.
VALLECULA_INLINE void improve_rotation(const F8 f[9], F8 q[4], F8 r[9]) {
  F8 axis[3] = {}, along = splat8(0.0f);
  for (int k = 0; k < 3; ++k) {
    const F8 rx = r[k], ry = r[3 + k], rz = r[6 + k], fx = f[k], fy = f[3 + k], fz = f[6 + k];
    axis[0] += ry * fz - rz * fy;
    axis[1] += rz * fx - rx * fz;
    axis[2] += rx * fy - ry * fx;
    along += rx * fx + ry * fy + rz * fz;
  }
  const F8 scale = splat8(0.5f) / (abs8(along) + splat8(1e-9f));
  const F8 a = axis[0] * scale, b = axis[1] * scale, c = axis[2] * scale;
  const F8 w = q[0] - a * q[1] - b * q[2] - c * q[3];
  const F8 x = q[1] + a * q[0] + b * q[3] - c * q[2];
  const F8 y = q[2] + b * q[0] + c * q[1] - a * q[3];
  const F8 z = q[3] + c * q[0] + a * q[2] - b * q[1];
  const F8 inverse = splat8(1.0f) / sqrt8(w * w + x * x + y * y + z * z);
  q[0] = w * inverse;
  q[1] = x * inverse;
  q[2] = y * inverse;
  q[3] = z * inverse;
  rotation_from_quaternion(q, r);
}

/// Displacement gradient of a pack, row major.
VALLECULA_INLINE void displacement_gradient(const TetPack& pack, const Float4* u, F8 f[9]) {
  for (int i = 0; i < 9; ++i) f[i] = splat8(0.0f);
  for (int c = 0; c < 4; ++c) {
    F8 x, y, z;
    gather(u, pack.node[c], x, y, z);
    for (int a = 0; a < 3; ++a) {
      const F8 g = pack.gradient[c][a];
      f[a] += x * g;
      f[3 + a] += y * g;
      f[6 + a] += z * g;
    }
  }
}

/// What the blocks of one tetrahedron are made of: rest gradients turned by R and by cof F, and the spherical stiffness.
struct TetFrame {
  F4 g[4], v[4];
  float mu, lambda, spherical;  ///< times the volume
};

TetFrame frame_of(const TetPack& pack, std::size_t lane, const PackAssembly& at) {
  TetFrame frame;
  const auto turned = [&](const F8 m[9], F4 out[4]) {
    F4 column[3];
    for (int k = 0; k < 3; ++k) column[k] = F4{m[k][lane], m[3 + k][lane], m[6 + k][lane], 0.0f};
    for (int c = 0; c < 4; ++c)
      out[c] = column[0] * splat(pack.gradient[c][0][lane]) + column[1] * splat(pack.gradient[c][1][lane]) +
               column[2] * splat(pack.gradient[c][2][lane]);
  };
  turned(at.rotation, frame.g);
  turned(at.cofactor, frame.v);
  frame.mu = pack.volume[lane] * pack.mu[lane];
  frame.lambda = pack.volume[lane] * pack.lambda[lane] * (1.0f + 3.0f * at.hardening[lane]);
  frame.spherical = frame.mu + pack.volume[lane] * kPressureShare * at.pressure[lane];
  return frame;
}

/// Column k of block (i, j):
/// K_ij = V [lambda c_i c_j^T + mu (g_j g_i^T + (g_i . g_j) 1) + s |p| (g_i . g_j) 1] with g = R and c = cof F times the
/// rest gradients: the corotational shear part, the Gauss-Newton part of the plain (not averaged) volumetric energy, and a
/// bound on the rest of it. That rest, p d2(det F)/dF2, has eigenvalues of both signs as large as |p| times a stretch;
/// left out, tissue squeezed under an edge, where |p| exceeds mu, swings itself to pieces.
VALLECULA_INLINE F4 block_column(const TetFrame& t, int i, int j, int k, float product) {
  F4 column = splat(t.lambda * t.v[j][k]) * t.v[i] + splat(t.mu * t.g[i][k]) * t.g[j];
  column[k] += t.spherical * product;
  return column;
}

/// Adds the tetrahedron's blocks to the stiffness, less those it had (`before` may be null).
void add_tet_stiffness(const TetFrame* before, const TetFrame& now, const std::array<std::int32_t, 16>& blocks,
                       BlockPair* stiffness) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const std::int32_t b = blocks[4 * i + j];
      if (b < 0) continue;
      const float product = dot3(now.g[i], now.g[j]);
      const float product_before = before != nullptr ? dot3(before->g[i], before->g[j]) : 0.0f;
      for (int k = 0; k < 3; ++k) {
        F4 column = block_column(now, i, j, k, product);
        if (before != nullptr) column -= block_column(*before, i, j, k, product_before);
        stiffness[b / 2].add(b % 2, k, column);
      }
    }
}

/// Rotations, cofactors, deviatoric stresses and nodal pressures at the present displacement.
VALLECULA_KERNEL void stress_pass(const TissueModel& model, TissueState& state, int iterations) {
  const F8 barrier_on = splat8(state.tangled ? 0.0f : 1.0f);
  F8 least = splat8(1.0f);
  for (std::size_t p = 0; p < model.packs.size(); ++p) {
    const TetPack& pack = model.packs[p];
    PackState& s = state.packs[p];
    F8 h[9], f[9], r[9];
    displacement_gradient(pack, state.displacement_f.data(), h);
    for (int i = 0; i < 9; ++i) f[i] = i % 4 == 0 ? h[i] + splat8(1.0f) : h[i];
    for (int i = 0; i < 9; ++i) r[i] = s.rotation[i];
    for (int i = 0; i < iterations; ++i) improve_rotation(f, s.quaternion, r);
    for (int i = 0; i < 9; ++i) s.rotation[i] = r[i];
    F8 m[9];  // R^T F
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m[3 * i + j] = r[i] * f[j] + r[3 + i] * f[3 + j] + r[6 + i] * f[6 + j];
    const F8 two_mu = pack.mu + pack.mu, one = splat8(1.0f);
    F8 t[6];  // symmetric: xx yy zz xy xz yz
    t[0] = two_mu * (m[0] - one);
    t[1] = two_mu * (m[4] - one);
    t[2] = two_mu * (m[8] - one);
    t[3] = pack.mu * (m[1] + m[3]);
    t[4] = pack.mu * (m[2] + m[6]);
    t[5] = pack.mu * (m[5] + m[7]);
    for (int i = 0; i < 3; ++i) {
      const F8 a = r[3 * i], b = r[3 * i + 1], c = r[3 * i + 2];
      s.deviatoric[3 * i] = a * t[0] + b * t[3] + c * t[4];
      s.deviatoric[3 * i + 1] = a * t[3] + b * t[1] + c * t[5];
      s.deviatoric[3 * i + 2] = a * t[4] + b * t[5] + c * t[2];
    }
    for (int i = 0; i < 3; ++i) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      for (int j = 0; j < 3; ++j) {
        const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        s.cofactor[3 * i + j] = f[3 * i1 + j1] * f[3 * i2 + j2] - f[3 * i1 + j2] * f[3 * i2 + j1];
      }
    }
    // det F - 1 from the displacement gradient: what is small stays exact.
    const F8 minors = (h[0] * h[4] - h[1] * h[3]) + (h[0] * h[8] - h[2] * h[6]) + (h[4] * h[8] - h[5] * h[7]);
    const F8 third = h[0] * (h[4] * h[8] - h[5] * h[7]) + h[1] * (h[5] * h[6] - h[3] * h[8]) +
                     h[2] * (h[3] * h[7] - h[4] * h[6]);
    const F8 change = (h[0] + h[4] + h[8]) + minors + third;
    const F8 left = change + splat8(1.0f);  // det F
    least = min8(least, left);
    const F8 squashed = barrier_on * pack.guarded * min8(splat8(0.0f), left - splat8(kLeastVolume));
    s.hardening = splat8(kHardening) * squashed * squashed;
    s.barrier = pack.lambda * squashed * (splat8(1.0f) + s.hardening);
    const F8 dilation = change * pack.volume * splat8(0.25f);
    for (int c = 0; c < 4; ++c)
      for (int lane = 0; lane < kLanes; ++lane) state.pressure[pack.pressure[c][lane]] += dilation[lane];
  }
  float smallest = 1.0f;
  for (int lane = 0; lane < kLanes; ++lane) smallest = std::min(smallest, least[lane]);
  state.tangled = smallest < (state.tangled ? 0.0f : kTangled);
}

/// Forces from the stresses and pressures of stress_pass.
VALLECULA_KERNEL void force_pass(const TissueModel& model, TissueState& state) {
  Float4* force = state.force.data();
  for (std::size_t p = 0; p < model.packs.size(); ++p) {
    const TetPack& pack = model.packs[p];
    PackState& s = state.packs[p];
    F8 pressure;
    for (int lane = 0; lane < kLanes; ++lane)
      pressure[lane] = (state.pressure[pack.pressure[0][lane]] + state.pressure[pack.pressure[1][lane]]) +
                       (state.pressure[pack.pressure[2][lane]] + state.pressure[pack.pressure[3][lane]]);
    pressure = pressure * splat8(0.25f) + s.barrier;
    s.pressure = pressure;
    F8 stress[9];
    for (int i = 0; i < 9; ++i) stress[i] = -(pressure * s.cofactor[i] + s.deviatoric[i]) * pack.volume;
    for (int c = 0; c < 4; ++c) {
      const F8* g = pack.gradient[c];
      scatter_add(force, pack.node[c], stress[0] * g[0] + stress[1] * g[1] + stress[2] * g[2],
                  stress[3] * g[0] + stress[4] * g[1] + stress[5] * g[2],
                  stress[6] * g[0] + stress[7] * g[1] + stress[8] * g[2]);
    }
  }
}

/// Fills stresses and nodal pressures; returns the change of the held volume, m^3.
double find_stresses(const TissueModel& model, TissueState& state, int iterations) {
  for (int i = 0; i < model.nodes; ++i) state.displacement_f[i].v = from_vec3(state.displacement[i]);
  std::fill(state.pressure.begin(), state.pressure.end(), 0.0f);
  stress_pass(model, state, iterations);
  double dilation = 0.0;
  for (std::size_t n = 0; n < state.pressure.size(); ++n) {  // V (Jn - 1), then lambda (Jn - 1)
    dilation += double(model.pressure_held[n]) * state.pressure[n];
    state.pressure[n] *= model.pressure_inverse_volume[n] * model.pressure_lambda[n];
  }
  return dilation;
}

/// The pressure that keeps the whole body's volume within its band: what is lost beyond times lambda and a sum over time of
/// the same, never more than lambda, so that tissue jammed between blade and bone is not blown up. Explicit, and stable since
/// inertia lets a pressure change the volume within a tick by far less than lambda says. `dilation`: change of the held
/// volume, m^3.
void hold_volume(const TissueModel& model, TissueState& state, double dilation) {
  if (!(model.held_volume > 0)) return;
  const double beyond = model.held_lambda * (dilation / model.held_volume + TissueModel::kVolumeBand);
  const auto bounded = [&](double pressure) { return std::clamp(pressure, -model.held_lambda, 0.0); };
  if (!state.tangled)  // volume turned inside out is not lost
    state.held_pressure = bounded(state.held_pressure + std::min(kMostHoldGain, model.step_s / kHoldSeconds) * beyond);
  const float held = static_cast<float>(bounded(state.held_pressure + kHoldNow * beyond));
  if (held == 0.0f) return;
  for (std::size_t n = 0; n < state.pressure.size(); ++n) state.pressure[n] += held * model.pressure_held[n];
}

/// How far the blocks are out of date: squared change of rotation and cofactor, and of the pressure over the shear modulus.
VALLECULA_KERNEL void changes(const TetPack& pack, const PackState& s, const PackAssembly& a, F8& change) {
  const F8 p = (abs8(s.pressure) - a.pressure) / (pack.mu + splat8(1e-9f)) * splat8(0.2f);
  change = p * p;
  for (int i = 0; i < 9; ++i) {
    const F8 d = s.rotation[i] - a.rotation[i], e = s.cofactor[i] - a.cofactor[i];
    change += d * d + e * e;
  }
}

}  // namespace

void elastic_forces(const TissueModel& model, TissueState& state) noexcept {
  hold_volume(model, state, find_stresses(model, state, kRotationIterations));
  std::fill(state.force.begin(), state.force.end(), Float4{});
  force_pass(model, state);
}

void refresh_stiffness(const TissueModel& model, TissueState& state, int visit, int most) noexcept {
  const int count = static_cast<int>(model.packs.size());
  int left = most;
  const float softest = static_cast<float>(TissueModel::kRefreshTolerance);
  int at = state.refresh_at;
  for (int visited = 0; visited < std::min(visit, count) && left > 0; ++visited, at = at + 1 < count ? at + 1 : 0) {
    const PackState& s = state.packs[at];
    PackAssembly& a = state.assembly[at];
    const TetPack& pack = model.packs[at];
    F8 change;
    changes(pack, s, a, change);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (!(change[lane] > pack.tolerance[lane]) || pack.tet[lane] < 0) continue;
      const auto& blocks = model.tet_block[static_cast<std::size_t>(at) * kLanes + lane];
      const TetFrame before = frame_of(pack, lane, a);
      for (int i = 0; i < 9; ++i) {
        a.rotation[i][lane] = s.rotation[i][lane];
        a.cofactor[i][lane] = s.cofactor[i][lane];
      }
      a.pressure[lane] = std::abs(s.pressure[lane]);
      a.hardening[lane] = s.hardening[lane];
      add_tet_stiffness(&before, frame_of(pack, lane, a), blocks, state.stiffness.data());
      for (int c = 0; c < 4; ++c) state.stale[pack.node[c][lane]] = 1;
      if (pack.tolerance[lane] >= softest) --left;
    }
  }
  state.refresh_at = at;
}

void assemble_stiffness(const TissueModel& model, TissueState& state) {
  std::fill(state.stiffness.begin(), state.stiffness.end(), BlockPair{});
  std::fill(state.stale.begin(), state.stale.end(), 1);
  for (std::size_t p = 0; p < model.packs.size(); ++p) {
    const PackState& s = state.packs[p];
    PackAssembly& a = state.assembly[p];
    std::copy(std::begin(s.rotation), std::end(s.rotation), a.rotation);
    std::copy(std::begin(s.cofactor), std::end(s.cofactor), a.cofactor);
    a.pressure = abs8(s.pressure);
    a.hardening = s.hardening;
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      if (model.packs[p].tet[lane] >= 0)
        add_tet_stiffness(nullptr, frame_of(model.packs[p], lane, a), model.tet_block[p * kLanes + lane],
                          state.stiffness.data());
  }
}

double elastic_energy(const TissueModel& model, TissueState& state) {
  find_stresses(model, state, 30);  // converged rotations
  double energy = 0.0;
  for (std::size_t p = 0; p < model.packs.size(); ++p) {
    const TetPack& pack = model.packs[p];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (!(pack.volume[lane] > 0)) continue;
      double squared = 0.0;  // |2 mu (S - 1)|^2, unchanged by the rotation in front
      for (int i = 0; i < 9; ++i) squared += double(state.packs[p].deviatoric[i][lane]) * state.packs[p].deviatoric[i][lane];
      const double hardening = state.packs[p].hardening[lane], squashed_squared = hardening / kHardening;
      energy += pack.volume[lane] * (squared / (4.0 * pack.mu[lane]) +
                                     pack.lambda[lane] * squashed_squared * (0.5 + 0.25 * hardening));
    }
  }
  for (std::size_t n = 0; n < state.pressure.size(); ++n)
    energy += 0.5 * double(state.pressure[n]) * state.pressure[n] /
              (double(model.pressure_lambda[n]) * model.pressure_inverse_volume[n] + 1e-30);
  return energy;
}

TissueState::TissueState(const TissueModel& model) {
  const std::size_t unknowns = model.nodes + model.bodies.size();
  displacement.assign(model.nodes, Vec3::Zero());
  velocity.assign(model.nodes, Vec3::Zero());
  body_displacement.assign(model.bodies.size(), Vec3::Zero());
  body_velocity.assign(model.bodies.size(), Vec3::Zero());
  body_load.assign(model.bodies.size(), Vec3::Zero());
  body_load_stiffness.assign(model.bodies.size(), 0.0);
  packs.resize(model.packs.size());
  assembly.resize(model.packs.size());
  stiffness.resize(model.column.size() / 2);
  for (auto* v : {&external, &displacement_f, &force, &rhs, &solution, &residual, &direction, &product, &preconditioned})
    v->resize(unknowns + unknowns % 2);
  inverse_diagonal.resize(unknowns + unknowns % 2);
  stale.assign(model.nodes, 1);
  contact_diagonal.resize(model.nodes);
  contact_nodes.resize(model.nodes);
  in_contact.assign(model.nodes, 0);
  pressure.resize(model.pressure_lambda.size());
  const std::size_t size = 6 * static_cast<std::size_t>(model.coarse_groups);
  coarse.centre.resize(model.coarse_groups);
  coarse.arm.resize(model.coarse_nodes.size());
  coarse.base.resize(size * size);
  coarse.factor.resize(size * size);
  coarse.vector.resize(size);
  set_rest(model);
}

void TissueState::set_rest(const TissueModel& model) {
  for (auto* v : {&displacement, &velocity, &body_displacement, &body_velocity, &body_load})
    std::fill(v->begin(), v->end(), Vec3::Zero());
  for (PackState& s : packs) {
    for (int i = 0; i < 4; ++i) s.quaternion[i] = splat8(i == 0 ? 1.0f : 0.0f);
    for (int i = 0; i < 9; ++i) {
      s.rotation[i] = s.cofactor[i] = splat8(i % 4 == 0 ? 1.0f : 0.0f);
      s.deviatoric[i] = splat8(0.0f);
    }
    s.pressure = s.barrier = s.hardening = splat8(0.0f);
  }
  std::fill(body_load_stiffness.begin(), body_load_stiffness.end(), 0.0);
  std::fill(solution.begin(), solution.end(), Float4{});
  std::fill(external.begin(), external.end(), Float4{});
  held_pressure = 0.0;
  tangled = false;
  fastest_m = 0.0;
  refresh_at = 0;
  steps = 0;
  assemble_stiffness(model, *this);
}

}  // namespace vallecula::engine
