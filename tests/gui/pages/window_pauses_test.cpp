// A trial that somebody holds: who it is, that it is not ended meanwhile, what is kept of it, how the hand goes on.
#include <QDialog>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>
#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include "device/drivers/mouse_device.h"
#include "gui/pages/hand_panel.h"
#include "gui/pages/main_window.h"
#include "gui/pages/trial_page.h"
#include "tests/gui/arc_patient.h"
#include "tests/gui/pages/window_panels.h"
#include "tests/gui/program.h"

namespace vallecula::gui::window_test {
namespace {

bool page_says(const TrialPage& page, const QString& words) {
  const auto labels = page.findChildren<QLabel*>();
  return std::any_of(labels.begin(), labels.end(),
                     [&](const QLabel* one) { return one->isVisible() && one->text().contains(words); });
}

QPushButton* foot_button(const TrialPage& page, const QString& text) {
  for (auto* one : page.findChildren<QPushButton*>())
    if (one->text() == text) return one;
  return nullptr;
}

TEST_F(WindowPanels, WhatAnInstructorHoldsIsNotEndedAtTheBladeAndSaysWhy) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  bool finished = false;
  QObject::connect(&window, &MainWindow::trial_finished, [&] { finished = true; });
  page.start();
  drawn(page, 3);
  QPushButton *end = foot_button(page, "End"), *back = foot_button(page, "Back");
  ASSERT_TRUE(end != nullptr && back != nullptr);
  EXPECT_TRUE(end->isEnabled() && back->isEnabled());
  page.session()->freeze(Holder::instructor, true);
  QTest::keyClick(&page, Qt::Key_Escape);  // before any picture has told of it
  EXPECT_TRUE(page.running());
  ASSERT_TRUE(wait_for([&] { return page_says(page, "held by the instructor"); }, 20000));
  EXPECT_TRUE(page_says(page, "not ended here")) << "why Esc did nothing";
  for (QPushButton* button : {end, back}) {
    EXPECT_FALSE(button->isEnabled()) << button->text().toStdString();
    EXPECT_TRUE(button->toolTip().contains("instructor")) << button->toolTip().toStdString();
  }
  keep_picture(window, "pause-by-instructor.png");
  page.session()->freeze(Holder::instructor, false);
  ASSERT_TRUE(wait_for([&] { return end->isEnabled(); }, 20000));
  EXPECT_TRUE(end->toolTip().contains("Esc"));
  EXPECT_FALSE(page_says(page, "not ended here"));
  QTest::keyClick(&page, Qt::Key_Escape);
  EXPECT_FALSE(page.running());
  EXPECT_TRUE(wait_for([&] { return finished; }));
}

TEST_F(WindowPanels, TheListOfKeysThatHeldATrialIsNamedAmongItsPauses) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  TrialOutcome outcome;
  bool finished = false;
  QObject::connect(&window, &MainWindow::trial_finished, [&](const TrialOutcome& given) {
    outcome = given;
    finished = true;
  });
  page.start();
  drawn(page, 3);
  key(page, Qt::Key_F1);
  auto* list = page.findChild<QDialog*>("key_list");
  ASSERT_NE(list, nullptr);
  EXPECT_TRUE(wait_for([&] { return page_says(page, "for as long as the list of keys is open"); }, 20000));
  ASSERT_TRUE(wait_for([&] { return page.session()->paused_s() > 0.2; }, 20000));
  QTest::keyClick(list, Qt::Key_Escape);
  ASSERT_TRUE(wait_for([&] { return page.session()->pause().empty(); }, 20000));
  drawn(page, 3);
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
  ASSERT_EQ(outcome.score.pauses.size(), 1u);
  EXPECT_EQ(outcome.score.pauses[0].fault, "list_of_keys");
  EXPECT_GE(outcome.score.paused_s, 0.2);
  EXPECT_NE(test::text_of(outcome.report).find("1 time (list of keys)"), std::string::npos);
}

/// The window draws nothing meanwhile, as behind a driver that does not answer.
bool stands_until(const std::function<bool()>& done) {
  QElapsedTimer timer;
  timer.start();
  while (!done() && timer.elapsed() < 60000) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return done();
}

bool has_pause(const TrialOutcome& outcome, const std::string& fault) {
  const auto& all = outcome.score.pauses;
  return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.fault == fault; });
}

