// How far a patient is to be moved into the position of an intubation: jaw and neck, as rigid turns.
#pragma once

#include <string>

#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

/// A turn about an axis from right to left and a shift. Right-handed about x: positive drops what lies in front of the
/// pivot and carries back what lies below it.
struct Turn {
  Vector3 pivot{};
  double angle_rad = 0.0;
  Vector3 shift{};
  Vector3 operator()(const Vector3& p) const;
  Vector3 back(const Vector3& p) const;
};

struct Aim {
  Turn jaw;             ///< of the mandible about the condyles, which slide forwards and down with it
  Turn neck;            ///< of the neck under the head: the same as extending the head on the neck
  bool part = false;    ///< tongue and palate, and the lips, lie against each other and are parted
  double gap_mm = 0.0;  ///< between the gums, when the jaw is moved
  bool any() const { return part || jaw.angle_rad != 0.0 || neck.angle_rad != 0.0; }
};

/// Of the hard palate's plane against the trachea, degrees: 180 would be one line. Negative when it cannot be told.
double neck_angle_deg(const Segmentation& s);

/// What is missing to the shipped infant's position. Nothing when the mouth is open and the head extended.
Aim aim_of(const Segmentation& s);

}  // namespace vallecula::pipeline
