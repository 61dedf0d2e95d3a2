// How light falls on living tissue: scattered red under the skin, mirrored by what is wet. Written into VTK's shader in
// place of its general lights, which cost four times as much per pixel and know neither.
#pragma once

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPolyDataMapper.h>

#include <array>

#include "engine/types.h"

namespace vallecula::gui {

/// Name of the point array that surfaces to be shaded carry: two floats, 0 dry .. 1 wet, and how open to the light
/// around it the point is (0 buried .. 1).
constexpr const char* kWetness = "Wetness";

/// The light of one moment. Patient mm, LPS.
struct Lighting {
  engine::Vec3 bulb = engine::Vec3(0, 0, 1e4), beam = -engine::Vec3::UnitZ();  ///< of the blade's lamp
  double lamp = 0.0;  ///< its strength; 0 is off
  engine::Vec3 lips = engine::Vec3::Zero(), inward = -engine::Vec3::UnitZ();  ///< where the mouth begins and goes to
  double room_inside = 1.0;  ///< share of the room's light that is left in the depth of the mouth
  /// What throws shadows: capsules of radius [3] from each point to the next; 0: none begins there.
  static constexpr int kSolids = 8;
  std::array<std::array<float, 4>, kSolids> solids{};
  int lamp_solids_from = 0;  ///< those before stand in the room's light alone: the lamp is fastened to them
  bool shadows = true;
  bool rim = true;  ///< the brighter edge of what is wet
};

/// Which sides are drawn: of closed surfaces seen from outside half is never seen; a camera that may come to lie in the
/// tissue sees the light that has gone through its other side.
enum class Sides { front, both };

/// Draws the mapper's surface, which carries normals, RGB colours and kWetness, as tissue. `glow`: light of its own,
/// for what must be found even in the dark.
void shade_as_tissue(vtkActor* actor, vtkPolyDataMapper* mapper, double glow = 0.0, Sides sides = Sides::front);
void set_glow(vtkActor* actor, double glow);

/// Lights an actor shaded so, as `camera` sees it: to be called whenever light or camera has moved.
void set_lighting(vtkActor* actor, vtkCamera* camera, const Lighting& lighting);

}  // namespace vallecula::gui
