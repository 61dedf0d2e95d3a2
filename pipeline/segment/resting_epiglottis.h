// The epiglottis of a closed mouth: its leaf lies against the tongue, with no air before it or only pockets.
#pragma once

#include "pipeline/segment/epiglottis.h"

namespace vallecula::pipeline {

/// A leaf of usual thickness along the front wall of the airway, from above the front commissure to 10 mm (term) above
/// the vallecula's floor: the lowest pocket of gas before that wall near the hyoid, or, without one, the hyoid's own
/// height. Not seen where the wall cannot be followed. All masks on one grid.
Epiglottis rest_epiglottis(const Hounsfield& hu, const Mask& body, const Mask& lumen, const Mask& hyoid,
                           const Airway& airway, const Frame& frame);

}  // namespace vallecula::pipeline
