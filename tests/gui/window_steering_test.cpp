// Mouse and keyboard are enough: a blade steered by nothing but events comes to rest in the vallecula.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gui/pages/main_window.h"
#include "gui/pages/trial_page.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/scripted_hands.h"
#include "gui/session/user_paths.h"
#include "gui/views/operator_view.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

using engine::Vec3;

class WindowSteeringRealTime : public Screen {
 protected:
  WindowSteeringRealTime() { ::setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  test::Sandbox box_;
};

/// A person's hands: they see where the blade is and where it should be, and drag, roll the wheel and turn it there a
/// part of the way at a time.
class Hands {
 public:
  Hands(TrialPage& page) : page_(page), view_(page.operator_view()) {}

  void towards(const engine::Pose& now, const engine::Pose& wanted) {
    constexpr double kShare = 0.4;  // of what is seen to be missing: the picture lags behind the hand
    const Vec3 right = view_.screen_right(), up = view_.screen_up(), into = up.cross(right);
    const Vec3 missing = kShare * (wanted.position - now.position);
    const double pixels_per_m = 1e3 / view_.mm_per_pixel();
    drag(Qt::LeftButton, pixels_per_m * missing.dot(right), -pixels_per_m * missing.dot(up));
    wheel(missing.dot(into) / 0.0015);  // m a notch, as gui/README.md has it
    const Eigen::AngleAxisd turn(now.rotation.conjugate() * wanted.rotation);
    const Vec3 angle = kShare * turn.angle() * turn.axis();  // about the tool's own axes
    drag(Qt::RightButton, angle.z() / 0.004, angle.y() / 0.004);
  }
  void hold(Qt::Key key, bool down) {
    QKeyEvent event(down ? QEvent::KeyPress : QEvent::KeyRelease, key, Qt::NoModifier);
    QApplication::sendEvent(&page_, &event);
  }

 private:
  void mouse(QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons) {
    QMouseEvent event(type, at, view_.mapToGlobal(at), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(&view_, &event);
  }
  void drag(Qt::MouseButton button, double x, double y) {
    const QPoint from(view_.width() / 2, view_.height() / 2);
    const QPoint to = from + QPoint(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
    if (to == from) return;
    mouse(QEvent::MouseButtonPress, from, button, button);
    mouse(QEvent::MouseMove, to, Qt::NoButton, button);
    mouse(QEvent::MouseButtonRelease, to, button, Qt::NoButton);
  }
  void wheel(double notches) {
    const int eighths = static_cast<int>(std::lround(120.0 * notches));
    if (eighths == 0) return;
    const QPointF at(view_.width() / 2, view_.height() / 2);
    QWheelEvent event(at, view_.mapToGlobal(at.toPoint()), QPoint(), QPoint(0, eighths), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view_, &event);
  }

  TrialPage& page_;
  OperatorView& view_;
};

TEST_F(WindowSteeringRealTime, TheMouseBringsTheTipIntoTheValleculaOfTheManikin) {
  const curricula::Curriculum curriculum = curricula::load_curriculum(default_curriculum());
  TrialSetup setup;
  setup.curriculum = default_curriculum();
  setup.scenario = curriculum.scenarios.front().id;
  setup.device = "mouse";
  setup.patient = make_manikin_patient(curriculum.scenarios.front().manikin, box_.folder());
  setup.out = box_ / "out";

  MainWindow window;
  window.show();
  QString failure;
  bool ready = false;
  int finished = 0;
  QObject::connect(&window, &MainWindow::trial_failed, [&](const QString& message) { failure = message; });
  QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
  QObject::connect(&window, &MainWindow::trial_finished, [&](const TrialOutcome&) { ++finished; });
  window.prepare(setup, false);
  ASSERT_TRUE(wait_for([&] { return ready || !failure.isEmpty(); }));
  ASSERT_EQ(failure.toStdString(), "");
  TrialPage& page = window.trial_page();
  const auto& mark = page.patient().landmarks.at("vallecula");
  const Vec3 vallecula = 1e-3 * Vec3(mark[0], mark[1], mark[2]);

  // The way is the expert's, up to the tip behind the tongue; how fast it is gone is up to what is seen on the screen.
  const device::Trajectory expert = scripted_hand("expert", page.patient(), page.scenario());
  constexpr double kArrived = 6.0;
  double on_the_way_s = expert.start_s();
  const auto planned = [&](double time_s) {
    const device::Keyframe key = expert.at(time_s);
    engine::Pose pose;
    pose.position = Vec3(key.position_m[0], key.position_m[1], key.position_m[2]);
    const auto& q = key.rotation_wxyz;
    pose.rotation = engine::Quat(q[0], q[1], q[2], q[3]);
    return pose;
  };
  Hands hands(page);
  double nearest_m = 1.0, pressed_n = 0.0;
  bool lifting = false, there = false;
  page.set_frame_hook([&](const engine::Snapshot& now) {
    if (now.step < 0 || there) return;
    const engine::Pose wanted = planned(on_the_way_s);
    const auto& tongue = now.loads[static_cast<std::size_t>(engine::Structure::tongue)];
    const double away_m = (now.proxy_pose.position - vallecula).norm();
    nearest_m = std::min(nearest_m, away_m);
    pressed_n = std::max(pressed_n, tongue.force_n.norm());
    // 8 mm: a sixth of the way from the gums to the glottis, which the pictures of the demo call the vallecula too.
    there = away_m < 0.008 && tongue.contacts > 0 && tongue.force_n.norm() > 0.05;
    if (!lifting) hands.towards(now.device_pose, wanted);
    if ((now.device_pose.position - wanted.position).norm() < 0.0025)
      on_the_way_s = std::min(kArrived, on_the_way_s + 0.15);
    if (on_the_way_s >= kArrived && !lifting && !there) {
      lifting = true;
      hands.hold(Qt::Key_Space, true);
    }
  });
  page.start();
  wait_for([&] { return there || !failure.isEmpty() || !page.running(); }, 58000);
  hands.hold(Qt::Key_Space, false);
  EXPECT_EQ(failure.toStdString(), "");
  EXPECT_TRUE(there) << "at " << on_the_way_s << " s of the way; nearest " << 1e3 * nearest_m << " mm, at most "
                     << pressed_n << " N on the tongue";
  page.set_frame_hook({});
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished > 0; }));
}

}  // namespace
}  // namespace vallecula::gui::window_test
