// Helps that a scenario may show in the operator's view: the expert's way as a blade, and where the glottis is. For the
// eye alone: nothing here is known to the engine.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>

#include <optional>
#include <vector>

#include "device/trajectory.h"
#include "engine/snapshot.h"
#include "gui/session/anatomy_motion.h"
#include "gui/views/moving_surface.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// A blade without its handle, grey and see-through, on the way a scripted hand would take; over and over.
class GhostPathLook {
 public:
  GhostPathLook(const engine::TriangleMesh& tool, device::Trajectory way);
  /// `time_s` since it was first shown; between two rounds it rests where it ends.
  void place(double time_s);
  vtkActor* actor() const { return actor_; }

 private:
  device::Trajectory way_;
  vtkSmartPointer<vtkActor> actor_;
};

/// The glottis' outline as a bright line, and faintly where something hides it. Goes along with the larynx.
class GlottisMark {
 public:
  /// Throws std::runtime_error when the package has no glottis.
  GlottisMark(const pipeline::PatientPackage& package, const AnatomyMotion& motion);
  void update(const engine::Snapshot& snapshot) { moving_->update(snapshot); }
  const std::vector<vtkSmartPointer<vtkActor>>& actors() const { return actors_; }

 private:
  vtkSmartPointer<vtkPolyData> line_;
  std::optional<MovingSurface> moving_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
};

}  // namespace vallecula::gui
