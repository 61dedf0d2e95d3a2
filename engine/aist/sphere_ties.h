// What a sphere takes along when its centre is corrected (paper 3.1.2, 3.2): the nodes of the tetrahedra it encloses; and
// which spheres keep their distance for the tissue's volume (paper 3.1).
#pragma once

#include "engine/aist/sphere_tree.h"

namespace vallecula::engine {

/// Ties `sphere` to the nodes of the tetrahedra `enclosed` and of its own: sum weight_k x_k is its centre, with the weights
/// summing to 1 and otherwise as even as can be, so that a correction moves them nearly alike. Appends to the tree's
/// tied_nodes and tied_weights.
void tie_sphere(const SoftBodyDescription& soft, const std::vector<int>& enclosed, InnerSphere& sphere, SphereTree& tree);

/// Pairs of spheres of the grid (levels below `levels`) that touch or nearly do, in the order of the first's place along x.
std::vector<SphereDistance> sphere_distances(const SphereTree& tree, int levels);

}  // namespace vallecula::engine
