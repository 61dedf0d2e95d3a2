// Element passes: rotations, elastic forces and the stiffness matrix of the soft body.
#pragma once

#include "engine/tissue/tissue_state.h"

namespace vallecula::engine {

/// Elastic forces at the present displacement: state.force[i] = -dE/du_i (N) for every node (anchored ones included,
/// their bodies' entries zero). Updates rotations
/// (one warm-started iteration of Mueller et al. 2016).
void elastic_forces(const TissueModel& model, TissueState& state) noexcept;

/// Brings the stiffness up to the present deformation for tetrahedra that turned or were squeezed since they were last
/// assembled: looks at `visit` packs a call (round robin) and renews at most about `most` tetrahedra of
/// the softest tissue, and all that need it of stiffer. The matrix is that of
/// plain tetrahedra, which bounds the nodally averaged energy from above (Jensen), so that steps taken with it are stable
/// and come to rest at its minimum. Marks the nodes whose diagonal blocks changed as stale.
void refresh_stiffness(const TissueModel& model, TissueState& state, int visit, int most) noexcept;

/// Assembles everything anew at the present rotations (outside any tick: after a reset).
void assemble_stiffness(const TissueModel& model, TissueState& state);

/// Elastic energy of the nodally averaged model at the present displacement, J (tests: force = -dE/du).
double elastic_energy(const TissueModel& model, TissueState& state);

}  // namespace vallecula::engine
