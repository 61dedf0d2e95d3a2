// Points inside a closed surface, evenly spread at a wanted distance: what good tetrahedra are made between.
#pragma once

#include <functional>
#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// Body-centred cubic lattices (their Delaunay tetrahedra are all alike and well shaped), a finer one wherever
/// `edge_mm` wants it, kept off the surface by about the height of a tetrahedron and off each other.
std::vector<Point> lattice_inside(const Surface& surface, const std::function<double(const Point&)>& edge_mm);

}  // namespace vallecula::pipeline
