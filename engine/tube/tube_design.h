// Uncuffed tracheal tubes as they are made, the stylet within, and the rod they make in the hand.
#pragma once

#include <string>

#include "engine/tube/rod.h"

namespace vallecula::engine {

/// Dimensions in m. Frame at the tip as for rods: +x to the connector, +z to the concave side.
struct TubeDesign {
  double inner_diameter = 0.0035;
  double outer_diameter = 0.0049;
  double length = 0.180;              ///< tip to connector
  double cord_mark_from_tip = 0.028;  ///< upper edge of the black line that stands at the cords
  double cord_mark_width = 0.002;
  int first_cm_mark = 5;              ///< numbered from the tip, one a centimetre, to the connector
  double bend_radius = 0.140;         ///< Magill's curve, of the undeformed axis
  double bevel_rad = 0.654;           ///< between the opening's plane and the axis
  Vec3 bevel_faces = -Vec3::UnitY();  ///< the opening's side: the patient's left in use
  double young_pa = 30e6;
  double poisson = 0.45;
  double density_kg_m3 = 1250.0;
};

/// By inner diameter, "2.5", "3.0", "3.5" or "4.0" mm; throws std::invalid_argument that names what there is otherwise.
TubeDesign tube_design(const std::string& inner_diameter_mm);

/// A suction catheter of this outer diameter, m, as long as a tube: a soft, nearly straight tube cut square. What is
/// inside it, two thirds of the outside, is a usual catheter's (8 F: 1.8 of 2.67 mm; assumed).
TubeDesign suction_catheter(double outer_diameter);

/// A malleable metal rod within the tube, straight to its bend ("straight to cuff") and bent towards the tube's concave
/// side like a hockey stick. It keeps its shape (it does not yield) and sticks to the tube: simplifications.
struct Stylet {
  double diameter = 0.0012;  ///< of the metal, m (assumed; a 6 F stylet is 2.0 mm with its coat)
  double young_pa = 69e9;    ///< aluminium; copper 120e9
  double poisson = 0.33;
  double density_kg_m3 = 2700.0;
  double short_of_tip = 0.005;   ///< its end stays within the tube by this, m (assumed: it must not stand out)
  double bend_from_tip = 0.025;  ///< middle of the bend, from the tube's tip, m (assumed)
  double bend_length = 0.008;    ///< along the axis, m (assumed)
  double bend_rad = 0.611;       ///< 35 degrees, usual for straight-to-cuff stylets (assumed for infants)
};

/// The tube from its tip to the hand's grip, `grip_from_tip` m along it. Stiffness of both add; the natural curve is
/// where their moments balance. Throws std::invalid_argument naming what does not make a tube, such as no wall, a grip
/// beyond its ends or a stylet that does not fit the lumen.
RodDescription tube_rod(const TubeDesign& tube, const Stylet* stylet, double grip_from_tip);

/// Where a hand holds a tube: 60 mm short of the connector (assumed): held farther back it bends before it passes a cricoid.
double usual_grip_from_tip(const TubeDesign& tube);

}  // namespace vallecula::engine
