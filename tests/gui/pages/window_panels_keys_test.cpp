// The keys and helps of the trial page: what is grey, what waits while they are read, and the list of keys.
#include <QAbstractButton>
#include <QAction>
#include <QDialog>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QTextBrowser>
#include <QToolButton>
#include <QtTest/QTest>
#include <memory>
#include <utility>

#include "gui/pages/help_panel.h"
#include "gui/pages/main_window.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "tests/gui/pages/window_panels.h"

namespace vallecula::gui::window_test {
namespace {

TEST_F(WindowPanels, HelpsAreAKeyAndAButtonAndTheSameBit) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  auto* helps = page.findChild<HelpPanel*>();
  QToolButton *left = nullptr, *right = nullptr;
  for (auto* button : helps->findChildren<QToolButton*>()) {
    EXPECT_FALSE(button->accessibleName().isEmpty());
    EXPECT_FALSE(button->toolTip().isEmpty());
    if (button->arrowType() == Qt::LeftArrow) left = button;
    if (button->arrowType() == Qt::RightArrow) right = button;
  }
  ASSERT_TRUE(left != nullptr && right != nullptr);
  EXPECT_FALSE(left->isEnabled()) << "nothing runs yet";
  page.start();
  drawn(page, 3);
  HandActions& actions = page.session()->actions();
  EXPECT_TRUE(left->isEnabled());
  QTest::mouseClick(left, Qt::LeftButton);
  EXPECT_EQ(actions.bits(), engine::kActionEyeLeft);
  EXPECT_TRUE(left->isChecked());
  key(page, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(actions.bits(), 0u) << "first back to the middle";
  key(page, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(actions.bits(), engine::kActionEyeRight);
  EXPECT_TRUE(right->isChecked());
  key(page, Qt::Key_Up, Qt::ControlModifier);
  EXPECT_EQ(actions.bits(), engine::kActionEyeRight | engine::kActionEyeUp);
  key(page, Qt::Key_Right, Qt::ControlModifier);
  key(page, Qt::Key_Up, Qt::ControlModifier);
  key(page, Qt::Key_H);
  EXPECT_EQ(actions.bits(), engine::kActionExtend);
  key(page, Qt::Key_H);
  EXPECT_EQ(actions.bits(), 0u);
}

TEST_F(WindowPanels, WhatIsGreyDoesNothingByItsKeyEitherBeforeTheStartAndAfterTheEnd) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  const std::shared_ptr<TrialSession> session = page.session();
  const auto nothing_by_any_key = [&](const char* when) {
    for (const auto& [code, modifier] : {std::pair{Qt::Key_H, Qt::NoModifier},
                                         {Qt::Key_G, Qt::NoModifier},
                                         {Qt::Key_F, Qt::NoModifier},
                                         {Qt::Key_R, Qt::NoModifier},
                                         {Qt::Key_Left, Qt::ControlModifier},
                                         {Qt::Key_Right, Qt::ControlModifier},
                                         {Qt::Key_Up, Qt::ControlModifier},
                                         {Qt::Key_Down, Qt::ControlModifier}})
      key(page, code, modifier);
    EXPECT_EQ(session->actions().bits(), 0u) << when;
    EXPECT_FALSE(page.expert_shown()) << when;
    EXPECT_FALSE(session->led_in()) << when;
    for (auto* button : page.findChild<HelpPanel*>()->findChildren<QAbstractButton*>()) {
      EXPECT_FALSE(button->isEnabled()) << when << ": " << button->text().toStdString();
      EXPECT_FALSE(button->isChecked()) << when << ": " << button->text().toStdString();
    }
  };
  nothing_by_any_key("before the start");
  EXPECT_FALSE(page.running());
  page.start();
  drawn(page, 3);
  key(page, Qt::Key_H);
  EXPECT_EQ(session->actions().bits(), engine::kActionExtend) << "what is not grey works";
  key(page, Qt::Key_H);
  page.end("ended by trainee");
  nothing_by_any_key("after the end");
  ASSERT_TRUE(wait_for([&] { return window.page_name() == "result"; }));
}

TEST_F(WindowPanels, WhileTheKeysAreReadAPersonsPracticeWaits) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  key(page, Qt::Key_F1);  // before the start there is nothing to hold
  QPointer<QDialog> list = page.findChild<QDialog*>("key_list");
  ASSERT_TRUE(list);
  EXPECT_EQ(list->findChild<QLabel*>("key_list_note"), nullptr);
  page.start();
  EXPECT_FALSE(list && list->isVisible()) << "what was read before is put away: the clock runs";
  drawn(page, 3);
  EXPECT_FALSE(page.session()->frozen());
  key(page, Qt::Key_F1);
  EXPECT_TRUE(page.session()->frozen_by(Holder::reader));
  QDialog* open_list = nullptr;
  for (auto* one : page.findChildren<QDialog*>("key_list"))
    if (one->isVisible()) open_list = one;
  ASSERT_NE(open_list, nullptr);
  auto* note = open_list->findChild<QLabel*>("key_list_note");
  ASSERT_NE(note, nullptr);
  EXPECT_TRUE(note->text().contains("waits")) << note->text().toStdString();
  keep_picture(*open_list, "keys-held.png");
  const double from_s = page.session()->paused_s();
  ASSERT_TRUE(wait_for([&] { return page.session()->paused_s() > from_s + 0.3; }, 20000)) << "its clock stands";
  page.reset();
  EXPECT_TRUE(page.session()->frozen_by(Holder::reader)) << "begun anew while it is read, it waits as well";
  QTest::keyClick(open_list, Qt::Key_Escape);
  EXPECT_FALSE(open_list->isVisible());
  EXPECT_TRUE(page.running()) << "Esc closed the list alone";
  EXPECT_FALSE(page.session()->frozen());
  ASSERT_TRUE(wait_for([&] { return page.session()->pause().empty(); }, 20000)) << "the hand has hold again";
}

TEST_F(WindowPanels, InAnAssessmentTheListOfKeysHoldsNothingAndSaysSo) {
  MainWindow window;
  open(window, "helped", curricula::Mode::assessment);
  TrialPage& page = window.trial_page();
  page.start();
  drawn(page, 3);
  key(page, Qt::Key_F1);
  auto* list = page.findChild<QDialog*>("key_list");
  ASSERT_NE(list, nullptr);
  auto* note = list->findChild<QLabel*>("key_list_note");
  ASSERT_NE(note, nullptr);
  EXPECT_TRUE(note->text().contains("clock runs on")) << note->text().toStdString();
  EXPECT_FALSE(page.session()->frozen());
  list->close();
  bool finished = false;
  QObject::connect(&window, &MainWindow::trial_finished, [&] { finished = true; });
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
}

TEST_F(WindowPanels, WhatCannotBeHadSaysWhy) {
  MainWindow window;
  open(window, "helped", curricula::Mode::assessment);
  TrialPage& page = window.trial_page();
  auto* helps = page.findChild<HelpPanel*>();
  page.start();
  drawn(page, 3);
  for (QPushButton* button : {helps->vallecula(), helps->expert()}) {
    EXPECT_FALSE(button->isEnabled());
    EXPECT_TRUE(button->toolTip().contains("assessment"));
  }
  key(page, Qt::Key_G);
  EXPECT_FALSE(page.expert_shown());
  EXPECT_FALSE(page.panels().dock(TrialPanels::video)->toggleViewAction()->isEnabled());
  bool finished = false;
  QObject::connect(&window, &MainWindow::trial_finished, [&] { finished = true; });
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
}

TEST_F(WindowPanels, TheKeyThatOpensTheListOfKeysClosesItAndTheTrialGoesOn) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  page.start();
  drawn(page, 3);
  const auto list = [&]() -> QDialog* {
    for (auto* one : page.findChildren<QDialog*>("key_list"))
      if (one->isVisible()) return one;
    return nullptr;
  };
  for (const bool at_the_page : {false, true}) {  // the keys go to the list, or still to the page behind it
    key(page, Qt::Key_F1);
    ASSERT_NE(list(), nullptr);
    EXPECT_TRUE(page.session()->frozen_by(Holder::reader));
    QApplication::setActiveWindow(list());
    QApplication::processEvents();
    auto* text = list()->findChild<QTextBrowser*>();
    QTest::keyClick(at_the_page ? static_cast<QWidget*>(&page) : text, Qt::Key_F1);
    EXPECT_EQ(list(), nullptr) << at_the_page;
    EXPECT_TRUE(page.running());
    EXPECT_FALSE(page.session()->frozen_by(Holder::reader));
  }
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return window.page_name() == "result"; }));
}

