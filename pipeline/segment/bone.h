// Skull, mandible, spine and hyoid.
#pragma once

#include "pipeline/segment/airway.h"

namespace vallecula::pipeline {

struct Bones {
  Mask skull;
  Mask mandible;
  Mask spine;
  Mask hyoid;                  ///< may be empty: cartilage in the smallest infants
  bool mandible_free = false;  ///< it came free of the skull; else it is empty
  bool hyoid_seen = false;
};

/// What is denser than `t.bone`. The mandible is what comes free of the skull in front of the pharynx as the threshold
/// rises (its joints and touching teeth join the two at the lower one); the spine is what lies behind the pharynx below
/// the skull base. Voxels between are shared by flooding.
Bones find_bones(const Hounsfield& hu, const Thresholds& t, const Frame& frame, const Head& head, const Airway& airway);

}  // namespace vallecula::pipeline
