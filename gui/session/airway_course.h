// The tube's way in a patient: cuts of the airway's surface from the laryngeal inlet to the bronchi, and the oesophagus
// behind it, which no CT shows open.
#pragma once

#include <string>
#include <vector>

#include "engine/tube/airway.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

struct PatientAirway {
  engine::AirwayCourse course;    ///< m
  double glottis_length_m = 0.0;  ///< from the front commissure to the hind wall
  double cricoid_area_m2 = 0.0;   ///< of the narrowest cut below the cords
  std::vector<std::string> assumed;  ///< what the imaging does not show and was continued or assumed, for a person
};

/// Walls: halves of the ellipse that has a cut's area. Between the cords and the cricoid every cut is wider than the
/// cricoid's: what is imaged there is the slit of resting cords, which gives as they do. Throws std::runtime_error when
/// the package has no airway where its landmarks say.
PatientAirway airway_of(const pipeline::PatientPackage& package);

}  // namespace vallecula::gui
