// The panels of a trial with a tube: what they show while an expert is looked at, how they share a window's room, and
// which view is in front after a sentence.
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QtTest/QTest>

#include "gui/pages/distraction_panel.h"
#include "gui/pages/look_settings.h"
#include "gui/pages/main_window.h"
#include "gui/pages/sound_button.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"
#include "gui/views/force_bars.h"
#include "gui/views/monitor_panel.h"
#include "gui/views/operator_view.h"
#include "gui/views/trial_readings.h"
#include "tests/gui/accessible.h"
#include "tests/gui/pages/window_panels.h"
#include "tests/gui/painted_words.h"
#include "tests/gui/picture_difference.h"

namespace vallecula::gui::window_test {
namespace {

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
  EXPECT_TRUE(says("Your attempt") && says("Glottis visible: expert") && says("expert: "))
      << "beside the expert's forces nothing of one's own passes for his";
  QStringList on_monitor;
  for (const PaintedWord& word : painted_words(*page.panels().findChild<MonitorPanel*>())) on_monitor << word.text;
  EXPECT_TRUE(on_monitor.contains("by itself")) << "the scenario has an infant that breathes";
  EXPECT_TRUE(on_monitor.contains("Your own infant: its time stands meanwhile")) << on_monitor.join(", ").toStdString();
  EXPECT_EQ(cut_texts(page.panels().readings_panel()), std::vector<std::string>());
  keep_picture(window, "expert.png");
  const double waited_from_s = page.session()->paused_s();
  ASSERT_TRUE(wait_for([&] { return page.session()->paused_s() > waited_from_s + 0.3; }, 20000)) << "its clock stands";
  key(page, Qt::Key_Escape);
  EXPECT_FALSE(page.expert_shown());
  EXPECT_TRUE(page.running()) << "Esc ended the loop alone";
  EXPECT_FALSE(page.session()->frozen());
  EXPECT_FALSE(says("your trial waits"));
  drawn(page, 1);
  EXPECT_FALSE(says("Your attempt") || says("expert: "));
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

/// The text's size for the time being.
struct TextScale {
  explicit TextScale(double text_scale) {
    LookSettings look;
    look.text_scale = text_scale;
    apply_look(look);
  }
  ~TextScale() { apply_look({}); }
};

TEST_F(WindowPanelsOfATube, AllPanelsFitTheSmallestWindowAndTheUsual) {
  MainWindow window;
  // With larger text there is no room for a sentence beside a view in the smallest window.
  for (const auto& [size, text_scale] :
       {std::pair{QSize(1280, 800), 1.0}, {QSize(1024, 700), 1.0}, {QSize(1024, 700), 1.2}}) {
    const bool both = text_scale == 1.0;
    const TextScale text(text_scale);
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
    const auto left = [&] {
      QStringList lines;
      for (const auto* label : page.panels().distractions().findChildren<QLabel*>())
        if (!label->isHidden()) lines << label->text();
      return lines;
    };
    EXPECT_TRUE(wait_for([&] { return left() == QStringList("Said before: Well seen."); }, 20000))
        << "and not that nobody has said anything";
    if (!both) {
      page.close_trial();
      continue;
    }
    page.panels().distractions().set_said_for(DistractionPanel::kSaidMs);
    page.panels().dock(TrialPanels::team)->toggleViewAction()->trigger();
    for (const auto panel : {TrialPanels::video, TrialPanels::team})
      page.panels().dock(panel)->toggleViewAction()->trigger();
    page.say("Bag valve mask is ready on your right.");
    drawn(page, 20);
    EXPECT_EQ(window.size(), size) << "all panels at once as well";
    keep_picture(window, "tube-all-" + std::to_string(size.width()) + ".png");
    page.close_trial();
  }
}

TEST_F(WindowPanelsOfATube, AfterASentenceTheViewIsThereThatWasWatched) {
  const TextScale text(1.2);  // with smaller text there is room for both
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
