// The live mid-sagittal cut, as in textbooks: anterior to the left, the head up. Parallel projection, flat colours.
#pragma once

#include <vtkActor.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <memory>
#include <optional>
#include <vector>

#include "engine/snapshot.h"
#include "gui/views/airway_marks.h"
#include "gui/views/gl_view.h"
#include "gui/views/patient_look.h"
#include "gui/views/tube_look.h"

namespace vallecula::gui {

class SagittalView : public GlView {
  Q_OBJECT
 public:
  explicit SagittalView(QWidget* parent = nullptr);
  /// `intubation`: of a scene that has one; the view then reaches down to the carina.
  void show_patient(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool,
                    const engine::IntubationDescription* intubation = nullptr);
  /// Moves tongue, blade, tube and sight line to the snapshot; `sight_percent`: from where on the glottis counts as in
  /// sight.
  void update_from(const engine::Snapshot& snapshot, double sight_percent);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void add_anatomy_cuts();
  void add_soft_cut();
  void add_tool(const engine::TriangleMesh& tool);
  bool beside_the_cut(const engine::Snapshot& snapshot) const;
  void add_sight_line();
  void add_intubation(const engine::IntubationDescription& intubation);
  void frame();
  void fit_words();
  vtkSmartPointer<vtkActor> add_flat(vtkPolyData* surface, double towards_viewer_mm, double red, double green,
                                     double blue);

  std::shared_ptr<PatientLook> look_;
  std::vector<MovingSurface> moving_;
  vtkSmartPointer<vtkPoints> soft_points_;
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> soft_;  ///< tongue and, where there is one, epiglottis
  std::unique_ptr<TubeLook> tube_;
  std::optional<AirwayMarks> marks_;  ///< of a scene with a tube
  double words_scale_ = 1.0;          ///< the text's, that their type is of
  vtkSmartPointer<vtkActor> blade_, handle_, ghost_, sight_;
  double height_mm_ = 100.0, width_mm_ = 100.0, centre_y_ = 0.0, centre_z_ = 0.0;
};

}  // namespace vallecula::gui
