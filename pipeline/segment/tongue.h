// The tongue: soft tissue between air, bone and the fat planes that part it from the muscles below.
#pragma once

#include <optional>

#include "pipeline/segment/bone.h"
#include "pipeline/segment/epiglottis.h"

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
};

/// Two parties compete for the tissue, each from what is surely its own: the tongue from below its back and before the
/// pharynx, everything else from bone, skin, palate, back wall and larynx. Travel is dear across ridges (the dark fat
/// plane, the bright hyoid in it), so they meet there wherever there is one, else half way, and a gap in the plane lets
/// little through. Empty when the mouth is closed and no seed was given.
Mask find_tongue(const TongueSearch& search);

}  // namespace vallecula::pipeline
