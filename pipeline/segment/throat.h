// The coarser structures of the throat: soft palate, larynx, oesophagus.
#pragma once

#include <optional>

#include "pipeline/segment/bone.h"
#include "pipeline/segment/epiglottis.h"

namespace vallecula::pipeline {

/// The sheet with airway on both sides that hangs behind the hard palate. Empty where it lies against tongue or wall.
/// With a `seed` (mm LPS) the sheet there, however small.
Mask find_soft_palate(const Mask& body, const Mask& lumen, const Mask& skull, const Epiglottis& epiglottis,
                      const Airway& airway, const Frame& frame, const std::optional<Vector3>& seed = {});

/// Coarse: the tissue about the lumen from the arytenoids to the first tracheal ring.
Mask find_larynx(const Mask& body, const Mask& lumen, const Mask& taken, const Airway& airway, const Frame& frame);

/// Coarse: an ellipse between trachea and spine in each slice below the larynx, and the gas in it.
Mask find_oesophagus(const Mask& body, const Mask& gas, const Mask& spine, const Mask& taken, const Airway& airway,
                     const Frame& frame);

}  // namespace vallecula::pipeline
