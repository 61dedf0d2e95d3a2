// The points by which the package is used: gums, vallecula, glottis, carina, hyoid, condyles, and where the operator's
// eye belongs.
#pragma once

#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

/// Fills `landmarks` (all of kLandmarks) and their `findings` from labels, airway, bones and epiglottis. Those `given`
/// stand as they are, and what depends on them follows.
void find_landmarks(Segmentation& s, const std::map<std::string, Point>& given);

}  // namespace vallecula::pipeline
