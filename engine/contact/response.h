// The three selectable contact responses (DESIGN 4.3). Each advances the tissue by one step and leaves in every
// constraint's multiplier the force (N) it reads for that contact.
#pragma once

#include "engine/contact/tissue_contact.h"
#include "engine/tissue/implicit_step.h"

namespace vallecula::engine {

/// `sphere_distances`: `projection` also holds the tree's distances while there is contact.
StepStatistics respond(Response response, bool sphere_distances, const SphereTree& tree, const TissueModel& model,
                       const Pose& tool, TissueState& tissue, ContactState& contacts, StageTimes& times) noexcept;

/// Stiffness of the augmented Lagrangian over what a surface node itself offers within a step.
constexpr float kContactAugmentation = 60.0f;

/// Stiffness of the augmented Lagrangian per surface area (N/m^3): kContactAugmentation times the stiffness a surface node
/// offers in one step over the area it answers for. It sets how fast the multipliers settle, not the force they settle at.
float contact_stiffness_per_area(const TissueModel& model, const SoftSurface& surface);

}  // namespace vallecula::engine
