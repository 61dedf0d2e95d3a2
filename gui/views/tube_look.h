// The tracheal tube and the suction catheter as they are drawn: clear PVC of the tube's real diameters with its print,
// the stylet seen through its wall, a connector at the end.
#pragma once

#include <vtkActor.h>

#include <QImage>
#include <vector>

#include "engine/tube/intubation.h"
#include "gui/views/swept_surface.h"

namespace vallecula::gui {

/// What is printed on the tube, unrolled: along it to the right, once around it downwards; clear elsewhere. Black: the
/// cord mark, a ring each centimetre from `first_cm_mark` on, its number, the inner diameter; blue: the radio-opaque
/// line on the convex side.
QImage tube_print(const engine::TubeDesign& tube);

class TubeLook {
 public:
  explicit TubeLook(const engine::IntubationDescription& intubation);
  /// Shows what the second hand holds where the snapshot has it, nothing before.
  void update(const engine::Snapshot& snapshot);
  /// Those that hide what is behind them first, the see-through ones last.
  const std::vector<vtkSmartPointer<vtkActor>>& actors() const { return actors_; }
  /// True while the last snapshot's second hand had the catheter.
  bool catheter_shown() const { return catheter_shown_; }

 private:
  struct Part {
    SweptSurface surface;
    vtkSmartPointer<vtkActor> actor;
    bool of_catheter, of_stylet;
  };
  vtkActor* add(SweptSurface surface, bool of_catheter, bool of_stylet);
  void add_tube(const engine::TubeDesign& tube);
  void add_stylet(const engine::TubeDesign& tube, const engine::Stylet& stylet);
  void add_catheter(double outer_m);

  std::vector<Part> parts_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  bool catheter_shown_ = false;
};

}  // namespace vallecula::gui
