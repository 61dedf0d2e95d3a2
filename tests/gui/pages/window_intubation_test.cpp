// The trial page of a scenario with an intubation: monitor, keys, hints, at the sizes that windows have.
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QWheelEvent>
#include <algorithm>
#include <cstdlib>

#include "gui/pages/hand_panel.h"
#include "gui/pages/main_window.h"
#include "gui/pages/trial_page.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/user_paths.h"
#include "gui/views/monitor_panel.h"
#include "gui/views/operator_view.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

class WindowIntubation : public Screen {
 protected:
  TrialSetup setup(const std::string& device) {
    const auto file = curricula_folder() / "first-intubation.yaml";
    const curricula::Curriculum course = curricula::load_curriculum(file);
    TrialSetup setup;
    setup.curriculum = file;
    setup.scenario = course.scenarios.front().id;
    setup.device = device;
    setup.patient = builtin_patient(course.scenarios.front().manikin, {});
    setup.out = box_ / "out";
    return setup;
  }
  test::Sandbox box_;
};

TEST_F(WindowIntubation, ShowsMonitorKeysAndHintsAtUsualSizes) {
  MainWindow window;
  window.show();
  QString failure;
  bool ready = false;
  QObject::connect(&window, &MainWindow::trial_failed, [&](const QString& message) { failure = message; });
  QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
  window.prepare(setup("mouse"), false);
  ASSERT_TRUE(wait_for([&] { return ready || !failure.isEmpty(); }));
  ASSERT_EQ(failure.toStdString(), "");
  TrialPage& page = window.trial_page();
  auto* monitor = page.findChild<MonitorPanel*>();
  auto* hands = page.findChild<HandPanel*>();
  ASSERT_TRUE(monitor != nullptr && hands != nullptr);
  EXPECT_TRUE(monitor->isVisible());
  EXPECT_TRUE(hands->isVisible());
  QApplication::processEvents();
  keep_picture(window, "page-introduction.png");
  engine::Snapshot last;
  page.set_frame_hook([&](const engine::Snapshot& snapshot) { last = snapshot; });
  page.start();
  for (const QSize size : {QSize(1280, 800), QSize(1024, 700)}) {
    window.resize(size);
    const auto until = last.step + 1500;
    ASSERT_TRUE(wait_for([&] { return last.step > until || !failure.isEmpty(); }));
    ASSERT_EQ(failure.toStdString(), "");
    EXPECT_EQ(window.size(), size) << "all of it fits";
    EXPECT_GE(page.operator_view().height(), 300);
    keep_picture(window, "page-" + std::to_string(size.width()) + ".png");
  }
  EXPECT_TRUE(last.has_intubation);

  // By keys: a breath by mask, the catheter, the other hand; and all of it anew after a reset.
  const auto key = [&](int code, bool pressed) {
    QKeyEvent event(pressed ? QEvent::KeyPress : QEvent::KeyRelease, code, Qt::NoModifier);
    QApplication::sendEvent(&page, &event);
  };
  const auto holds = [&](const char* what) {
    const auto labels = page.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->isVisible() && label->text().startsWith("You hold: ") && label->text().contains(what);
    });
  };
  const int breaths = last.intubation.breaths_given;
  key(Qt::Key_B, true);
  EXPECT_TRUE(wait_for([&] { return last.intubation.breaths_given > breaths; }, 10000)) << "by mask";
  key(Qt::Key_B, false);
  EXPECT_LT(monitor->since_breath_s(), 3.0);
  key(Qt::Key_C, true);
  key(Qt::Key_C, false);
  EXPECT_TRUE(wait_for([&] { return last.intubation.in_hand == engine::InHand::catheter; }, 10000));
  EXPECT_TRUE(holds("BLADE"));
  key(Qt::Key_Tab, true);
  key(Qt::Key_Tab, false);
  EXPECT_TRUE(wait_for([&] { return holds("TUBE"); }, 10000));
  const engine::Pose grip = last.intubation.hand_pose, blade = last.device_pose;
  for (int i = 0; i < 3; ++i) {  // the wheel now moves the tube, and the blade stays
    QWheelEvent event(QPointF(100, 100), page.operator_view().mapToGlobal(QPoint(100, 100)), QPoint(), QPoint(0, 240),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&page.operator_view(), &event);
  }
  EXPECT_TRUE(wait_for([&] { return (last.intubation.hand_pose.position - grip.position).norm() > 0.005; }, 10000));
  EXPECT_LT((last.device_pose.position - blade.position).norm(), 1e-4);
  keep_picture(window, "page-tube-in-hand.png");
  page.reset();
  last = {};
  ASSERT_TRUE(wait_for([&] { return last.step > 100 || !failure.isEmpty(); }));
  EXPECT_EQ(failure.toStdString(), "");
  EXPECT_NE(last.intubation.in_hand, engine::InHand::catheter);
  EXPECT_EQ(last.intubation.breaths_given, 0);
  EXPECT_TRUE(wait_for([&] { return holds("BLADE"); }, 10000));
  EXPECT_LT((last.intubation.hand_pose.position - grip.position).norm(), 1e-3) << "the tube is back in its place";
  window.close();
}

}  // namespace
}  // namespace vallecula::gui::window_test
