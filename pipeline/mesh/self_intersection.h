// Where a surface crosses or touches itself.
#pragma once

#include <array>
#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// Pairs of triangles that have more in common than their common corners or edge: they cross, touch, or lie on each
/// other (a fold flat onto itself too). A triangle without area is a pair with itself. In order, each pair once.
///
/// Decided exactly, for the points rounded to 2^-40 of the surface's extent (1e-10 mm on a head): two sheets that far
/// apart are told apart. 73,000 triangles take about a tenth of a second.
std::vector<std::array<int, 2>> self_intersections(const Surface& surface);

}  // namespace vallecula::pipeline
