// The head as a solid: what is the patient, what is air inside and air outside.
#pragma once

#include <string>
#include <vector>

#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {

/// Thresholds between the tissues, HU, from the series' own histogram.
struct Thresholds {
  double air =
      -480.0;  ///< half way between air and soft tissue: where the border of a shape lies after the scanner's blur
  double fat = -25.0;  ///< half way between fat and soft tissue
  double bone = 250.0;
  double soft = 40.0;  ///< the commonest soft-tissue value
  double noise = 0.0;  ///< standard deviation in soft tissue
};
Thresholds thresholds_of(const Hounsfield& hu);

/// Tissue that belongs to the patient: within reach of a core that is too thick to be a mask, a wire or a sheet. Couch
/// and head-rest stay out where they do not touch. Throws std::runtime_error when nothing the size of a head is there.
Mask find_body(const Hounsfield& hu, const Thresholds& t);

/// Size and middle of the head, from the bones of the skull.
struct Frame {
  double scale = 1.0;  ///< breadth of the skull over 83.6 mm, that of the term manikin: lengths below are given for the
                       ///< term newborn
  double mid_x = 0.0;  ///< mm, plane of symmetry
  double skull_top = 0.0;  ///< mm, z of the highest bone
};
Frame frame_of(const Hounsfield& hu, const Mask& body, const Thresholds& t);

/// The border of the mouth in one sagittal slice: from the edge of the upper to that of the lower lip.
struct LipGap {
  int x = 0;                      ///< slice
  std::array<double, 2> upper{};  ///< y, z, mm
  std::array<double, 2> lower{};
};

struct Head {
  Mask body;                 ///< the patient's tissue
  Mask inside;               ///< body and all air inside it: behind the lips' and nostrils' planes
  std::vector<LipGap> lips;  ///< empty when the mouth is closed
};

/// Closes the mouth from lip edge to lip edge, and the nostrils by a ball that does not fit through them.
Head find_head(const Hounsfield& hu, const Mask& body, const Thresholds& t, const Frame& frame);

}  // namespace vallecula::pipeline
