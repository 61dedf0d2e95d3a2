// How light falls on living tissue: scattered red under the skin, mirrored by what is wet. Written into VTK's shader in
// place of its general lights, which cost four times as much per pixel and know neither.
#pragma once

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPolyDataMapper.h>

#include "engine/types.h"

namespace vallecula::gui {

/// Name of the point array (float, 0 dry .. 1 wet) that surfaces to be shaded carry.
constexpr const char* kWetness = "Wetness";

/// Draws the mapper's surface, which carries normals, RGB colours and kWetness, as tissue. `glow`: light of its own,
/// for what must be found even in the dark.
void shade_as_tissue(vtkActor* actor, vtkPolyDataMapper* mapper, double glow = 0.0);

/// The blade's lamp for an actor shaded so: bulb and beam in patient mm, as `camera` sees them; strength 0 is off.
void set_lamp(vtkActor* actor, vtkCamera* camera, const engine::Vec3& bulb_mm, const engine::Vec3& beam,
              double strength);

}  // namespace vallecula::gui
