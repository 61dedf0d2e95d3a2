// What stands before any camera at the mouth: the tissue, the blade, the tube, the cords and the secretions, and the
// light on them. Every view has a stage of its own, for what OpenGL keeps belongs to one window; the surfaces are the
// patient's, shared.
#pragma once

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <memory>
#include <optional>
#include <vector>

#include "engine/snapshot.h"
#include "gui/views/larynx_look.h"
#include "gui/views/patient_look.h"
#include "gui/views/tissue_shading.h"
#include "gui/views/tool_look.h"
#include "gui/views/tube_look.h"

namespace vallecula::gui {

class MouthStage {
 public:
  enum class Eye { operators, in_the_mouth };  ///< the second may come to lie in the tissue, and looks about behind it

  /// `intubation`: of a scene that has one. Adds its actors to the renderer, what is seen through last.
  MouthStage(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool,
             const engine::IntubationDescription* intubation, Eye eye, vtkRenderer* renderer);

  /// Moves everything to the snapshot's step.
  void update(const engine::Snapshot& snapshot);
  /// Lights everything as the camera sees it: after every move of either.
  void light(vtkCamera* camera);
  /// The paper's blue below the cords, or its natural look; nothing: as all views have it.
  void set_blue_trachea(std::optional<bool> blue);
  /// What all views have from their next frame on that were not told otherwise: natural unless set. Window's thread.
  static void set_blue_everywhere(bool blue);
  /// Of an operator's stage: the mouth fills the view, so that no more of the face than about it need be drawn.
  void set_close(bool on);
  /// Takes the patient's left half of the skin away, for a look from the side.
  void set_half(bool on);
  /// What a slow machine goes without; both are on at first.
  void set_effects(bool shadows, bool rim);

  const PatientLook& look() const { return *look_; }
  const ToolLook& tool() const { return *tool_; }
  /// How far the blade's tip is on the way from the gums (0) to the glottis (1); beyond either, less or more.
  double depth() const { return depth_; }

 private:
  void colour_trachea();
  void gather_solids(const engine::Snapshot& snapshot);
  std::shared_ptr<PatientLook> look_;
  std::unique_ptr<ToolLook> tool_;
  std::unique_ptr<TubeLook> tube_;
  std::unique_ptr<CordsLook> cords_;
  std::unique_ptr<SecretionsLook> secretions_;
  std::vector<vtkSmartPointer<vtkActor>> tissues_;  ///< the skin first
  vtkSmartPointer<vtkActor> close_skin_;            ///< one of them; null but on an operator's stage
  vtkSmartPointer<vtkActor> drape_;                 ///< likewise, and without a body below the neck
  vtkSmartPointer<vtkActor> trachea_;               ///< one of them; null without a trachea
  std::optional<bool> blue_, blue_shown_;
  double tube_radius_mm_ = 0.0, catheter_radius_mm_ = 0.0, depth_ = -1.0, exposure_ = 1.0;
  Lighting lighting_;
};

}  // namespace vallecula::gui
