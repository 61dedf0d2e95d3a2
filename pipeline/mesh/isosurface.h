// The closed surface on which a field passes through zero.
#pragma once

#include <array>
#include <vector>

#include "pipeline/package/patient_package.h"
#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// `field` in about mm, positive inside. What reaches the grid's border is closed there. Triangles look outwards.
/// Crossings nearer than 3 % of an edge to a sample are moved away from it, so that no triangle is degenerate.
Surface isosurface(const Volume<float>& field);

/// The same on planes of any distance: `axes[a]` are the rising coordinates of the samples, mm; x runs fastest in
/// `values`.
Surface isosurface(const std::array<std::vector<double>, 3>& axes, const std::vector<float>& values);

/// Coordinates from `low` to `high`: `fine` apart between `fine_low` and `fine_high`, growing by a quarter a step to
/// `coarse` outside.
std::vector<double> graded_axis(double low, double high, double fine_low, double fine_high, double fine, double coarse);

}  // namespace vallecula::pipeline
