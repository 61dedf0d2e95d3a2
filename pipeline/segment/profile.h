// The head seen from the side: how far it nods, by the shipped infant's profile.
#pragma once

#include <algorithm>

#include "pipeline/segment/head.h"

namespace vallecula::pipeline {

/// Air 0, soft tissue 1, bone up to 1.8 and metal no more: what heads are compared by.
inline double grey_of(double hu) { return std::clamp(0.001 * hu + 1.0, 0.0, 1.8); }

/// Degrees about x by which the head is nodded against the term infant of the manikin's design, whose trachea runs 17
/// degrees to the back (right handed: positive lifts the back of the head and drops the chin... see PoseChange).
/// Tilt and turn are taken away by `straight_to_scan`; `middle` is the head's middle on its plane of symmetry, in that
/// straight frame. 0 when the profile fits nowhere markedly better.
double nod_of(const Hounsfield& hu, const Mask& body, const std::array<double, 16>& straight_to_scan,
              const std::array<double, 3>& middle, const Frame& frame);

}  // namespace vallecula::pipeline
