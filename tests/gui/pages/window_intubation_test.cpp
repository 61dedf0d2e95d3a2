// The trial page of a scenario with an intubation: monitor, keys, hints, at the sizes that windows have.
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
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
  window.close();
}

}  // namespace
}  // namespace vallecula::gui::window_test
