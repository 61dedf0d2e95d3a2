// Grey values and labels carried between the scan's frame and the package's.
#pragma once

#include "pipeline/package/origin.h"
#include "pipeline/package/patient_package.h"
#include "pipeline/segment/head.h"

namespace vallecula::pipeline {

/// A rigid (or any affine) map, row by row, as PoseChange::scan_to_package.
using Transform = std::array<double, 16>;
Point moved(const Transform& m, const Point& p);
Transform inverse_of(const Transform& m);

/// The body's grey values in the package's frame, on a grid around the body; all else is air. Where the patient goes on
/// below the scan, the lowest values seen go on, but for the airways, which end there: a neck cut askew stays closed.
Hounsfield put_upright(const Hounsfield& hu, const Mask& body, const Thresholds& t, const PoseChange& pose);

/// Labels read onto another grid: each voxel gets the label that has most of the weight of the eight about its centre
/// (so that borders keep their place to a fraction of a voxel). Outside `labels` is background.
Labels read_onto(const Grid& grid, const Transform& grid_to_labels, const Labels& labels);
/// The same, where the labels' own grey values say on which side of a border of air or bone a point lies.
Labels read_onto(const Grid& grid, const Transform& grid_to_labels, const Labels& labels, const Hounsfield& hu,
                 const Thresholds& t);

}  // namespace vallecula::pipeline
