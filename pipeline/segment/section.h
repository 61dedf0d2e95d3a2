// Cuts through the airway across its own direction.
#pragma once

#include <vector>

#include "pipeline/mesh/vector3.h"
#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {

struct Section {
  bool found = false;
  Vector3 centre{};  ///< centroid of the lumen in the plane, mm
  Vector3 normal{};
  double area_mm2 = 0.0;
};

/// The part of {field > 0} around `at` in the plane through it, sampled every `step_mm`; not found when `at` is outside
/// or the part reaches beyond `reach_mm`.
Section section_of(const Volume<float>& field, const Vector3& at, const Vector3& normal, double step_mm,
                   double reach_mm);

/// The outline of that part as seen from its centroid: `corners` points in order, anticlockwise about the normal, each
/// where the field first passes through zero along its ray.
std::vector<Vector3> outline_of(const Volume<float>& field, const Section& section, int corners, double reach_mm);

/// Two unit vectors across `normal`; the first has no z part when that is possible.
std::array<Vector3, 2> across(const Vector3& normal);

}  // namespace vallecula::pipeline
