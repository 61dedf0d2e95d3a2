// The tube in the built-in infant, as a person sees it: pictures to be looked at, and what must be on them.
#include <QHBoxLayout>
#include <cstdlib>

#include "gui/session/builtin_patient.h"
#include "gui/session/trial_session.h"
#include "gui/session/user_paths.h"
#include "gui/views/operator_view.h"
#include "gui/views/sagittal_view.h"
#include "tests/gui/placed_tube.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

/// The term infant's larynx brought into sight by the scripted expert: where a tube goes in.
class WindowTube : public Screen {
 protected:
  static void SetUpTestSuite() {
    Screen::SetUpTestSuite();
    const curricula::Curriculum curriculum = curricula::load_curriculum(default_curriculum());
    TrialSetup setup;
    setup.patient = builtin_patient(curriculum.scenarios.front().manikin, {});
    setup.curriculum = default_curriculum();
    setup.scenario = curriculum.scenarios.front().id;
    setup.device = "scripted:expert";
    setup.out = box() / "view";
    setup.realtime = false;
    TrialSession session(setup);
    package_ = std::make_unique<pipeline::PatientPackage>(session.package());
    blade_ = session.scene().tool.surface;
    session.start();
    ASSERT_TRUE(wait_for([&] {
      const engine::Snapshot& now = session.latest();
      if (now.glottis_visible > view_.glottis_visible) view_ = now;
      return session.finished();
    }));
    ASSERT_GT(view_.glottis_visible, 0.5);
  }
  static void TearDownTestSuite() {
    package_.reset();
    Screen::TearDownTestSuite();
  }
  static test::Sandbox& box() {
    static test::Sandbox box;
    return box;
  }

  static inline std::unique_ptr<pipeline::PatientPackage> package_;
  static inline engine::TriangleMesh blade_;
  static inline engine::Snapshot view_;
};

TEST_F(WindowTube, LiesBetweenTheCordsAndInTheTrachea) {
  const auto intubation = plain_intubation(*package_);
  QWidget window;
  QHBoxLayout row(&window);
  OperatorView operator_view(&window);
  SagittalView sagittal_view(&window);
  row.addWidget(&operator_view, 17);
  row.addWidget(&sagittal_view, 10);
  window.resize(1280, 640);
  operator_view.set_zoom(OperatorView::Zoom::mouth);
  const std::shared_ptr<PatientLook> look = make_patient_look(*package_);
  operator_view.show_patient(look, blade_, &intubation);
  sagittal_view.show_patient(look, blade_, &intubation);
  window.show();
  engine::Snapshot snapshot = view_;
  const auto show = [&](const std::string& name) {
    ASSERT_TRUE(wait_for(
        [&] {
          operator_view.update_from(snapshot);
          return operator_view.closeness() == 1.0;
        },
        5000));
    sagittal_view.update_from(snapshot, 25.0);
    operator_view.draw();
    sagittal_view.draw();
    keep_picture(operator_view, "operator-" + name + ".png");
    keep_picture(sagittal_view, "sagittal-" + name + ".png");
  };
  snapshot.intubation.glottis_opening = 0.55;
  snapshot.has_intubation = true;
  for (auto& node : snapshot.tube_axis) node = {0.3, 0.3, 0.3};
  for (auto& frame : snapshot.tube_frames) frame = engine::Quat::Identity();
  show("cords-at-ease");
  snapshot.intubation.glottis_opening = 1.0;
  show("cords-open");
  snapshot.intubation.glottis_opening = 0.0;
  show("cords-closed");
  snapshot.intubation.glottis_opening = 0.55;
  lay_tube(snapshot, intubation, way_to_trachea(*package_), 1, -12.0);
  show("before-cords");
  lay_tube(snapshot, intubation, way_to_trachea(*package_), 1, 24.0);
  show("between-cords");
  snapshot.intubation.in_hand = engine::InHand::tube_with_stylet;
  show("stylet");
  snapshot.intubation.in_hand = engine::InHand::tube;
  lay_tube(snapshot, intubation, way_to_oesophagus(*package_), 1, 24.0);
  show("oesophagus");
  snapshot.intubation.in_hand = engine::InHand::catheter;
  lay_tube(snapshot, intubation, way_to_trachea(*package_), 1, -10.0);
  snapshot.intubation.secretions_ml = 3.0;
  show("secretions");
}

}  // namespace
}  // namespace vallecula::gui::window_test
