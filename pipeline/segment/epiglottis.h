// The epiglottis: a thin leaf that stands in the airway above the glottis, and the part of it that is held in the front
// wall.
#pragma once

#include <optional>

#include "pipeline/segment/airway.h"

namespace vallecula::pipeline {

struct Epiglottis {
  Mask mask;  ///< empty when no leaf was found
  bool seen = false;
  Vector3 tip{};
  Vector3 vallecula{};  ///< the floor of the pit between tongue and leaf
  double thickness_mm = 0.0;
};

/// All masks on one grid that holds the throat. The leaf is what a ball can bridge between airway and airway (both its
/// faces are free); the highest such sheet in front of and above the glottis is taken. Its petiole is carried down the
/// front wall at the leaf's thickness, from the vallecula's floor to 2 mm (term) above the front commissure, where the
/// ligament holds it.
/// With a `seed` (mm LPS) it is the sheet nearest to it, within 3 mm (term).
Epiglottis find_epiglottis(const Mask& body, const Mask& lumen, const Airway& airway, const Frame& frame,
                           const std::optional<Vector3>& seed = {});

/// Tip, vallecula and thickness of a leaf that was given, on the grid of `lumen`.
Epiglottis measured_epiglottis(const Mask& leaf, const Mask& lumen, const Frame& frame);

}  // namespace vallecula::pipeline
