// The second level of the solver's preconditioner: rigid motions of small groups of nodes of the stiff tissue.
//
// Cartilage joined to muscle makes a system whose slowest error modes are the cartilage's near-rigid motions: block Jacobi
// sees its stiff springs and moves it by crumbs, so that a solve stopped after ten iterations leaves it drifting on its
// own momentum (seen: an epiglottis that flapped at 6.5 Hz under a still blade; 60 iterations stilled it). Solving for
// those motions directly (a two-level additive Schwarz method; Nicolaides 1987) gives the same rest in ten.
#pragma once

#include <vector>

#include "engine/contact/contact_constraint.h"
#include "engine/tissue/tissue_state.h"

namespace vallecula::engine {

/// Rebuilds the elastic and inertial part of the coarse matrix at the present stiffness and positions. Every
/// kCoarseRefreshSteps steps is enough: it is only a preconditioner.
void refresh_coarse(const TissueModel& model, TissueState& state, float mass_scale, float stiffness_scale) noexcept;

/// Adds the active contacts and factorises. Without a coarse space, or if the matrix is not positive definite, the
/// correction is switched off for this step.
void factor_coarse(const TissueModel& model, TissueState& state, const ContactConstraint* contacts,
                   int contact_count) noexcept;

/// z += P (P^T A P)^-1 P^T r.
void add_coarse_correction(const TissueModel& model, TissueState& state, const std::vector<Float4>& r,
                           std::vector<Float4>& z) noexcept;

}  // namespace vallecula::engine
