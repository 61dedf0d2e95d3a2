// Fewer of the tree's surface points, for a round body: the blade's edges need one every millimetre and the grid's
// spheres behind them, a tube does not.
#pragma once

#include "engine/aist/sphere_tree.h"

namespace vallecula::engine {

/// Per sphere of the tree the surface area (m^2) its point answers for when all of the surface's vertices and, between
/// them, only points `spacing_m` apart from these and each other are asked; 0: it is not asked. `nodes`: at rest, m.
std::vector<float> thinned_areas(const SphereTree& tree, const SoftSurface& surface, const std::vector<Vec3>& nodes,
                                 double spacing_m);

}  // namespace vallecula::engine
