// The second half of the procedure, as the scene steps it: what the second hand holds, the airway it goes into, the
// cords, the secretions and the infant. A scene without it is laryngoscopy alone.
#pragma once

#include <optional>

#include "engine/physiology/infant.h"
#include "engine/tube/airway.h"
#include "engine/tube/glottis.h"
#include "engine/tube/tube_design.h"

namespace vallecula::engine {

constexpr double kMostPress = 10.0;  // N

/// Fluid on the back wall of the throat of a child that lies on its back: what lies below its level is not seen.
struct Secretions {
  double volume_m3 = 0.0;     ///< at the start; 1 ml is 1e-6
  double area_m2 = 250e-6;    ///< of the throat's floor that it spreads over (assumed)
  Vec3 floor = Vec3::Zero();  ///< deepest point, m
  Vec3 up = -Vec3::UnitY();   ///< against gravity, unit
};

struct IntubationDescription {
  TubeDesign tube;
  std::optional<Stylet> stylet;
  double catheter_outer_m = 0.00267;  ///< suction catheter, 8 F; 0: none at hand
  AirwayCourse course;
  Glottis glottis;
  InfantDescription infant;
  bool breathes = false;  ///< the infant, by itself, all through the trial; a premedicated one cannot
  /// Along x from `mouth` to a corner: what crosses the mouth's front farther aside came through the cheek and is not
  /// in the mouth; 0: not known, no bound.
  float mouth_half_width_m = 0.0f;
  Secretions secretions;
  Vec3 mouth = Vec3::Zero();             ///< a point of the mouth's front plane, m
  Vec3 mouth_inward = -Vec3::UnitZ();    ///< its unit normal, into the mouth
  Vec3 mouth_axis = -Vec3::UnitZ();      ///< from `mouth` back to the vallecula, unit
  double mouth_radius_m = 0.0;           ///< about that axis: what lies farther aside is not in the mouth; 0: no bound
  double mouth_gap_m = 0.0;              ///< between the gums at rest; 0: not known
  double lips_before_gums_m = 0.0;       ///< the lips, before that plane: where the tube's mark is read; 0: not known
  double press_n = 0.0;                  ///< of the assistant on the larynx, up to kMostPress
  Vec3 press_direction = Vec3::UnitY();  ///< unit
  double device_limit_n = 7.9;           ///< of the second hand's device
};

}  // namespace vallecula::engine
