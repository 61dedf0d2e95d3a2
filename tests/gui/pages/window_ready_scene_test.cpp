// What a trial is built of is ready before the click, and stays for the trial after it.
#include <QPushButton>

#include "engine/scene_data.h"
#include "gui/pages/ready_patient.h"
#include "gui/pages/trial_page.h"
#include "gui/session/user_settings.h"
#include "pipeline/package/label_map.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

class WindowReadyScene : public Screen {
 protected:
  WindowReadyScene() {
    setenv("VALLECULA_HOME", box_.home().c_str(), 1);
    patient_ = test::write_block_patient(box_.folder());
    course_ = test::write_curriculum(box_.folder());
    user_settings()->setValue("mouse/introduced", true);
  }
  ~WindowReadyScene() override {
    window_.reset();
    unsetenv("VALLECULA_HOME");
  }
  std::shared_ptr<const engine::Scene> prepared(const fs::path& patient, const fs::path& course) {
    TrialSetup setup;
    setup.patient = patient;
    setup.curriculum = course;
    setup.scenario = "plain";
    setup.device = "mouse";
    setup.out = box_ / ("out" + std::to_string(++trials_));
    bool ready = false;
    const auto told = QObject::connect(window_.get(), &MainWindow::prepared, [&ready] { ready = true; });
    window_->prepare(setup, false);
    EXPECT_TRUE(wait_for([&] { return ready; }));
    QObject::disconnect(told);
    return window_->trial_page().session()->built_scene();
  }

  test::Sandbox box_;
  fs::path patient_, course_;
  int trials_ = 0;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(WindowReadyScene, TheNextTrialOfAPatientBuildsNothingAgain) {
  window_ = std::make_unique<MainWindow>();
  const auto first = prepared(patient_, course_), second = prepared(patient_, course_);
  EXPECT_NE(first, second) << "an attempt of its own";
  EXPECT_EQ(&first->tree, &second->tree);
  EXPECT_EQ(&first->tool, &second->tool);
  std::string text = test::text_of(course_);
  const auto blade = text.find("miller-1");
  ASSERT_NE(blade, std::string::npos);
  text.replace(blade, 8, "miller-0");
  test::write_text(course_, text);
  const auto other_blade = prepared(patient_, course_);
  EXPECT_EQ(&other_blade->tree, &first->tree);
  EXPECT_NE(&other_blade->tool, &first->tool) << "the course was changed under its name";
  pipeline::PatientPackage moved = test::block_patient();
  for (auto& point : moved.tongue.points) point[2] -= 0.5;
  const pipeline::Labels labels = pipeline::read_label_map(patient_ / "labels.nrrd");
  fs::remove_all(patient_);
  pipeline::write_package(moved, labels, patient_);
  EXPECT_NE(&prepared(patient_, course_)->tree, &first->tree) << "the patient was changed under its name";
}

TEST_F(WindowReadyScene, HomeMakesReadyWhatPractiseBegins) {
  window_ = std::make_unique<MainWindow>();
  window_->start_page().add_patient(patient_, true);
  window_->show_start({curricula::load_curriculum(course_)});
  window_->start_page().select("plain", "mouse");
  window_->show();
  ReadyPatient& ready = window_->ready_patient();
  ASSERT_TRUE(wait_for([&] { return ready.kept_scene() != nullptr; }));
  const auto before = ready.kept_scene();
  bool opened = false;
  QObject::connect(window_.get(), &MainWindow::prepared, [&opened] { opened = true; });
  choose_at_home(*window_, "practise");
  ASSERT_TRUE(wait_for([&] { return opened; }));
  const auto scene = window_->trial_page().session()->built_scene();
  EXPECT_EQ(&scene->tree, &before->tree);
  EXPECT_EQ(&scene->tool, &before->tool);
  EXPECT_EQ(ready.kept_scene(), scene) << "one is kept: the trial's own";
}

}  // namespace
}  // namespace vallecula::gui::window_test
