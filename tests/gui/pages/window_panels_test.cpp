// The trial page's panels: switched by key and menu, moved, remembered, closed by what the scenario allows; the helps
// beside them; what is said; and the list of keys, which is the table they are taken by.
#include "tests/gui/pages/window_panels.h"

#include <QAction>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QScreen>
#include <QtTest/QTest>

#include "gui/pages/distraction_panel.h"
#include "gui/pages/main_window.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/session/user_settings.h"
#include "gui/views/gl_view.h"
#include "gui/views/operator_view.h"
#include "tests/gui/picture_difference.h"

namespace vallecula::gui::window_test {
namespace {

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

TEST_F(WindowPanels, WhatWasSaidOpensTheTeamInItsTrialAndIsNoChoiceForOthers) {
  const auto team_is_seen = [](MainWindow& window) {
    QApplication::processEvents();
    return window.trial_page().panels().dock(TrialPanels::team)->isVisible();
  };
  {
    MainWindow window;
    open(window, "helped");
    TrialPage& page = window.trial_page();
    page.say("Well seen.");
    EXPECT_TRUE(team_is_seen(window));
    page.hide();
    page.show();
    EXPECT_TRUE(team_is_seen(window)) << "the page was left and is back";
    page.panels().restore_first();
    EXPECT_TRUE(team_is_seen(window)) << "as at first it has been said too";
    page.panels().dock(TrialPanels::team)->close();
    page.hide();
    page.show();
    EXPECT_FALSE(team_is_seen(window)) << "whoever closed it does not get it again";
    page.panels().restore_first();
    EXPECT_TRUE(team_is_seen(window));
    page.close_trial();
  }
  MainWindow next;
  open(next, "helped");
  EXPECT_FALSE(team_is_seen(next)) << "nobody has said anything to the next one";
}

TEST_F(WindowPanels, WhatLeavesTheWindowLiesOverNoOtherPanel) {
  MainWindow window;
  open(window, "helped");
  TrialPanels& panels = window.trial_page().panels();
  const auto place = [&](TrialPanels::Panel panel) {
    const QDockWidget* dock = panels.dock(panel);
    return dock->isFloating() ? dock->frameGeometry() : QRect(dock->mapToGlobal(QPoint(0, 0)), dock->size());
  };
  for (const TrialPanels::Panel out : {TrialPanels::force, TrialPanels::cut}) {
    panels.dock(out)->setFloating(true);
    const auto free = [&] {
      for (const TrialPanels::Panel other : {TrialPanels::force, TrialPanels::cut, TrialPanels::readings})
        if (other != out && place(out).intersects(place(other))) return false;
      return window.screen()->geometry().contains(place(out));
    };
    for (int i = 0; i < 5; ++i)
      QApplication::processEvents(QEventLoop::AllEvents, 20);  // it is put there once it is out
    EXPECT_TRUE(wait_for(free, 5000)) << out;
  }
  const QRect chosen(60, 70, panels.dock(TrialPanels::cut)->width(), panels.dock(TrialPanels::cut)->height());
  panels.dock(TrialPanels::cut)->move(chosen.topLeft());
  for (int i = 0; i < 5; ++i) QApplication::processEvents(QEventLoop::AllEvents, 20);
  panels.dock(TrialPanels::cut)->setFloating(false);
  QApplication::processEvents();
  panels.dock(TrialPanels::cut)->setFloating(true);
  for (int i = 0; i < 10; ++i) QApplication::processEvents(QEventLoop::AllEvents, 20);
  EXPECT_EQ(panels.dock(TrialPanels::cut)->pos(), chosen.topLeft()) << "where a person had put it";
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
}  // namespace
}  // namespace vallecula::gui::window_test
