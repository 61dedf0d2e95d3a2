// What the mid-sagittal cut shows of the airway's course at rest: how deep is good, each centimetre below the cords,
// and the oesophagus behind.
#pragma once

#include <vtkProp3D.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "engine/tube/airway.h"

namespace vallecula::gui {

/// Share of the way from the cords to the carina in which a tube's tip lies well: its middle third (CLINICAL).
constexpr double kGoodDepthFrom = 1.0 / 3.0, kGoodDepthTo = 2.0 / 3.0;

/// Actors for the plane x = `midline_x_mm`, each on a layer `layer_mm` nearer to a viewer on the left; the oesophagus
/// on `behind_mm`. Throws std::runtime_error without cords.
std::vector<vtkSmartPointer<vtkProp3D>> airway_marks(const engine::AirwayCourse& course, double midline_x_mm,
                                                     double behind_mm, double layer_mm);

}  // namespace vallecula::gui
