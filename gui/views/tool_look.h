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

/// The blade without its handle: from the tip to the heel, and half across. Millimetres.
struct BladeExtent {
  double length_mm = 0.0, half_width_mm = 0.0;
};

/// Blade, handle and bulb.
class ToolLook {
 public:
  explicit ToolLook(const engine::TriangleMesh& tool);
  void place(const engine::Pose& pose);
  const std::vector<vtkSmartPointer<vtkActor>>& actors() const { return actors_; }
  /// Where the bulb is (patient mm) and where its light goes (unit vector).
  const engine::Vec3& bulb_mm() const { return bulb_at_; }
  const engine::Vec3& beam() const { return beam_; }
  const BladeExtent& extent() const { return extent_; }
  /// A camera in the blade, as video laryngoscopes have it: just behind the lamp, in the blade's middle, on the
  /// operator's side. Tool frame, mm.
  const engine::Vec3& camera_mm() const { return camera_; }

 private:
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  engine::Vec3 bulb_ = engine::Vec3::Zero(), camera_ = engine::Vec3::Zero();  ///< tool frame, mm
  BladeExtent extent_;
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
