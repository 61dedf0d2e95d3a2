// What the mid-sagittal cut shows of the airway's course at rest: how deep is good, each centimetre below the cords,
// and the oesophagus behind.
#pragma once

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkProp3D.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <vector>

#include "engine/tube/airway.h"

namespace vallecula::gui {

/// Share of the way from the cords to the carina in which a tube's tip lies well: its middle third (CLINICAL).
constexpr double kGoodDepthFrom = 1.0 / 3.0, kGoodDepthTo = 2.0 / 3.0;

struct AirwayMarks {
  std::vector<vtkSmartPointer<vtkProp3D>> props;  ///< all of them, to be drawn
  vtkSmartPointer<vtkBillboardTextActor3D> good_depth;
  std::vector<vtkSmartPointer<vtkBillboardTextActor3D>> centimetres;  ///< 1, 2, 3 and on

  vtkSmartPointer<vtkActor> leader;  ///< from the good stretch to its word
  Eigen::Vector2d good_front_mm{0.0, 0.0},
      good_out{0.0, 0.0};  ///< y and z of the stretch's front wall, and away from it

  /// Their type at a text scale (1: as it is first), and as many of the numbers as have room one below another where a
  /// centimetre is so many pixels. The good stretch's word stands beside the airway, at the same pixels from it however
  /// small the picture is, and not at all where the picture has less than its width of `before_px` in front of the
  /// airway.
  void set_type(double text_scale, double px_per_cm, double before_px = 1e9) const;
};

/// For the plane x = `midline_x_mm`, each on a layer `layer_mm` nearer to a viewer on the left; the oesophagus on
/// `behind_mm`. Throws std::runtime_error without cords.
AirwayMarks airway_marks(const engine::AirwayCourse& course, double midline_x_mm, double behind_mm, double layer_mm);

}  // namespace vallecula::gui
