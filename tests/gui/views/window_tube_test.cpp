// A scripted pair of hands brings the tube into the built-in infant, as a person sees it: pictures to be looked at, and
// what must be on them.
#include <QHBoxLayout>
#include <cstdlib>
#include <map>

#include "gui/pages/key_moments.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/trial_session.h"
#include "gui/session/user_paths.h"
#include "gui/views/operator_view.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/video_view.h"
#include "tests/gui/placed_tube.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

class WindowTube : public Screen {
 protected:
  static void SetUpTestSuite() {
    Screen::SetUpTestSuite();
    TrialSetup setup;
    setup.curriculum = curricula_folder() / "first-intubation.yaml";
    const curricula::Curriculum course = curricula::load_curriculum(setup.curriculum);
    setup.patient = builtin_patient(course.scenarios.front().manikin, {});
    folder_ = setup.patient;
    setup.scenario = course.scenarios.front().id;
    setup.device = "scripted:expert";
    setup.out = box() / "expert";
    setup.realtime = false;
    TrialSession session(setup);
    package_ = std::make_unique<pipeline::PatientPackage>(session.package());
    scene_ = std::make_unique<engine::SceneDescription>(session.scene());
    KeyMoments moments(session.package(), session.scenario().sight_percent);
    session.start();
    ASSERT_TRUE(wait_for(
        [&] {
          const engine::Snapshot& now = session.latest();
          for (const std::string& moment : moments.at(now)) moments_[moment] = now;
          return session.finished();
        },
        300000));
    score_ = session.finish("finished").score;
  }
  static void TearDownTestSuite() {
    package_.reset();
    scene_.reset();
    Screen::TearDownTestSuite();
  }
  static test::Sandbox& box() {
    static test::Sandbox box;
    return box;
  }
  void SetUp() override {
    auto* row = new QHBoxLayout(&window_);
    operator_ = new OperatorView(&window_);
    sagittal_ = new SagittalView(&window_);
    video_ = new VideoView(&window_);
    row->addWidget(operator_, 17);
    row->addWidget(sagittal_, 10);
    row->addWidget(video_, 10);
    window_.resize(1280, 640);
    operator_->set_zoom(OperatorView::Zoom::mouth);
    operator_->set_blue_trachea(true);  // told from everything else
    const std::shared_ptr<PatientLook> look = make_patient_look(*package_, {}, Seen::from_the_eye, folder_);
    operator_->show_patient(look, scene_->tool.surface, &*scene_->intubation);
    sagittal_->show_patient(look, scene_->tool.surface, &*scene_->intubation);
    video_->show_patient(look, scene_->tool.surface, &*scene_->intubation);
    video_->set_blue_trachea(true);
    window_.show();
  }
  QImage show(const engine::Snapshot& snapshot, const std::string& name) {
    EXPECT_TRUE(wait_for(
        [&] {
          operator_->update_from(snapshot);
          return operator_->closeness() == 1.0;
        },
        5000));
    sagittal_->update_from(snapshot, 25.0);
    sagittal_->draw();
    video_->update_from(snapshot);
    video_picture_ = video_->picture();
    keep_picture(*video_, "video-" + name + ".png");
    const QImage picture = operator_->picture();
    keep_picture(*operator_, "operator-" + name + ".png");
    keep_picture(*sagittal_, "sagittal-" + name + ".png");
    return picture;
  }
  static int blue(const QImage& picture) {
    return find_pixels(picture, [](QRgb c, int, int) { return is_airway_blue(c); }).pixels;
  }

  static inline std::unique_ptr<pipeline::PatientPackage> package_;
  static inline std::filesystem::path folder_;
  static inline std::unique_ptr<engine::SceneDescription> scene_;
  static inline std::map<std::string, engine::Snapshot> moments_;
  static inline curricula::Score score_;
  QWidget window_;
  OperatorView* operator_ = nullptr;
  SagittalView* sagittal_ = nullptr;
  VideoView* video_ = nullptr;
  QImage video_picture_;
};

TEST_F(WindowTube, GoesBetweenTheCordsInSightOfTheOperator) {
  ASSERT_TRUE(score_.intubation);
  EXPECT_EQ(score_.intubation->outcome, curricula::Outcome::good_depth) << outcome_in_words(*score_.intubation);
  for (const char* moment : {"1-lips", "2-sweep", "3-vallecula", "4-first-sight", "5-best-sight", "6-tip-at-cords",
                             "7-between-cords", "8-withdrawal", "9-detector-yellow"})
    ASSERT_EQ(moments_.count(moment), 1u) << moment;
  for (const auto& [name, snapshot] : moments_) show(snapshot, name);
  const engine::Snapshot& between = moments_.at("7-between-cords");
  const QImage with = show(between, "7-between-cords");
  engine::Snapshot without = between;
  for (auto& node : without.tube_axis) node += engine::Vec3(0.5, 0.5, 0.0);  // the tube taken away
  const QImage no_tube = show(without, "7-without-the-tube");
  const Spot tube = difference(no_tube, with);
  EXPECT_GT(tube.pixels, 2000);
  const auto ink = [&](QRgb c, int x, int y) { return qGray(c) < 60 && qGray(no_tube.pixel(x, y)) > 75; };
  EXPECT_GT(find_pixels(with, ink).pixels, 60) << "marks are to be read";
}

TEST_F(WindowTube, TheCameraInTheBladeSeesTheGlottisAndTheTubeComeFromTheRight) {
  engine::Snapshot snapshot = moments_.at("5-best-sight");
  for (auto& node : snapshot.tube_axis) node += engine::Vec3(0.5, 0.5, 0.0);
  show(snapshot, "blue-without-the-tube");
  const Spot glottis = find_pixels(video_picture_, [](QRgb c, int, int) { return is_airway_blue(c); });
  EXPECT_GT(glottis.pixels, 300);
  EXPECT_NEAR(glottis.x, 0.5 * video_picture_.width(), 0.25 * video_picture_.width());
  video_->set_blue_trachea(false);
  operator_->set_blue_trachea(false);
  show(snapshot, "natural-without-the-tube");
  EXPECT_EQ(find_pixels(video_picture_, [](QRgb c, int, int) { return is_airway_blue(c); }).pixels, 0);
  const QImage without = video_picture_;
  show(moments_.at("7-between-cords"), "natural-between-cords");
  show(moments_.at("3-vallecula"), "natural-vallecula");
  show(moments_.at("1-lips"), "natural-lips");
  EXPECT_GT(difference(without, video_picture_).pixels, 2000);
}

TEST_F(WindowTube, CordsOpenAndCloseAndSecretionsHideThem) {
  engine::Snapshot snapshot = moments_.at("5-best-sight");
  for (auto& node : snapshot.tube_axis) node += engine::Vec3(0.5, 0.5, 0.0);
  const auto with_opening = [&](double opening, const std::string& name) {
    snapshot.intubation.glottis_opening = opening;
    return blue(show(snapshot, name));
  };
  const int closed = with_opening(0.0, "cords-closed"), at_ease = with_opening(0.55, "cords-at-ease"),
            open = with_opening(1.0, "cords-open");
  EXPECT_GT(open, at_ease);
  EXPECT_GT(at_ease, 4 * closed + 100);
  snapshot.intubation.in_hand = engine::InHand::catheter;
  lay_tube(snapshot, *scene_->intubation, way_to_trachea(*package_), 1, -10.0);
  snapshot.intubation.secretions_ml = 3.0;
  EXPECT_LT(blue(show(snapshot, "secretions")), at_ease / 3);
}

}  // namespace
}  // namespace vallecula::gui::window_test