TEST_F(WindowPanels, ATrialWhosePictureStandsWaitsSaysSoAndGoesOn) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  TrialOutcome outcome;
  bool finished = false;
  QObject::connect(&window, &MainWindow::trial_finished, [&](const TrialOutcome& given) {
    outcome = given;
    finished = true;
  });
  page.start();
  EXPECT_TRUE(stands_until([&] { return page.session()->frozen_by(Holder::picture); })) << "from the first picture on";
  const auto goes_on = [&] {
    EXPECT_TRUE(wait_for([&] { return page_says(page, "No picture comes to the screen"); }));
    EXPECT_TRUE(wait_for([&] { return page_says(page, "no picture came to the screen; the trial waited"); }));
    EXPECT_TRUE(wait_for([&] { return !page.session()->frozen() && page.session()->pause().empty(); }))
        << "the mouse stands at the blade";
  };
  goes_on();
  drawn(page, 5);
  QTest::keyPress(&page, Qt::Key_Space);  // let go of unseen: what lifts is let go of with it
  const double lifts_from = page.session()->paused_s();
  EXPECT_TRUE(stands_until([&] { return page.session()->paused_s() > lifts_from + 0.5; }));
  goes_on();
  keep_picture(window, "pause-without-picture.png");
  const double blade_m = page.session()->latest().proxy_pose.position.y();
  drawn(page, 10);
  EXPECT_NEAR(page.session()->latest().proxy_pose.position.y(), blade_m, 1e-4);
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
  EXPECT_TRUE(has_pause(outcome, "no_picture"));
  EXPECT_GE(outcome.score.paused_s, 0.5);
  EXPECT_NE(test::text_of(outcome.report).find("no picture"), std::string::npos);
}

TEST_F(WindowPanels, AWindowThatIsPutAwayHoldsPracticeAndNoAssessment) {
  for (const curricula::Mode mode : {curricula::Mode::practice, curricula::Mode::assessment}) {
    const bool practice = mode == curricula::Mode::practice;
    MainWindow window;
    open(window, "helped", mode);
    TrialPage& page = window.trial_page();
    page.start();
    drawn(page, 5);
    window.hide();
    const std::int64_t at = page.session()->latest().ticks;
    ASSERT_TRUE(wait_for([&] { return page.session()->latest().ticks > at + 4000; }));
    EXPECT_EQ(page.session()->frozen_by(Holder::picture), practice);
    window.show();
    if (!practice) {
      EXPECT_TRUE(page.session()->pause().empty()) << "whoever is assessed stops no clock";
      continue;
    }
    EXPECT_TRUE(wait_for([&] { return page_says(page, "while its window was not to be seen"); }));
    EXPECT_FALSE(page.session()->frozen());
    window.hide();
    ASSERT_TRUE(wait_for([&] { return page.session()->frozen_by(Holder::picture); }));
    page.reset();
    EXPECT_FALSE(page.session()->frozen()) << "that was the attempt before";
  }
}

TEST_F(WindowPanels, AfterHandsWereChangedInAPauseTheMouseStillTakesHoldAtTheBlade) {
  MainWindow window;
  TrialSetup setup;
  setup.patient = test::write_arc_patient(box_.folder());
  setup.curriculum = test::write_tube_curriculum(box_.folder());
  setup.scenario = "tube";
  setup.device = "mouse";
  setup.out = box_ / "tube-out";
  window.show();
  bool ready = false;
  QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
  window.prepare(setup, false);
  ASSERT_TRUE(wait_for([&] { return ready; }));
  TrialPage& page = window.trial_page();
  QPushButton* breath = nullptr;
  for (auto* one : page.findChild<HandPanel*>()->findChildren<QPushButton*>())
    if (one->text().startsWith("Breath")) breath = one;
  ASSERT_NE(breath, nullptr);
  EXPECT_FALSE(breath->isEnabled()) << "before the start";
  EXPECT_TRUE(breath->toolTip().startsWith("Once the trial runs")) << breath->toolTip().toStdString();
  keep_picture(window, "hands-before-start.png");
  page.start();
  drawn(page, 3);
  EXPECT_TRUE(breath->isEnabled());
  ASSERT_TRUE(page.session()->takes_turns());
  auto& mouse = dynamic_cast<device::MouseDevice&>(page.session()->device());
  const auto apart_m = [&] {
    const engine::Snapshot& now = page.session()->latest();
    return (now.device_pose.position - now.proxy_pose.position).norm();
  };
  const auto holds = [&](Tool tool) { return wait_for([&] { return page.session()->in_hand() == tool; }, 20000); };
  for (const bool changed : {false, true}) {  // in the pause alone, and as well before it
    if (changed) {
      key(page, Qt::Key_X);
      ASSERT_TRUE(holds(Tool::tube));
      mouse.move(0.03, 0.0);
      drawn(page, 20);
      key(page, Qt::Key_X);
      ASSERT_TRUE(holds(Tool::blade));
    }
    page.session()->freeze(Holder::instructor, true);
    ASSERT_TRUE(wait_for([&] { return page_says(page, "held by the instructor"); }, 20000));
    key(page, Qt::Key_X);
    mouse.move(0.0, 0.04);
    ASSERT_TRUE(wait_for([&] { return apart_m() > 0.03; }, 20000)) << "the grey blade is away";
    EXPECT_EQ(page.session()->in_hand(), Tool::blade) << "in a pause nothing is taken";
    page.session()->freeze(Holder::instructor, false);
    ASSERT_TRUE(wait_for([&] { return page_says(page, "let go"); }, 20000));
    key(page, Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return page.session()->pause().empty(); }, 20000));
    drawn(page, 2);
    EXPECT_LT(apart_m(), 1e-3) << "it is in the hand where it was"
                               << (changed ? ", hanging at the mouse from afar" : "");
  }
  page.close_trial();
}

}  // namespace
}  // namespace vallecula::gui::window_test
