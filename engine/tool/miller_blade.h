// The laryngoscope's blade: a straight Miller blade as a closed surface in the tool frame.
#pragma once

#include <string>

#include "engine/types.h"

namespace vallecula::engine {

/// Dimensions in m. Overall lengths of Miller 00, 0 and 1 are 65, 75 and 102 mm (CLINICAL.md; assumed there), of 2 and 3,
/// for children and grown-ups, 155 and 195 mm (makers' catalogues; assumed); widths, thickness and web are assumed from
/// common blades.
struct MillerBlade {
  double length = 0.075;         ///< tip to heel, along the blade
  double width = 0.0105;         ///< of the spatula
  double thickness = 0.0014;
  double web_height = 0.0035;    ///< of the web on the edge at the patient's left, away from the tongue; grows from the tip
  double tip_lift = 0.0015;      ///< how far the last centimetre bends towards the tongue side
};

/// "miller-00", "miller-0", "miller-1", "miller-2" or "miller-3"; throws std::invalid_argument that names what there is otherwise.
MillerBlade miller_blade(const std::string& name);

/// Closed surface in the tool frame: a spatula along +x from the rounded tip at the origin, its tongue side towards +z;
/// the web hangs towards -z from the edge at -y, the patient's left in use, and holds the tongue out of the view.
/// Throws std::invalid_argument for dimensions that do not make a blade.
TriangleMesh blade_surface(const MillerBlade& blade);

}  // namespace vallecula::engine
