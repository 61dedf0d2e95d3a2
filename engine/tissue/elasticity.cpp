#include "engine/tissue/elasticity.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

constexpr int kRotationIterations = 2;
// A rotation that changed by less than this (squared Frobenius norm; 2 angle^2, so 0.6 degrees) keeps its stiffness.
constexpr float kRefreshThreshold = 2e-4f;

void rotation_from_quaternion(const F4 q[4], F4 r[9]) {
  const F4 w = q[0], x = q[1], y = q[2], z = q[3];
  const F4 two = splat(2.0f), one = splat(1.0f);
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
void improve_rotation(const F4 f[9], F4 q[4], F4 r[9]) {
  F4 axis[3] = {}, along = splat(0.0f);
  for (int k = 0; k < 3; ++k) {
    const F4 rx = r[k], ry = r[3 + k], rz = r[6 + k], fx = f[k], fy = f[3 + k], fz = f[6 + k];
    axis[0] += ry * fz - rz * fy;
    axis[1] += rz * fx - rx * fz;
    axis[2] += rx * fy - ry * fx;
    along += rx * fx + ry * fy + rz * fz;
  }
  const F4 scale = splat(0.5f) / (abs4(along) + splat(1e-9f));
  const F4 a = axis[0] * scale, b = axis[1] * scale, c = axis[2] * scale;
  const F4 w = q[0] - a * q[1] - b * q[2] - c * q[3];
  const F4 x = q[1] + a * q[0] + b * q[3] - c * q[2];
  const F4 y = q[2] + b * q[0] + c * q[1] - a * q[3];
  const F4 z = q[3] + c * q[0] + a * q[2] - b * q[1];
  const F4 inverse = splat(1.0f) / sqrt4(w * w + x * x + y * y + z * z);
  q[0] = w * inverse;
  q[1] = x * inverse;
  q[2] = y * inverse;
  q[3] = z * inverse;
  rotation_from_quaternion(q, r);
}

/// Deformation gradient of a pack, row major, from node displacements.
void deformation_gradient(const TetPack& pack, const Float4* u, F4 f[9]) {
  for (int i = 0; i < 9; ++i) f[i] = splat(i % 4 == 0 ? 1.0f : 0.0f);
  for (int c = 0; c < 4; ++c) {
    F4 x = u[pack.node[c][0]].v, y = u[pack.node[c][1]].v, z = u[pack.node[c][2]].v, w = u[pack.node[c][3]].v;
    transpose(x, y, z, w);
    for (int a = 0; a < 3; ++a) {
      const F4 g = pack.gradient[c][a];
      f[a] += x * g;
      f[3 + a] += y * g;
      f[6 + a] += z * g;
    }
  }
}

/// Adds `sign` times the stiffness of one tetrahedron, turned by lane `lane` of `rotation`:
/// K_ij = V [lambda g_i g_j^T + mu g_j g_i^T + mu (g_i . g_j) 1] with g_i = R times the rest gradient.
void add_tet_stiffness(const TetPack& pack, int lane, const F4 rotation[9], const std::array<std::int32_t, 16>& blocks,
                       float sign, Block3* stiffness) {
  F4 r_column[3];
  for (int k = 0; k < 3; ++k) r_column[k] = F4{rotation[k][lane], rotation[3 + k][lane], rotation[6 + k][lane], 0.0f};
  F4 g[4];
  for (int c = 0; c < 4; ++c)
    g[c] = r_column[0] * splat(pack.gradient[c][0][lane]) + r_column[1] * splat(pack.gradient[c][1][lane]) +
           r_column[2] * splat(pack.gradient[c][2][lane]);
  const float scale = sign * pack.volume[lane];
  const float mu = scale * pack.mu[lane], lambda = scale * pack.lambda[lane];
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      Block3& block = stiffness[blocks[4 * i + j]];
      const float isotropic = mu * dot3(g[i], g[j]);
      for (int k = 0; k < 3; ++k) {
        F4 column = splat(lambda * g[j][k]) * g[i] + splat(mu * g[i][k]) * g[j];
        column[k] += isotropic;
        block.column[k] += column;
      }
    }
}

/// Rotations, deviatoric stresses and nodal pressures at the present displacement.
void stress_pass(const TissueModel& model, TissueState& state, int iterations) {
  for (int i = 0; i < model.nodes; ++i) state.displacement_f[i].v = from_vec3(state.displacement[i]);
  std::fill(state.pressure.begin(), state.pressure.end(), 0.0f);
  for (std::size_t p = 0; p < model.packs.size(); ++p) {
    const TetPack& pack = model.packs[p];
    PackState& s = state.packs[p];
    F4 f[9];
    deformation_gradient(pack, state.displacement_f.data(), f);
    F4* r = s.rotation;
    for (int i = 0; i < iterations; ++i) improve_rotation(f, s.quaternion, r);
    F4 m[9];  // R^T F
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m[3 * i + j] = r[i] * f[j] + r[3 + i] * f[3 + j] + r[6 + i] * f[6 + j];
    const F4 two_mu = pack.mu + pack.mu, one = splat(1.0f);
    F4 t[6];  // symmetric: xx yy zz xy xz yz
    t[0] = two_mu * (m[0] - one);
    t[1] = two_mu * (m[4] - one);
    t[2] = two_mu * (m[8] - one);
    t[3] = pack.mu * (m[1] + m[3]);
    t[4] = pack.mu * (m[2] + m[6]);
    t[5] = pack.mu * (m[5] + m[7]);
    for (int i = 0; i < 3; ++i) {
      const F4 a = r[3 * i], b = r[3 * i + 1], c = r[3 * i + 2];
      s.deviatoric[3 * i] = a * t[0] + b * t[3] + c * t[4];
      s.deviatoric[3 * i + 1] = a * t[3] + b * t[1] + c * t[5];
      s.deviatoric[3 * i + 2] = a * t[4] + b * t[5] + c * t[2];
    }
    const F4 dilation = (m[0] + m[4] + m[8] - splat(3.0f)) * pack.volume * splat(0.25f);
    for (int c = 0; c < 4; ++c)
      for (int lane = 0; lane < 4; ++lane) state.pressure[pack.pressure[c][lane]] += dilation[lane];
  }
  for (std::size_t n = 0; n < state.pressure.size(); ++n)  // theta_n, then lambda theta_n
    state.pressure[n] *= model.pressure_inverse_volume[n] * model.pressure_lambda[n];
}

}  // namespace

