// A drawn surface whose points go along with jaw and larynx, changed in place.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "engine/types.h"
#include "gui/session/anatomy_motion.h"

namespace vallecula::gui {

class MovingSurface {
 public:
  /// Takes the surface (mm) as it lies at rest.
  MovingSurface(vtkPolyData* surface, const AnatomyMotion& motion);
  /// `bodies`: their displacements (Snapshot::body_displacement); with too few of them nothing moves.
  void update(const std::vector<engine::Vec3>& bodies);

 private:
  struct Follower {
    vtkIdType point;
    engine::Vec3 rest;
    double with_jaw, with_larynx;
  };
  vtkSmartPointer<vtkPolyData> surface_;
  const AnatomyMotion* motion_;
  std::vector<Follower> followers_;
  std::vector<engine::Vec3> shown_;
};

}  // namespace vallecula::gui