TEST_F(WindowPanels, TheListOfKeysIsTheTableTheyAreTakenBy) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  page.setFocus();
  key(page, Qt::Key_F1);
  auto* list = page.findChild<QDialog*>("key_list");
  ASSERT_NE(list, nullptr);
  const QString text = list->findChild<QTextBrowser*>()->toPlainText();
  for (const char* name : {"Ctrl+Left", "PgUp", "Space", "F1", "Alt+2", "Esc"})
    EXPECT_TRUE(text.contains(name)) << name;
  keep_picture(*list, "keys.png");
  list->close();
  // Each key of the page's own group does something or is told as another's: none falls through to the window.
  page.start();
  drawn(page, 3);
  int taken = 0;
  const auto groups = page.keys();
  for (const KeyRow& row : groups.front().rows) {
    const QKeySequence sequence(row.keys);
    ASSERT_FALSE(sequence.isEmpty()) << row.keys.toStdString();
    const int code = sequence[0];
    const int plain = code & ~static_cast<int>(Qt::KeyboardModifierMask);
    if (plain == Qt::Key_Escape || plain == Qt::Key_G) continue;  // end the trial, and go elsewhere
    QKeyEvent event(QEvent::KeyPress, plain, Qt::KeyboardModifiers(code & static_cast<int>(Qt::KeyboardModifierMask)));
    event.ignore();
    event.accept();
    QApplication::sendEvent(&page, &event);
    EXPECT_TRUE(event.isAccepted()) << row.keys.toStdString();
    ++taken;
  }
  EXPECT_GE(taken, 9);
}

}  // namespace
}  // namespace vallecula::gui::window_test
