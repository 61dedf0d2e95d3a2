// A head that lies askew in the scanner: how it lies, and everything put upright or back.
#pragma once

#include "pipeline/package/origin.h"
#include "pipeline/segment/edits.h"
#include "pipeline/segment/head.h"

namespace vallecula::pipeline {

/// A rigid (or any affine) map, row by row, as PoseChange::scan_to_package.
using Transform = std::array<double, 16>;
Point moved(const Transform& m, const Point& p);
Transform inverse_of(const Transform& m);

/// How the head lies, from its symmetry (tilt and turn) and its profile (nod). What is too little to matter is none: less
/// than 2 degrees of tilt and turn together, less than 10 of nod. Up to 45 degrees of tilt, 60 of turn and 40 of nod.
/// `body` and `hu` on one grid of the scan.
PoseChange find_pose(const Hounsfield& hu, const Mask& body, const Frame& frame);

/// The body's grey values in the package's frame, on a grid around the body; all else is air. Where the patient goes on
/// below the scan, the lowest values seen go on, but for the airways, which end there: a neck cut askew stays closed.
Hounsfield put_upright(const Hounsfield& hu, const Mask& body, const Thresholds& t, const PoseChange& pose);

/// What a person said in the scan's frame, in the package's. Replaced labels are read onto `grid` of the package.
Edits put_upright(const Edits& edits, const PoseChange& pose, const Grid& grid);

/// Labels read onto another grid: each voxel gets the label that has most of the weight of the eight about its centre
/// (so that borders keep their place to a fraction of a voxel). Outside `labels` is background.
Labels read_onto(const Grid& grid, const Transform& grid_to_labels, const Labels& labels);

}  // namespace vallecula::pipeline
