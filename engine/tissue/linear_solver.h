// The linear system of one implicit step and its solution by preconditioned conjugate gradients.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/contact/contact_constraint.h"
#include "engine/tissue/tissue_state.h"

namespace vallecula::engine {

/// The system's matrix is A = (1 + alpha h) M / h^2 + (1 + beta / h) K + sum_active k_j J_j^T J_j over the free nodes and the
/// bodies' unknowns (anchored nodes follow their bodies, fixed nodes have none). Renews the inverses of its diagonal blocks
/// where they changed: nodes whose stiffness was refreshed, and nodes in contact.
void build_preconditioner(const TissueModel& model, TissueState& state, const ContactConstraint* contacts,
                          int contact_count) noexcept;

struct SolveResult {
  int iterations = 0;
  float residual_n = 0.0f;  ///< Euclidean norm over the unknowns, N
};

/// Solves A x = rhs + contact terms from state.solution as first guess, in state.solution; ends at a residual norm of
/// `enough_n` (N) or after `most` iterations. Leaves the anchored nodes' entries where their bodies put them.
SolveResult solve(const TissueModel& model, TissueState& state, const ContactConstraint* contacts, int contact_count,
                  double enough_n, int most) noexcept;

/// Friction on the tissue at a slip: of the sticking spring, or of the limit against the slip where the point slides (N).
inline F4 held_friction(const ContactConstraint& contact, F4 slip, bool sticks) {
  const float size = std::sqrt(dot3(slip, slip));
  if (sticks || size == 0.0f) return splat(-contact.grip) * slip;
  return splat(-std::min(contact.friction_limit, contact.grip * size) / size) * slip;
}

/// Gap of a contact after the nodes have moved by `du`, m.
inline float gap_after(const ContactConstraint& contact, const Float4* du) {
  float along = 0.0f;
  for (int k = 0; k < 4; ++k) along += contact.weight[k] * dot3(contact.normal, du[contact.node[k]].v);
  return contact.gap + along;
}

}  // namespace vallecula::engine
