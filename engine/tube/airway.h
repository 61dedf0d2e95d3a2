// The way of a tube past the laryngeal inlet and past the mouth of the oesophagus: closed cuts across it, one after the
// other, from a patient. Above them the tube meets surfaces; from the inlet on it is inside, and stays so until it is
// drawn back.
#pragma once

#include <array>
#include <vector>

#include "engine/types.h"

namespace vallecula::engine {

/// Where a cut lies: decides how its wall yields and whose load it is.
enum class AirwayPart : std::uint8_t { vestibule, cords, subglottis, cricoid, trachea, main_bronchus, oesophagus };

/// One cut, in the world at rest. `front` is along x left.
struct AirwayRing {
  Vec3 centre = Vec3::Zero();   ///< m
  Vec3 along = -Vec3::UnitZ();  ///< unit, to the lungs (or to the stomach)
  Vec3 left = Vec3::UnitX();    ///< unit, the patient's
  double to_left_m = 0.003, to_right_m = 0.003, to_front_m = 0.003, to_back_m = 0.003;  ///< centre to mucosa; above 0
  AirwayPart part = AirwayPart::trachea;
  double larynx_share = 0.0;  ///< of the larynx body's way (AirwayCourse::larynx_body), 0..1
};

/// Each chain begins at its entrance. Cuts follow each other by 0.5 to 4 mm.
struct AirwayCourse {
  std::vector<AirwayRing> airway;  ///< laryngeal inlet (below the arytenoids' tips) to the carina; has one `cords`
  std::array<std::vector<AirwayRing>, 2> bronchi;  ///< right, left; from the carina
  std::vector<AirwayRing> oesophagus;              ///< from its mouth behind the larynx
  int larynx_body = -1;                            ///< index into SoftBodyDescription::bodies; -1: nothing moves
};

/// From the cut at the cords to the last of the airway, the carina, along the cuts' centres, m; 0 where there are no
/// cords.
inline double cords_to_carina_m(const AirwayCourse& course) {
  double way = 0.0;
  const AirwayRing* before = nullptr;  // none yet: above the cords
  for (const AirwayRing& ring : course.airway) {
    if (before != nullptr) way += (ring.centre - before->centre).norm();
    if (before != nullptr || ring.part == AirwayPart::cords) before = &ring;
  }
  return way;
}

}  // namespace vallecula::engine