void elastic_forces(const TissueModel& model, TissueState& state) noexcept {
  stress_pass(model, state, kRotationIterations);
  std::fill(state.force.begin(), state.force.end(), Float4{});
  Float4* force = state.force.data();
  for (std::size_t p = 0; p < model.packs.size(); ++p) {
    const TetPack& pack = model.packs[p];
    const PackState& s = state.packs[p];
    F4 pressure = splat(0.0f);
    for (int c = 0; c < 4; ++c)
      for (int lane = 0; lane < 4; ++lane) pressure[lane] += state.pressure[pack.pressure[c][lane]];
    pressure *= splat(0.25f);
    F4 stress[9];
    for (int i = 0; i < 9; ++i) stress[i] = (s.deviatoric[i] + pressure * s.rotation[i]) * pack.volume;
    for (int c = 0; c < 4; ++c) {
      const F4* g = pack.gradient[c];
      F4 x = -(stress[0] * g[0] + stress[1] * g[1] + stress[2] * g[2]);
      F4 y = -(stress[3] * g[0] + stress[4] * g[1] + stress[5] * g[2]);
      F4 z = -(stress[6] * g[0] + stress[7] * g[1] + stress[8] * g[2]);
      F4 w = splat(0.0f);
      transpose(x, y, z, w);
      force[pack.node[c][0]].v += x;
      force[pack.node[c][1]].v += y;
      force[pack.node[c][2]].v += z;
      force[pack.node[c][3]].v += w;
    }
  }
}

void refresh_stiffness(const TissueModel& model, TissueState& state, int most) noexcept {
  const int count = static_cast<int>(model.packs.size());
  int left = most;
  int at = state.refresh_at;
  for (int visited = 0; visited < count && left > 0; ++visited, at = at + 1 < count ? at + 1 : 0) {
    PackState& s = state.packs[at];
    F4 change = splat(0.0f);
    for (int i = 0; i < 9; ++i) {
      const F4 d = s.rotation[i] - s.assembled_rotation[i];
      change += d * d;
    }
    for (int lane = 0; lane < 4; ++lane) {
      const int tet = 4 * at + lane;
      if (!(change[lane] > kRefreshThreshold) || tet >= model.tets) continue;
      add_tet_stiffness(model.packs[at], lane, s.assembled_rotation, model.tet_block[tet], -1.0f, state.stiffness.data());
      add_tet_stiffness(model.packs[at], lane, s.rotation, model.tet_block[tet], 1.0f, state.stiffness.data());
      for (int i = 0; i < 9; ++i) s.assembled_rotation[i][lane] = s.rotation[i][lane];
      --left;
    }
  }
  state.refresh_at = at;
}

void assemble_stiffness(const TissueModel& model, TissueState& state) {
  std::fill(state.stiffness.begin(), state.stiffness.end(), Block3{});
  for (int t = 0; t < model.tets; ++t) {
    PackState& s = state.packs[t / 4];
    add_tet_stiffness(model.packs[t / 4], t % 4, s.rotation, model.tet_block[t], 1.0f, state.stiffness.data());
  }
  for (PackState& s : state.packs) std::copy(std::begin(s.rotation), std::end(s.rotation), s.assembled_rotation);
}

double elastic_energy(const TissueModel& model, TissueState& state) {
  stress_pass(model, state, 30);  // converged rotations
  double energy = 0.0;
  for (std::size_t p = 0; p < model.packs.size(); ++p) {
    const TetPack& pack = model.packs[p];
    for (int lane = 0; lane < 4; ++lane) {
      if (!(pack.volume[lane] > 0)) continue;
      double squared = 0.0;  // |2 mu (S - I)|^2, unchanged by the rotation in front
      for (int i = 0; i < 9; ++i) squared += double(state.packs[p].deviatoric[i][lane]) * state.packs[p].deviatoric[i][lane];
      energy += pack.volume[lane] * squared / (4.0 * pack.mu[lane]);
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
  packs.resize(model.packs.size());
  stiffness.resize(model.column.size());
  for (auto* v : {&external, &displacement_f, &force, &rhs, &solution, &residual, &direction, &product, &preconditioned})
    v->resize(unknowns);
  inverse_diagonal.resize(unknowns);
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
  for (auto* v : {&displacement, &velocity, &body_displacement, &body_velocity})
    std::fill(v->begin(), v->end(), Vec3::Zero());
  for (PackState& s : packs) {
    for (int i = 0; i < 4; ++i) s.quaternion[i] = splat(i == 0 ? 1.0f : 0.0f);
    rotation_from_quaternion(s.quaternion, s.rotation);
    std::fill(std::begin(s.deviatoric), std::end(s.deviatoric), splat(0.0f));
  }
  std::fill(solution.begin(), solution.end(), Float4{});
  std::fill(external.begin(), external.end(), Float4{});
  refresh_at = 0;
  steps = 0;
  assemble_stiffness(model, *this);
}

}  // namespace vallecula::engine
