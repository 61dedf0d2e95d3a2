// The tongue: soft tissue between air, bone and the fat planes that part it from the muscles below.
#pragma once

#include <optional>

#include "pipeline/segment/bone.h"
#include "pipeline/segment/epiglottis.h"
#include "pipeline/segment/mouth_bounds.h"

namespace vallecula::pipeline {

struct TongueSearch {
  const Hounsfield& hu;  ///< all on one grid that holds mouth and throat
  const Mask& body;
  const Mask& inside;
  const Mask& lumen;
  const Mask& skull;
  const Mask& mandible;
  const Mask& hyoid;
  const Epiglottis& epiglottis;
  const Airway& airway;
  const Thresholds& t;
  const Frame& frame;
  std::optional<Vector3> seed;  ///< given by a person, mm LPS
  bool lips_closed = false;
};

/// Two parties compete for the tissue, each from what is surely its own: the tongue from below its back and before the
/// pharynx, everything else from bone, skin, palate, back wall and larynx. Travel is dear across ridges (the dark fat
/// plane, the bright hyoid in it), so they meet there wherever there is one, else half way, and a gap in the plane lets
/// little through. In a closed mouth, or where no air lies over the back, the tongue's own is the inside of what the mouth's
/// bounds leave it (bound_mouth) and everything else begins outside of them. A seed adds to the tongue's own. Empty when
/// there is none of these.
struct Tongue {
  Mask mask;
  bool mouth_closed = false;  ///< held by bounds, not by a border that was seen all round
};
Tongue find_tongue(const TongueSearch& search, const MouthBounds& bounds);

}  // namespace vallecula::pipeline
