// One implicit Euler step of the soft body with its contacts (paper, Algorithm 1; DESIGN 4.3 `compliant`).
#pragma once

#include <vector>

#include "engine/contact/contact_constraint.h"
#include "engine/stage_clock.h"
#include "engine/tissue/tissue_state.h"

namespace vallecula::engine {

struct StepStatistics {
  int iterations = 0;        ///< of the linear solver
  float residual_n = 0.0f;   ///< that it left, N
};

/// Advances displacement and velocity by one step:
///   (M/h^2 + D/h + K) du = M v/h + f_elastic + sum_j J_j^T lambda_j,   lambda_j = max(0, lambda_j - k_j gap_j(du)),
/// i.e. an augmented Lagrangian whose multipliers partly live on between ticks: the contact forces are part of the same
/// linear system (the metric of the implicit step), and at rest they balance the elastic forces exactly, whatever k is.
/// `active` of each contact says which are taken to push at first; they are chosen anew as the solution becomes known.
/// On return the contacts' multipliers are their forces. With no contacts it is the free step of Algorithm 1's first two lines.
StepStatistics implicit_step(const TissueModel& model, TissueState& state, ContactConstraint* contacts,
                             int contact_count, StageTimes& times) noexcept;

/// Moves anchored nodes to where their bodies' displacements put them.
void follow_bodies(const TissueModel& model, TissueState& state) noexcept;

}  // namespace vallecula::engine
