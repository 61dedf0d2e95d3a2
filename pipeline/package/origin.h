// How each structure and landmark of a patient came about, and how the patient was moved from the scan's position.
#pragma once

#include <array>
#include <string>

namespace vallecula::pipeline {

enum class Origin {
  measured,   ///< read off this scan
  inferred,   ///< continued from what was read off it, by a rule that is named
  given,      ///< by a person: a label map, a seed, a moved landmark
  from_model  ///< the shape of the shipped infant, fitted to this scan ("template")
};

struct Finding {
  Origin origin = Origin::measured;
  std::string how;  ///< the rule or the tool, in words for a person; empty for measured
};

/// "measured", "inferred", "given", "template".
const char* name_of(Origin origin);
/// The inverse; false when `text` is none of them.
bool origin_from(const std::string& text, Origin& origin);

/// A structure's or landmark's name for a person: "mandible" for "bone_mandible", "upper gum midline".
std::string words_of(std::string name);

/// From the scan's frame to the package's. The rigid part (and the scale) is `scan_to_package`; the rest moved only
/// some structures.
struct PoseChange {
  std::array<double, 16> scan_to_package{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  ///< row by row, mm LPS
  double tilt_deg = 0.0;          ///< corrected: about the front-back axis (an ear towards the shoulder)
  double turn_deg = 0.0;          ///< corrected: about the head-foot axis
  double nod_deg = 0.0;           ///< corrected: about the left-right axis
  double extension_deg = 0.0;     ///< of the head on the neck, added
  double mouth_opened_deg = 0.0;  ///< of the mandible about the condyles, added
  double scale = 1.0;             ///< of all lengths; other than 1 only when a person asked for it
  bool moved() const;             ///< is anything of this other than none?
};

}  // namespace vallecula::pipeline
