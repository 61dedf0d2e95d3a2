// A drawn surface whose points go along with jaw, larynx and lips, changed in place.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

#include "engine/snapshot.h"
#include "gui/session/anatomy_motion.h"

namespace vallecula::gui {

class MovingSurface {
 public:
  enum class Kind { solid, cut };
  /// Takes the surface (mm) as it lies at rest. A mid-sagittal cut stays in its plane.
  MovingSurface(vtkPolyData* surface, const AnatomyMotion& motion, Kind kind);
  /// A snapshot without the bodies' displacements moves nothing.
  void update(const engine::Snapshot& snapshot);

 private:
  struct Follower {
    vtkIdType point;
    engine::Vec3 rest;
    double with_jaw, with_larynx;
    std::array<int, 3> lip;  ///< points of the lips it lies between, the first -1: none
    engine::Vec3 weight;
  };
  vtkSmartPointer<vtkPolyData> surface_;
  const AnatomyMotion* motion_;
  Kind kind_;
  std::vector<Follower> followers_;
};

}  // namespace vallecula::gui
