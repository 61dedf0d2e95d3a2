// The trial page's panels: switched by key and menu, moved, remembered, closed by what the scenario allows; the helps
// beside them; what is said; and the list of keys, which is the table they are taken by.
#include <QAbstractButton>
#include <QCheckBox>
#include <QDialog>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTextBrowser>
#include <QToolButton>
#include <QtTest/QTest>
#include <cstdlib>
#include <memory>
#include <utility>

#include "gui/pages/distraction_panel.h"
#include "gui/pages/help_panel.h"
#include "gui/pages/main_window.h"
#include "gui/pages/sound_button.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"
#include "gui/views/force_bars.h"
#include "gui/views/operator_view.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/trial_readings.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/busy_course.h"
#include "tests/gui/picture_difference.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

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
    const auto heard = QObject::connect(&page, &TrialPage::frame, [&](const engine::Snapshot& shown) { seen += shown.ticks > 0 ? 1 : 0; });
    EXPECT_TRUE(wait_for([&] { return seen >= frames; }, 30000));
    QObject::disconnect(heard);
  }
  std::string before_;
  test::Sandbox box_;
  const std::filesystem::path patient_ = test::write_block_patient(box_.folder());
  const std::filesystem::path course_ = test::write_busy_course(box_.folder());
};

TEST_F(WindowPanels, AreSwitchedByKeyAndMenuAndRememberedAndPutBack) {
  {
    MainWindow window;
    open(window, "helped");
    TrialPage& page = window.trial_page();
    TrialPanels& panels = page.panels();
    QDockWidget* cut = panels.dock(TrialPanels::cut);
    EXPECT_TRUE(cut->isVisible() && panels.dock(TrialPanels::force)->isVisible());
    EXPECT_FALSE(panels.dock(TrialPanels::monitor)->isVisible()) << "no infant in it";
    EXPECT_FALSE(panels.dock(TrialPanels::monitor)->toggleViewAction()->isEnabled());
    page.activateWindow();
    page.setFocus();
    ASSERT_TRUE(wait_for([&] { return page.hasFocus(); }, 5000));
    key(page, Qt::Key_1 + TrialPanels::cut, Qt::AltModifier);
    EXPECT_FALSE(cut->isVisible());
    key(page, Qt::Key_1 + TrialPanels::cut, Qt::AltModifier);
    EXPECT_TRUE(cut->isVisible());
    panels.dock(TrialPanels::force)->toggleViewAction()->trigger();
    EXPECT_FALSE(panels.dock(TrialPanels::force)->isVisible());
    cut->setFloating(true);
    QApplication::processEvents();
    EXPECT_TRUE(cut->isVisible() && cut->isFloating());
    // A panel out of the window keeps no keys: H is the infant's head.
    page.start();
    drawn(page, 3);
    QTest::keyClick(cut, Qt::Key_H);
    EXPECT_TRUE(page.session()->actions().held(engine::kActionExtend));
    window.close();
  }
  MainWindow window;
  open(window, "helped");
  TrialPanels& panels = window.trial_page().panels();
  EXPECT_FALSE(panels.dock(TrialPanels::force)->isVisible()) << "remembered";
  EXPECT_TRUE(panels.dock(TrialPanels::cut)->isFloating());
  const auto actions = panels.menu()->actions();
  QAction* as_at_first = actions.back();
  EXPECT_TRUE(as_at_first->text().contains("first"));
  as_at_first->trigger();
  QApplication::processEvents();
  EXPECT_TRUE(panels.dock(TrialPanels::force)->isVisible());
  EXPECT_FALSE(panels.dock(TrialPanels::cut)->isFloating());
  EXPECT_TRUE(panels.dock(TrialPanels::cut)->isVisible());
}

