// A trial page with its panels, open on a patient of blocks and a course in which all of them are used.
#pragma once

#include <QtTest/QTest>
#include <cstdlib>

#include "gui/pages/main_window.h"
#include "gui/pages/trial_page.h"
#include "gui/session/user_settings.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/busy_course.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {

class WindowPanels : public Screen {
 protected:
  WindowPanels() {
    const char* home = std::getenv("VALLECULA_HOME");
    before_ = home == nullptr ? "" : home;
    ::setenv("VALLECULA_HOME", box_.home().c_str(), 1);
    user_settings()->setValue("mouse/introduced", true);
  }
  ~WindowPanels() override {
    if (before_.empty())
      ::unsetenv("VALLECULA_HOME");
    else
      ::setenv("VALLECULA_HOME", before_.c_str(), 1);
  }
  void open(MainWindow& window, const std::string& scenario, curricula::Mode mode = curricula::Mode::practice) {
    TrialSetup setup;
    setup.patient = patient_;
    setup.curriculum = course_;
    setup.scenario = scenario;
    setup.device = "mouse";
    setup.mode = mode;
    setup.out = box_ / "out";
    window.show();
    bool ready = false;
    const auto heard = QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
    window.prepare(setup, false);
    ASSERT_TRUE(wait_for([&] { return ready; }));
    QObject::disconnect(heard);
    QApplication::processEvents();
  }
  static void key(TrialPage& page, int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&page, static_cast<Qt::Key>(code), modifiers);
    QApplication::processEvents();
  }
  static void drawn(TrialPage& page, int frames) {
    int seen = 0;
    const auto heard = QObject::connect(&page, &TrialPage::frame,
                                        [&](const engine::Snapshot& shown) { seen += shown.ticks > 0 ? 1 : 0; });
    EXPECT_TRUE(wait_for([&] { return seen >= frames; }, 30000));
    QObject::disconnect(heard);
  }
  std::string before_;
  test::Sandbox box_;
  const std::filesystem::path patient_ = test::write_block_patient(box_.folder());
  const std::filesystem::path course_ = test::write_busy_course(box_.folder());
};

}  // namespace vallecula::gui::window_test
