// What the operator sees, standing behind the head: right on the screen is the patient's right, top is anterior.
#pragma once

#include <vtkActor.h>

#include <memory>
#include <vector>

#include "engine/snapshot.h"
#include "gui/views/gl_view.h"
#include "gui/views/help_look.h"
#include "gui/views/mouth_stage.h"

namespace vallecula::gui {

class OperatorView : public GlView {
  Q_OBJECT
 public:
  enum class Zoom { automatic, face, mouth };

  explicit OperatorView(QWidget* parent = nullptr);
  /// Takes a patient and a tool in place of what was shown; `intubation`: of a scene that has one.
  void show_patient(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool,
                    const engine::IntubationDescription* intubation = nullptr);
  /// Helps of the patient shown; both are gone with the next one.
  void show_ghost_path(const engine::TriangleMesh& tool, const device::Trajectory& way);
  void highlight_glottis();
  /// Where the ghost path is, s since it was first shown.
  void set_ghost_time(double time_s);
  /// Moves tongue, blade and ghost, tube, cords and secretions to the snapshot's step; draw() then shows it.
  void update_from(const engine::Snapshot& snapshot);
  void set_zoom(Zoom zoom) { zoom_ = zoom; }
  Zoom zoom() const { return zoom_; }
  /// The next update_from() of the same snapshot shows something else: a ghost goes its path, the eye comes nearer.
  bool moves() const { return path_ || closeness_ != wanted_closeness(); }
  /// As near as it is to be, without the way there: after a jump in time.
  void settle();
  /// True: the camera is the mouse's (VTK's trackball) and stays where it is put; false: back at the operator's eye.
  void set_free_camera(bool on);
  bool free_camera() const { return free_camera_; }
  /// Turns a free camera about what it looks at, degrees.
  void turn_camera(double right_deg, double up_deg);
  /// Takes the patient's left half of the skin away, for a look from the side.
  void set_half(bool on);
  /// The paper's blue below the cords or its natural look, for this view alone; stays for the patients that follow.
  void set_blue_trachea(bool blue);
  bool ghost_shown() const { return ghost_shown_; }
  /// The blade's tip is past the gums.
  bool blade_in() const { return blade_in_; }
  /// 0: the face, 1: the mouth fills the view.
  double closeness() const { return closeness_; }
  /// The view's axes in patient LPS: what a hand moving right or up on the screen means in the patient.
  engine::Vec3 screen_right() const;
  engine::Vec3 screen_up() const;
  /// Size of a pixel at the mouth, mm.
  double mm_per_pixel() const;

 protected:
  void use(const Quality& quality) override;

 private:
  void aim();
  double wanted_closeness() const;
  void light();
  std::shared_ptr<PatientLook> look_;
  std::unique_ptr<MouthStage> stage_;
  std::unique_ptr<GhostLook> ghost_;
  std::unique_ptr<GhostPathLook> path_;
  std::unique_ptr<GlottisMark> mark_;
  Zoom zoom_ = Zoom::automatic;
  double closeness_ = 0.0, across_mm_ = 100.0;
  engine::Vec3 eye_offset_mm_ = engine::Vec3::Zero();  ///< of an operator who moved his own head
  bool ghost_shown_ = false, blade_in_ = false, free_camera_ = false, half_ = false;
  std::optional<bool> blue_trachea_;
  QElapsedTimer since_aimed_;
};

}  // namespace vallecula::gui
