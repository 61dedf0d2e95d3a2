// The head seen from the side: how far it nods, by the shipped infant's profile.
#pragma once

#include <algorithm>

#include "pipeline/segment/head.h"

namespace vallecula::pipeline {

/// Air 0, soft tissue 1, bone up to 1.8 and metal no more: what heads are compared by.
inline double grey_of(double hu) { return std::clamp(0.001 * hu + 1.0, 0.0, 1.8); }

struct Nod {
  double degrees = 0.0;  ///< about x, right handed: positive brings the chin to the chest
  double misfit = 1.0;   ///< mean square difference of the greys: an infant's below 0.03, an adult's about 0.08
};

/// How far the head is nodded against the manikin's design (a term infant in the sniffing position). Tilt and turn are
/// taken away by `straight_to_scan`; `middle` is the head's middle on its plane of symmetry, in that straight frame.
Nod nod_of(const Hounsfield& hu, const Mask& body, const std::array<double, 16>& straight_to_scan,
           const std::array<double, 3>& middle, const Frame& frame);

}  // namespace vallecula::pipeline
