// A trial of 1.2 s and the page on which it is looked at.
#pragma once

#include <QtTest/QtTest>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "gui/pages/main_window.h"
#include "gui/pages/replay_page.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {

/// One trial of 1.2 s, done as fast as it goes, is looked at by all.
class WindowReplay : public Screen {
 protected:
  static void SetUpTestSuite() {
    Screen::SetUpTestSuite();
    shared_ = std::make_unique<test::Sandbox>();
    ::setenv("VALLECULA_HOME", shared_->home().c_str(), 1);
    TrialSession session(setup(shared_->folder()));
    session.start();
    ASSERT_TRUE(wait_for([&] { return session.finished(); }));
    session.finish("ended");
  }
  static void TearDownTestSuite() {
    shared_.reset();
    Screen::TearDownTestSuite();
  }
  static TrialSetup setup(const std::filesystem::path& folder) {
    TrialSetup setup;
    setup.patient = test::write_block_patient(folder);
    setup.curriculum = test::write_curriculum(folder);
    setup.scenario = "plain";
    setup.device = "scripted:" + test::write_press(folder).string();
    setup.out = folder / "out";
    setup.realtime = false;
    return setup;
  }
  static std::filesystem::path trial() { return *shared_ / "out"; }
  static void key(QWidget& widget, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&widget, static_cast<Qt::Key>(key), modifiers);
  }
  /// Opened, all of it computed.
  static ReplayPage& opened(MainWindow& window, const std::filesystem::path& trial, int timeout_ms = 60000,
                            const std::filesystem::path& patient = {}) {
    bool there = false;
    QString failure;
    QObject::connect(&window, &MainWindow::replay_opened, [&] { there = true; });
    QObject::connect(&window, &MainWindow::replay_failed, [&](const QString& message) { failure = message; });
    window.replay(trial, -1.0, patient);
    EXPECT_EQ(window.page_name(), "prepare") << "the window does not wait";
    EXPECT_TRUE(wait_for([&] { return there || !failure.isEmpty(); }));
    if (!there) throw std::runtime_error("not opened: " + failure.toStdString());
    ReplayPage& page = window.replay_page();
    EXPECT_TRUE(wait_for([&] { return page.film().finished() && page.shown_frame() >= 0; }, timeout_ms));
    return page;
  }

  static inline std::unique_ptr<test::Sandbox> shared_;
};

}  // namespace vallecula::gui::window_test
