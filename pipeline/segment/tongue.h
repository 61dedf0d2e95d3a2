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

/// Watershed on the grey values from a seed under the back of the tongue against everything that is surely not tongue
/// (next to bone, skin, palate, back wall, larynx): the two meet on the dark ridge of the fat plane, wherever there is
/// one, else half way. Without `seed` the seed is the tissue under the air of the open mouth, in the middle; empty when
/// the mouth is closed and no seed was given.
Mask find_tongue(const TongueSearch& search);

}  // namespace vallecula::pipeline
