// The video laryngoscope's picture: a camera in the blade, just behind its tip, looks along it to the glottis. Up on
// the screen is the blade's tongue side, right the patient's right.
#pragma once

#include <memory>

#include "gui/views/gl_view.h"
#include "gui/views/mouth_stage.h"

namespace vallecula::gui {

class VideoView : public GlView {
  Q_OBJECT
 public:
  explicit VideoView(QWidget* parent = nullptr);
  /// Takes a patient and a tool in place of what was shown; `intubation`: of a scene that has one.
  void show_patient(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool,
                    const engine::IntubationDescription* intubation = nullptr);
  /// Moves blade, tissue and what is in the airway to the snapshot's step; draw() then shows it.
  void update_from(const engine::Snapshot& snapshot);
  /// The paper's blue below the cords or its natural look, for this view alone; stays for the patients that follow.
  void set_blue_trachea(bool blue);
  /// Field of view along the shorter side, degrees.
  static constexpr double kFieldDeg = 60.0;

 protected:
  void use(const Quality& quality) override;

 private:
  std::unique_ptr<MouthStage> stage_;
  std::optional<bool> blue_trachea_;
};

}  // namespace vallecula::gui
