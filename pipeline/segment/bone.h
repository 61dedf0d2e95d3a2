// Skull, mandible, spine and hyoid.
#pragma once

#include <optional>

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

/// Points inside, by a person, mm LPS.
struct BoneSeeds {
  std::optional<Vector3> skull;
  std::optional<Vector3> mandible;
  std::optional<Vector3> spine;
  std::optional<Vector3> hyoid;
};

/// What is denser than `t.bone`. The mandible is what comes free of the skull in front of the pharynx as the threshold
/// rises (its joints and touching teeth join the two at the lower one); the spine is what lies behind the pharynx below
/// the skull base. Voxels between are shared by flooding. With
/// a seed the mandible is the piece that holds it, whatever its shape, and when it never comes free of the skull what
/// is flooded from there. Throws std::runtime_error when a seed is not in dense tissue.
Bones find_bones(const Hounsfield& hu, const Thresholds& t, const Frame& frame, const Head& head, const Airway& airway,
                 const BoneSeeds& seeds = {});

}  // namespace vallecula::pipeline
