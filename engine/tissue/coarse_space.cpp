#include "engine/tissue/coarse_space.h"

#include <algorithm>
#include <cmath>

namespace vallecula::engine {

namespace {

Vec3 arm_of(const TissueState& state, int index) { return state.coarse.arm[index]; }

/// Adds G_i^T B G_j for a 3x3 block B, with G = [1, -[arm]x] (translation, rotation about the group's centre).
void add_block(const Mat3& b, const Vec3& arm_i, const Vec3& arm_j, int row, int column, int size, double* matrix) {
  // Columns of B G_j: B e_k, then B (e_k x arm_j).
  for (int k = 0; k < 6; ++k) {
    const Vec3 move = k < 3 ? Vec3(Vec3::Unit(k)) : Vec3(Vec3::Unit(k - 3).cross(arm_j));
    const Vec3 force = b * move;
    const Vec3 torque = arm_i.cross(force);
    for (int a = 0; a < 3; ++a) {
      matrix[(row + a) * size + column + k] += force[a];
      matrix[(row + 3 + a) * size + column + k] += torque[a];
    }
  }
}

}  // namespace

void refresh_coarse(const TissueModel& model, TissueState& state, float mass_scale, float stiffness_scale) noexcept {
  const int groups = model.coarse_groups, size = 6 * groups;
  if (groups == 0) return;
  CoarseState& coarse = state.coarse;
  std::fill(coarse.centre.begin(), coarse.centre.end(), Vec3::Zero());
  for (std::size_t n = 0; n < model.coarse_nodes.size(); ++n) {
    const auto& [node, group] = model.coarse_nodes[n];
    coarse.centre[group] += (model.rest[node] + state.displacement[node]) / model.coarse_count[group];
  }
  for (std::size_t n = 0; n < model.coarse_nodes.size(); ++n) {
    const auto& [node, group] = model.coarse_nodes[n];
    coarse.arm[n] = model.rest[node] + state.displacement[node] - coarse.centre[group];
  }
  std::fill(coarse.base.begin(), coarse.base.end(), 0.0);
  for (std::size_t n = 0; n < model.coarse_nodes.size(); ++n) {
    const auto& [i, group] = model.coarse_nodes[n];
    for (std::int32_t b = model.row_start[i]; b < model.row_start[i + 1]; ++b) {
      const std::int32_t other = model.coarse_index[model.column[b]];
      if (other < 0) continue;
      const Block3 k = state.stiffness_block(b);
      Mat3 block;
      for (int c = 0; c < 3; ++c) block.col(c) = stiffness_scale * to_vec3(k.column[c]);
      if (b == model.diagonal[i]) block.diagonal().array() += mass_scale * model.mass[i];
      add_block(block, arm_of(state, static_cast<int>(n)), arm_of(state, other), 6 * group,
                6 * model.coarse_nodes[other].group, size, coarse.base.data());
    }
  }
}

void factor_coarse(const TissueModel& model, TissueState& state, const ContactConstraint* contacts,
                   int contact_count) noexcept {
  const int size = 6 * model.coarse_groups;
  CoarseState& coarse = state.coarse;
  coarse.usable = false;
  if (size == 0) return;
  coarse.factor = coarse.base;
  for (int c = 0; c < contact_count; ++c) {
    const ContactConstraint& contact = contacts[c];
    if (!contact.active) continue;
    std::int32_t index[4];
    bool any = false;
    for (int k = 0; k < 4; ++k) {
      index[k] = contact.weight[k] > 0 ? model.coarse_index[contact.node[k]] : -1;
      any |= index[k] >= 0;
    }
    if (!any) continue;
    const Vec3 n = to_vec3(contact.normal);
    const Mat3 normal = contact.stiffness * n * n.transpose();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (index[i] >= 0 && index[j] >= 0)
          add_block(contact.weight[i] * contact.weight[j] * normal, coarse.arm[index[i]], coarse.arm[index[j]],
                    6 * model.coarse_nodes[index[i]].group, 6 * model.coarse_nodes[index[j]].group, size,
                    coarse.factor.data());
  }
  // Cholesky in place, lower triangle.
  double* a = coarse.factor.data();
  for (int j = 0; j < size; ++j) {
    double d = a[j * size + j];
    for (int k = 0; k < j; ++k) d -= a[j * size + k] * a[j * size + k];
    if (!(d > 0) || !std::isfinite(d)) return;
    const double root = std::sqrt(d);
    a[j * size + j] = root;
    for (int i = j + 1; i < size; ++i) {
      double s = a[i * size + j];
      for (int k = 0; k < j; ++k) s -= a[i * size + k] * a[j * size + k];
      a[i * size + j] = s / root;
    }
  }
  coarse.usable = true;
}

void add_coarse_correction(const TissueModel& model, TissueState& state, const std::vector<Float4>& r,
                           std::vector<Float4>& z) noexcept {
  CoarseState& coarse = state.coarse;
  if (!coarse.usable) return;
  const int size = 6 * model.coarse_groups;
  double* y = coarse.vector.data();
  std::fill(y, y + size, 0.0);
  for (std::size_t n = 0; n < model.coarse_nodes.size(); ++n) {
    const Vec3 f = to_vec3(r[model.coarse_nodes[n].node].v), torque = coarse.arm[n].cross(f);
    double* own = y + 6 * model.coarse_nodes[n].group;
    for (int a = 0; a < 3; ++a) {
      own[a] += f[a];
      own[3 + a] += torque[a];
    }
  }
  const double* l = coarse.factor.data();
  for (int i = 0; i < size; ++i) {
    double s = y[i];
    for (int k = 0; k < i; ++k) s -= l[i * size + k] * y[k];
    y[i] = s / l[i * size + i];
  }
  for (int i = size - 1; i >= 0; --i) {
    double s = y[i];
    for (int k = i + 1; k < size; ++k) s -= l[k * size + i] * y[k];
    y[i] = s / l[i * size + i];
  }
  for (std::size_t n = 0; n < model.coarse_nodes.size(); ++n) {
    const double* own = y + 6 * model.coarse_nodes[n].group;
    z[model.coarse_nodes[n].node].v +=
        from_vec3(Vec3(own[0], own[1], own[2]) + Vec3(own[3], own[4], own[5]).cross(coarse.arm[n]));
  }
}

}  // namespace vallecula::engine
