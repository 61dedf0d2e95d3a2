// What bounds the mouth when no air is in it: the roof, the arches of the jaws, the floor, the throat behind.
#pragma once

#include "pipeline/segment/bone.h"
#include "pipeline/segment/epiglottis.h"

namespace vallecula::pipeline {

/// The hard palate in the middle, mm LPS.
struct Roof {
  bool seen = false;
  Vector3 front{};  ///< lower edge of the upper jaw's foremost bone
  Vector3 back{};   ///< lower edge of the hindmost (the posterior nasal spine)
};

/// Follows the underside of the bone over the mouth forwards and backwards from above the tongue. `skull` and
/// `mandible` lie on one grid.
Roof find_roof(const Mask& skull, const Mask& mandible, const Frame& frame);

struct MouthBounds {
  bool found = false;    ///< false: no jaw, no roof or no pharynx to be bounded by
  Mask tongue;           ///< all that these bounds leave to a tongue that fills the mouth
  Mask soft_palate;      ///< a sheet of usual thickness and length in front of the airway behind the roof
  double crest_z = 0.0;  ///< ridge of the lower gum's bone in the middle
};

/// By rule, from bones, airway and epiglottis alone: within the arches of both jaws, under the roof, above a floor from the jaw's
/// inner middle to the hyoid that rises to the sides as the mylohyoid muscle does, in front of the pharynx.
MouthBounds bound_mouth(const Mask& body, const Mask& lumen, const Mask& skull, const Mask& mandible, const Mask& hyoid,
                        const Airway& airway, const Epiglottis& epiglottis, const Frame& frame);

}  // namespace vallecula::pipeline
