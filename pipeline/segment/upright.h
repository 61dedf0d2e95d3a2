// A head that lies askew in the scanner: how it lies.
#pragma once

#include "pipeline/package/origin.h"
#include "pipeline/segment/edits.h"
#include "pipeline/segment/head.h"
#include "pipeline/segment/reslice.h"

namespace vallecula::pipeline {

/// How the head lies, from its symmetry (tilt and turn) and its profile (nod). What is too little to matter is none:
/// less than 2 degrees of tilt and turn together, less than 6 of nod (25 in a head that is not like an infant's). Up to
/// 45 degrees of tilt, 60 of turn and 50 of nod. `body` and `hu` on one grid of the scan.
PoseChange find_pose(const Hounsfield& hu, const Mask& body, const Frame& frame);

/// What a person said in the scan's frame, in the package's. Replaced labels are read onto `grid` of the package.
Edits put_upright(const Edits& edits, const PoseChange& pose, const Grid& grid);

}  // namespace vallecula::pipeline
