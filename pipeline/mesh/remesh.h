// Triangles of an even, chosen size on a given surface.
#pragma once

#include <functional>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

struct RemeshOptions {
  std::function<double(const Point&)> edge_mm;  ///< wanted edge length at a place
  int rounds = 6;
  std::function<void(double)> progress;  ///< the share of the rounds done; may be empty; what it throws ends the work
};

/// Splits, collapses and flips edges, relaxes points along the surface and puts them back onto `surface` (Botsch and
/// Kobbelt 2004). A closed manifold stays one of the same topology; the volume is that of `surface` within the chord
/// error of the edges.
Surface remeshed(const Surface& surface, const RemeshOptions& options);

}  // namespace vallecula::pipeline
