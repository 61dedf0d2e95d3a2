// One view that shows a patient, the same one again and then another, as coarsely as a slow machine draws and with
// everything: what is on the screen is the patient of that moment each time, as a view of its own draws it.
#include <QGuiApplication>
#include <QScreen>
#include <tuple>

#include "gui/views/operator_view.h"
#include "tests/gui/picture_difference.h"
#include "tests/gui/placed_tube.h"
#include "tests/gui/window_patient.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

constexpr int kViewWidth = 320, kViewHeight = 240;
constexpr int kBlankColours = 40;   // a blank view has one, the coarse patient's mouth some hundreds
constexpr double kAlikeGrey = 1.5;  // two views that draw the same; another patient differs by more
const int kCoarsest = static_cast<int>(kQualities.size()) - 1;

class WindowPatientsInTurn : public Screen {
 protected:
  ~WindowPatientsInTurn() override {
    GlView::governor().hold(0);
    GlView::governor().set_mode(QualityGovernor::Mode::automatic);
  }
  /// Another child, with a narrower mouth, tongue and all.
  static pipeline::PatientPackage other_patient() {
    constexpr double kNarrower = 0.6;
    pipeline::PatientPackage other = coarse_patient();
    for (auto& point : other.tongue.points) point[0] *= kNarrower;
    for (auto& [name, surface] : other.surfaces)
      for (auto& point : surface.points) point[0] *= kNarrower;
    return other;
  }
  struct Seen {
    QImage widget, screen;
  };
  static Seen shown(OperatorView& view, const std::shared_ptr<PatientLook>& look) {
    static const engine::IntubationDescription intubation = plain_intubation(coarse_patient());
    view.resize(kViewWidth, kViewHeight);
    view.show_patient(look, plain_blade(), &intubation);
    view.show();
    QApplication::processEvents();
    engine::Snapshot snapshot = lifted_snapshot(look->package, 0.7, 3.0);
    snapshot.has_intubation = true;
    snapshot.intubation.glottis_opening = 0.8;
    for (auto& node : snapshot.tube_axis) node = engine::Vec3(0.5, 0.5, 0.0);  // far from all of it
    view.update_from(snapshot);
    view.settle();
    view.draw();  // once, as a replay that stands draws it
    EXPECT_TRUE(wait_for([&] { return !view.making_ready(); }));
    QApplication::processEvents();
    return {view.grab().toImage(), QGuiApplication::primaryScreen()->grabWindow(view.winId()).toImage()};
  }
  static Seen alone(const pipeline::PatientPackage& patient) {
    OperatorView view;
    view.set_zoom(OperatorView::Zoom::mouth);
    return shown(view, make_patient_look(patient));
  }
  static void expect_seen(const Seen& seen, const Seen& truth, const std::string& when) {
    for (const auto& [picture, right, where] :
         {std::tuple(seen.widget, truth.widget, "widget"), std::tuple(seen.screen, truth.screen, "screen")}) {
      if (const char* folder = std::getenv("VALLECULA_PICTURES"))
        picture.save(QString::fromStdString(std::string(folder) + "/in-turn-" + when + "-" + where + ".png"));
      EXPECT_GT(colours_in(picture), kBlankColours) << when << ": blank on the " << where;
      ASSERT_EQ(picture.size(), right.size()) << when;
      EXPECT_LT(picture_difference(right, picture).mean_grey, kAlikeGrey)
          << when << ": another picture on the " << where;
    }
  }
  /// `switched`: the step comes while the first patient is shown, else it is there from the beginning.
  static void look_in_turn(int step, bool switched) {
    const std::string name = std::to_string(step) + (switched ? "-switched" : "");
    const auto a = make_patient_look(coarse_patient()), b = make_patient_look(other_patient());
    GlView::governor().hold(switched ? 0 : step);
    OperatorView view;
    view.set_zoom(OperatorView::Zoom::mouth);
    const Seen first = shown(view, a);
    GlView::governor().hold(step);
    const Seen again = shown(view, a), another = shown(view, b), back = shown(view, a);
    const Seen a_alone = alone(coarse_patient()), b_alone = alone(other_patient());
    ASSERT_GT(colours_in(a_alone.screen), kBlankColours);
    ASSERT_GT(picture_difference(a_alone.screen, b_alone.screen).mean_grey, kAlikeGrey) << "they are told apart";
    if (!switched) expect_seen(first, a_alone, name + "-first");
    expect_seen(again, a_alone, name + "-same-again");
    expect_seen(another, b_alone, name + "-another");
    expect_seen(back, a_alone, name + "-and-back");
  }
};

TEST_F(WindowPatientsInTurn, WithEverything) { look_in_turn(0, false); }
TEST_F(WindowPatientsInTurn, AsCoarselyAsItGets) { look_in_turn(kCoarsest, false); }
TEST_F(WindowPatientsInTurn, CoarserWhileOneIsShown) { look_in_turn(kCoarsest, true); }

}  // namespace
}  // namespace vallecula::gui::window_test
