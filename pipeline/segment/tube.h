// Tubes that lie in the airway or the gullet when the scan is made: found by their course, and taken out of the grey
// values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/mesh/vector3.h"
#include "pipeline/segment/airway.h"

namespace vallecula::pipeline {

struct Tube {
  bool hollow = false;        ///< air inside, seen as such; else a bright rod (a thin tube, or one full of fluid)
  double diameter_mm = 0.0;   ///< outside
  std::vector<Vector3> axis;  ///< mm, from where it enters inwards
  std::vector<double> bare;   ///< share of its outside that lies in air, at each of these
};

/// Finds tubes and writes into `hu` what would lie there without them: air in the airway, soft tissue in the gullet.
/// Where none is found `hu` stays as it is, to the bit.
std::vector<Tube> take_out_tubes(Hounsfield& hu, const Thresholds& t, const Frame& frame);

/// Where the cords hold a tracheal tube: half way between where it comes free of the larynx above and where the
/// windpipe is all around it. Nothing when no tube is held like that; then the airway is still narrowest there.
std::optional<Vector3> cords_around(const std::vector<Tube>& tubes, double scale);

/// In words for a person: how thick, from where to where.
std::string describe(const std::vector<Tube>& tubes, const Head& head, const Airway& airway, double scale);

}  // namespace vallecula::pipeline