TEST_F(WindowPanels, BeforeTheStartTheViewsShowWhatTheyShowJustAfterIt) {
  const auto same = [&](TrialPage& page, GlView& view, const char* name) {
    ASSERT_TRUE(wait_for([&] { return !view.last_picture().isNull() && !view.making_ready(); }));
    const QImage before = view.picture();
    page.start();
    drawn(page, 3);
    const PictureDifference apart = picture_difference(before, view.picture());
    EXPECT_LT(apart.mean_grey, 1.0) << name;
    EXPECT_LT(apart.share_off, 0.01) << name;
  };
  {
    MainWindow window;
    open(window, "busy");  // no ghost goes before
    same(window.trial_page(), window.trial_page().operator_view(), "operator");
    window.close();
  }
  for (const bool video : {true, false}) {
    MainWindow window;
    open(window, "helped");
    TrialPage& page = window.trial_page();
    page.panels().dock(TrialPanels::video)->toggleViewAction()->trigger();
    QDockWidget* dock = page.panels().dock(video ? TrialPanels::video : TrialPanels::cut);
    dock->raise();
    auto* view = dock->findChild<GlView*>();
    ASSERT_TRUE(wait_for([&] { return view->isValid() && !view->visibleRegion().isEmpty(); }));
    same(page, *view, video ? "video" : "cut");
    window.close();
  }
}

TEST_F(WindowPanels, WhatTheEducatorClosedStaysClosedAndIsNotForgottenOver) {
  {
    MainWindow window;
    open(window, "busy");  // no cut, no bars, and questions
    TrialPanels& panels = window.trial_page().panels();
    for (const auto panel : {TrialPanels::cut, TrialPanels::force}) {
      QAction* action = panels.dock(panel)->toggleViewAction();
      EXPECT_FALSE(panels.dock(panel)->isVisible());
      EXPECT_FALSE(action->isEnabled());
      key(window.trial_page(), Qt::Key_1 + panel, Qt::AltModifier);
      QApplication::processEvents();
      EXPECT_FALSE(panels.dock(panel)->isVisible());
      EXPECT_TRUE(action->toolTip().contains("does not show it"));
    }
    EXPECT_TRUE(panels.dock(TrialPanels::team)->isVisible());
    panels.restore_first();
    QApplication::processEvents();
    EXPECT_FALSE(panels.dock(TrialPanels::cut)->isVisible()) << "nor by this way";
    EXPECT_TRUE(panels.dock(TrialPanels::team)->isVisible());
    window.close();
  }
  MainWindow window;
  open(window, "helped");
  EXPECT_TRUE(window.trial_page().panels().dock(TrialPanels::cut)->isVisible()) << "the next trial has it again";
}

TEST_F(WindowPanels, AnInstructorsSentenceHidesNoQuestion) {
  MainWindow window;
  open(window, "busy");
  TrialPage& page = window.trial_page();
  page.start();
  auto* panel = page.findChild<DistractionPanel*>();
  const auto shows = [&](const QString& words) {
    for (const auto* label : panel->findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(words) && !label->visibleRegion().isEmpty()) return true;
    return false;
  };
  ASSERT_TRUE(wait_for([&] { return shows("How long has it been?"); }, 15000));
  page.say("Compressions <now>");
  QApplication::processEvents();
  EXPECT_TRUE(shows("Compressions &lt;now&gt;"));
  EXPECT_TRUE(shows("Instructor"));
  EXPECT_TRUE(shows("How long has it been?")) << "it is still to be answered";
  keep_picture(window, "panels-said.png");
  ASSERT_TRUE(wait_for([&] { return !shows("Compressions"); }, DistractionPanel::kSaidMs + 4000));
}

TEST_F(WindowPanels, WhereNobodyIsHeardTheTeamComesWithItsFirstWord) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  EXPECT_FALSE(page.panels().dock(TrialPanels::team)->isVisible());
  page.say("Well seen.");
  QApplication::processEvents();
  EXPECT_TRUE(page.panels().dock(TrialPanels::team)->isVisible());
}

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

