// The live mid-sagittal cut, as in textbooks: anterior to the left, the head up. Parallel projection, flat colours.
#pragma once

#include <vtkActor.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <memory>
#include <vector>

#include "engine/snapshot.h"
#include "gui/views/gl_view.h"
#include "gui/views/patient_look.h"

namespace vallecula::gui {

class SagittalView : public GlView {
  Q_OBJECT
 public:
  explicit SagittalView(QWidget* parent = nullptr);
  void show_patient(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool);
  /// Moves tongue, blade and sight line to the snapshot; `sight_percent`: from where on the glottis counts as in sight.
  void update_from(const engine::Snapshot& snapshot, double sight_percent);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void add_anatomy_cuts();
  void add_soft_cut();
  void add_tool(const engine::TriangleMesh& tool);
  void add_sight_line();
  void frame();
  vtkSmartPointer<vtkActor> add_flat(vtkPolyData* surface, double towards_viewer_mm, double red, double green,
                                     double blue);

  std::shared_ptr<PatientLook> look_;
  std::vector<MovingSurface> moving_;
  vtkSmartPointer<vtkPoints> soft_points_;
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> soft_;  ///< tongue and, where there is one, epiglottis
  vtkSmartPointer<vtkActor> blade_, handle_, ghost_, sight_;
  double height_mm_ = 100.0, width_mm_ = 100.0, centre_y_ = 0.0, centre_z_ = 0.0;
};

}  // namespace vallecula::gui
