// Smooth fields whose zero is the border of a structure: what the surfaces are cut from.
#pragma once

#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

/// Where a border lies against air or bone it comes from the grey values, so it is finer than the voxels and smooth
/// without smoothing; where tissue meets tissue it comes from the labels, as the smoothed surface half way between the
/// two (that of a partition continued through the air, so that it does not shrink thin leaves). All positive inside, in
/// about mm, on the segmentation's cropped grid or its throat.
struct AnatomyFields {
  Volume<float> solid;  ///< the patient's tissue against airway and outer air; gas that is not airway counts as tissue
  Volume<float> soft;   ///< on the throat: tongue and epiglottis against all other tissue
  Volume<float> airway_side;  ///< on the airway's box: airway against outer air (the lips' and nostrils' planes)
};

AnatomyFields fields_of(const Segmentation& s);

/// One bone (of the structure `label`) against everything else, on the box of `bone` within the cropped grid.
Volume<float> bone_field(const Segmentation& s, std::uint8_t label, const Mask& bone, const Mask& other_bone);

}  // namespace vallecula::pipeline