TEST_F(WindowPanels, WhatWasTakenOutOfTheWindowGoesWithTheTrialAndComesBackWithTheNext) {
  {
    MainWindow window;
    open(window, "helped");
    TrialPage& page = window.trial_page();
    QDockWidget* cut = page.panels().dock(TrialPanels::cut);
    cut->setFloating(true);
    page.start();
    drawn(page, 3);
    EXPECT_TRUE(cut->isVisible() && cut->isFloating());
    key(page, Qt::Key_F1);
    QPointer<QDialog> list = page.findChild<QDialog*>("key_list");
    ASSERT_TRUE(list && list->isVisible());
    page.end("ended by trainee");
    EXPECT_FALSE(list && list->isVisible()) << "it is of the page that is left";
    ASSERT_TRUE(wait_for([&] { return window.page_name() == "result"; }));
    EXPECT_FALSE(cut->isVisible()) << "its picture is of a trial that is over";
    EXPECT_TRUE(cut->isFloating());
    open(window, "helped");
    EXPECT_TRUE(cut->isVisible() && cut->isFloating()) << "where it was";
    emit page.left();
    EXPECT_EQ(page.session(), nullptr);
    EXPECT_FALSE(cut->isVisible()) << "left before the start";
    window.close();
  }
  MainWindow window;
  window.show();
  QApplication::processEvents();
  QDockWidget* cut = window.trial_page().panels().dock(TrialPanels::cut);
  EXPECT_TRUE(cut->isFloating()) << "remembered";
  EXPECT_FALSE(cut->isVisible()) << "there is no trial to be seen in it";
  open(window, "helped");
  EXPECT_TRUE(cut->isVisible() && cut->isFloating());
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

TEST_F(WindowPanels, TheListOfKeysIsTheTableTheyAreTakenBy) {
  MainWindow window;
  open(window, "helped");
  TrialPage& page = window.trial_page();
  page.setFocus();
  key(page, Qt::Key_F1);
  auto* list = page.findChild<QDialog*>("key_list");
  ASSERT_NE(list, nullptr);
  const QString text = list->findChild<QTextBrowser*>()->toPlainText();
  for (const char* name : {"Ctrl+Left", "PgUp", "Space", "F1", "Alt+2", "Esc"}) EXPECT_TRUE(text.contains(name)) << name;
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

TEST_F(WindowPanels, FitTheSmallestWindowAndTheUsual) {
  MainWindow window;
  for (const QSize size : {QSize(1280, 800), QSize(1024, 700)}) {
    window.resize(size);
    open(window, "helped");
    TrialPage& page = window.trial_page();
    page.start();
    drawn(page, 12);
    EXPECT_EQ(window.size(), size) << "it did not have to grow";
    EXPECT_GE(page.operator_view().width(), size.width() / 2);
    EXPECT_GE(page.operator_view().height(), size.height() / 2);
    const QRect all(QPoint(0, 0), window.size());
    for (const auto panel : {TrialPanels::cut, TrialPanels::force, TrialPanels::readings}) {
      QDockWidget* dock = page.panels().dock(panel);
      EXPECT_TRUE(dock->isVisible());
      EXPECT_TRUE(all.contains(QRect(dock->mapTo(&window, QPoint(0, 0)), dock->size())));
      EXPECT_GE(dock->widget()->height(), dock->widget()->minimumSizeHint().height());
    }
    keep_picture(window, "panels-" + std::to_string(size.width()) + ".png");
    page.end("ended by trainee");
    ASSERT_TRUE(wait_for([&] { return window.page_name() == "result"; }));
    keep_picture(window, "result-" + std::to_string(size.width()) + ".png");
  }
}

/// Of the shipped course with a tube, on its manikin.
class WindowPanelsOfATube : public WindowPanels {
 protected:
  static void SetUpTestSuite() {
    WindowPanels::SetUpTestSuite();
    // From the cache that all tests share, before each has a home of its own.
    manikin_ = builtin_patient(
        curricula::load_curriculum(curricula_folder() / "first-intubation.yaml").scenarios.front().manikin, {});
  }
  static inline std::filesystem::path manikin_;
  void open_tube(MainWindow& window) {
    const auto file = curricula_folder() / "first-intubation.yaml";
    const curricula::Curriculum course = curricula::load_curriculum(file);
    TrialSetup setup;
    setup.curriculum = file;
    setup.scenario = course.scenarios.front().id;
    setup.device = "mouse";
    setup.patient = manikin_;
    setup.out = box_ / "tube";
    user_settings()->setValue("mouse/introduced-tube", true);
    window.show();
    bool ready = false;
    QString failure;
    QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
    QObject::connect(&window, &MainWindow::trial_failed, [&](const QString& message) { failure = message; });
    window.prepare(setup, false);
    ASSERT_TRUE(wait_for([&] { return ready || !failure.isEmpty(); }));
    ASSERT_EQ(failure.toStdString(), "");
  }
};

TEST_F(WindowPanelsOfATube, TheExpertIsSeenWhileTheTrialWaitsAndThenItGoesOn) {
  MainWindow window;
  window.resize(1280, 800);
  open_tube(window);
  TrialPage& page = window.trial_page();
  page.start();
  drawn(page, 5);
  EXPECT_TRUE(page.findChild<SoundButton*>()->isVisible());
  page.panels().dock(TrialPanels::video)->toggleViewAction()->trigger();
  const auto says = [&](const QString& words) {
    for (const auto* label : page.findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(words)) return true;
    return false;
  };
  const QImage before = page.operator_view().picture();
  key(page, Qt::Key_G);
  EXPECT_TRUE(page.expert_shown());
  EXPECT_TRUE(page.session()->frozen());
  EXPECT_TRUE(page.session()->actions().held(engine::kActionAided)) << "the log has it";
  ASSERT_TRUE(wait_for([&] { return says("Expert - your trial waits"); }, 60000));
  // The expert's blade comes in: another picture than the one where the trial stands.
  ASSERT_TRUE(wait_for([&] { return difference(before, page.operator_view().picture()).pixels > 4000; }, 60000));
  auto* bars = page.panels().findChild<ForceBars*>();
  ASSERT_NE(bars, nullptr);
  const double own_peak_n = bars->tongue_peak_n();
  const auto expert_presses = [&] {
    const QString now = bars->accessibleDescription();
    return now.startsWith("An expert's") && !now.contains("tongue 0.0 N");
  };
  ASSERT_TRUE(wait_for(expert_presses, 60000)) << bars->accessibleDescription().toStdString();
  EXPECT_EQ(bars->tongue_peak_n(), own_peak_n) << "the trainee's own stays";
  EXPECT_TRUE(says(" of 20 s")) << "how far the loop is";
  EXPECT_TRUE(says("back to your trial"));
  keep_picture(window, "expert.png");
  const double waited_from_s = page.session()->paused_s();
  ASSERT_TRUE(wait_for([&] { return page.session()->paused_s() > waited_from_s + 0.3; }, 20000)) << "its clock stands";
  key(page, Qt::Key_Escape);
  EXPECT_FALSE(page.expert_shown());
  EXPECT_TRUE(page.running()) << "Esc ended the loop alone";
  EXPECT_FALSE(page.session()->frozen());
  EXPECT_FALSE(says("your trial waits"));
  EXPECT_FALSE(page.session()->actions().held(engine::kActionAided));
  ASSERT_TRUE(wait_for([&] { return page.session()->pause().empty(); }, 20000)) << "the hand has hold again";
  key(page, Qt::Key_F);
  EXPECT_TRUE(page.running());
  drawn(page, 3);
  ASSERT_TRUE(wait_for([&] { return !page.session()->led_in(); }, 60000));
  drawn(page, 3);
  EXPECT_TRUE(page.operator_view().blade_in());
  keep_picture(window, "from-vallecula.png");
}

TEST_F(WindowPanelsOfATube, AllPanelsFitTheSmallestWindowAndTheUsual) {
  MainWindow window;
  for (const QSize size : {QSize(1280, 800), QSize(1024, 700)}) {
    window.resize(size);
    open_tube(window);
    TrialPage& page = window.trial_page();
    page.panels().restore_first();
    page.start();
    drawn(page, 20);
    EXPECT_EQ(window.size(), size);
    keep_picture(window, "tube-first-" + std::to_string(size.width()) + ".png");
    // Somebody speaks: beside a view where there is room for both, else before it until the sentence has been read.
    const auto seen = [&](TrialPanels::Panel panel) {
      return !page.panels().dock(panel)->widget()->visibleRegion().isEmpty();
    };
    const bool both = size.height() > 700;
    page.panels().distractions().set_said_for(600000);  // however slow the machine, it is still said below
    page.say("Well seen.");
    ASSERT_TRUE(wait_for([&] { return seen(TrialPanels::team) && seen(TrialPanels::cut) == both; }, 20000));
    drawn(page, 5);
    EXPECT_EQ(seen(TrialPanels::cut), both);
    EXPECT_GE(page.panels().dock(TrialPanels::force)->widget()->height(),
              page.findChild<ForceBars*>()->minimumSizeHint().height());
    keep_picture(window, "tube-said-" + std::to_string(size.width()) + ".png");
    page.panels().distractions().set_said_for(1);
    page.say("Well seen.");
    EXPECT_TRUE(wait_for([&] { return seen(TrialPanels::cut); }, 20000)) << "read";
    page.panels().distractions().set_said_for(DistractionPanel::kSaidMs);
    page.panels().dock(TrialPanels::team)->toggleViewAction()->trigger();
    for (const auto panel : {TrialPanels::video, TrialPanels::team}) page.panels().dock(panel)->toggleViewAction()->trigger();
    page.say("Bag valve mask is ready on your right.");
    drawn(page, 20);
    EXPECT_EQ(window.size(), size) << "all panels at once as well";
    keep_picture(window, "tube-all-" + std::to_string(size.width()) + ".png");
    page.close_trial();
  }
}

TEST_F(WindowPanelsOfATube, AfterASentenceTheViewIsThereThatWasWatched) {
  MainWindow window;
  window.resize(1024, 700);
  open_tube(window);
  TrialPage& page = window.trial_page();
  TrialPanels& panels = page.panels();
  panels.restore_first();
  panels.dock(TrialPanels::video)->toggleViewAction()->trigger();
  panels.distractions().set_said_for(600000);
  const auto seen = [&](TrialPanels::Panel panel) {
    return wait_for([&] { return !panels.dock(panel)->widget()->visibleRegion().isEmpty(); }, 20000);
  };
  const auto only = [&](TrialPanels::Panel panel) {
    EXPECT_TRUE(seen(panel));
    QApplication::processEvents();
    for (const auto other : {TrialPanels::cut, TrialPanels::video, TrialPanels::team})
      EXPECT_EQ(panels.dock(other)->widget()->visibleRegion().isEmpty(), other != panel) << other;
  };
  const auto read = [&] {
    emit panels.distractions().silent();
    QApplication::processEvents();
  };
  only(TrialPanels::video);
  for (const auto watched : {TrialPanels::video, TrialPanels::cut, TrialPanels::video}) {
    panels.dock(watched)->raise();
    only(watched);
    page.say("Well seen.");
    ASSERT_TRUE(wait_for([&] { return panels.dock(watched)->widget()->visibleRegion().isEmpty(); }, 20000));
    only(TrialPanels::team);
    page.say("And on.");  // before the first was read
    read();
    only(watched);
  }
  // Whoever looks at another view meanwhile keeps it, and so does whoever closes the team's panel.
  page.say("Well seen.");
  only(TrialPanels::team);
  panels.dock(TrialPanels::cut)->raise();
  only(TrialPanels::cut);
  read();
  only(TrialPanels::cut);
  panels.dock(TrialPanels::video)->raise();
  only(TrialPanels::video);
  page.say("Well seen.");
  only(TrialPanels::team);
  panels.dock(TrialPanels::team)->close();
  panels.dock(TrialPanels::cut)->raise();
  only(TrialPanels::cut);
  read();
  only(TrialPanels::cut);
  // With room for both the team stands on top, as at first.
  panels.dock(TrialPanels::team)->toggleViewAction()->trigger();
  panels.dock(TrialPanels::cut)->raise();
  only(TrialPanels::cut);
  window.resize(1280, 800);
  ASSERT_TRUE(wait_for([&] { return panels.tabifiedDockWidgets(panels.dock(TrialPanels::team)).isEmpty(); }, 20000));
  EXPECT_TRUE(seen(TrialPanels::team) && seen(TrialPanels::cut));
  const auto top = [&](TrialPanels::Panel panel) { return panels.dock(panel)->geometry().top(); };
  EXPECT_TRUE(wait_for([&] { return top(TrialPanels::team) < top(TrialPanels::cut); }, 20000));
  EXPECT_LT(top(TrialPanels::cut), top(TrialPanels::force));
  EXPECT_LT(top(TrialPanels::force), top(TrialPanels::readings));
  keep_picture(window, "tube-team-on-top.png");
}

}  // namespace
}  // namespace vallecula::gui::window_test
