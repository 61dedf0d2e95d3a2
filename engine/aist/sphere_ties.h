// What a sphere takes along when its centre is corrected (paper 3.1.2, 3.2): the nodes of the tetrahedra it encloses.
#pragma once

#include "engine/aist/sphere_tree.h"

namespace vallecula::engine {

/// Ties `sphere` to the nodes of the tetrahedra `enclosed` and of its own: sum weight_k x_k is its centre, with the weights
/// summing to 1 and otherwise as even as can be, so that a correction moves them nearly alike. Appends to the tree's
/// tied_nodes and tied_weights.
void tie_sphere(const SoftBodyDescription& soft, const std::vector<int>& enclosed, InnerSphere& sphere, SphereTree& tree);

}  // namespace vallecula::engine
