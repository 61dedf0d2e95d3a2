// The laryngoscope as it is drawn: the engine's tool, with a lamp and (where it is a blade alone) a handle that are for the
// eye only.
#pragma once

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "engine/types.h"

namespace vallecula::gui {

/// Tool frame to patient, millimetres.
vtkSmartPointer<vtkMatrix4x4> tool_matrix(const engine::Pose& pose);

/// The blade of the scene in millimetres, with normals that keep its edges sharp.
vtkSmartPointer<vtkPolyData> blade_surface(const engine::TriangleMesh& tool);
/// A handle on the blade's heel along the tool's +z; empty for a tool that has one of its own.
vtkSmartPointer<vtkPolyData> handle_surface(const engine::TriangleMesh& tool);

/// Blade, handle and bulb.
class ToolLook {
 public:
  explicit ToolLook(const engine::TriangleMesh& tool);
  void place(const engine::Pose& pose);
  const std::vector<vtkSmartPointer<vtkActor>>& actors() const { return actors_; }
  /// Where the bulb is (patient mm) and where its light goes (unit vector).
  const engine::Vec3& bulb_mm() const { return bulb_at_; }
  const engine::Vec3& beam() const { return beam_; }

 private:
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  engine::Vec3 bulb_ = engine::Vec3::Zero();  ///< tool frame, mm
  engine::Vec3 bulb_at_ = engine::Vec3(0, 0, 1e4), beam_ = engine::Vec3(0, 0, -1);
};

/// The device pose, grey and see-through, shown only where it parts from the proxy.
class GhostLook {
 public:
  explicit GhostLook(const engine::TriangleMesh& tool);
  /// True when shown: the two part by more than half a millimetre (tip) or three degrees.
  bool place(const engine::Pose& device, const engine::Pose& proxy);
  const std::vector<vtkSmartPointer<vtkActor>>& actors() const { return actors_; }

 private:
  std::vector<vtkSmartPointer<vtkActor>> actors_;
};

}  // namespace vallecula::gui
