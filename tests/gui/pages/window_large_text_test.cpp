// With text a third larger, and in German, nothing on the trial page is cut: neither the words of its widgets nor those
// that are painted; and the picture stays the largest.
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTest>

#include "gui/pages/chart_view.h"
#include "gui/pages/distraction_panel.h"
#include "gui/pages/look_settings.h"
#include "gui/pages/mouse_introduction.h"
#include "gui/pages/result_page.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/languages.h"
#include "gui/session/user_paths.h"
#include "gui/views/force_bars.h"
#include "gui/views/monitor_panel.h"
#include "gui/views/operator_view.h"
#include "gui/views/trial_readings.h"
#include "tests/gui/accessible.h"
#include "tests/gui/pages/window_panels.h"
#include "tests/gui/painted_words.h"

namespace vallecula::gui::window_test {
namespace {

struct Words {
  const char* language;
  double scale;
};

class WindowLargeTextOfATube : public WindowPanels, public ::testing::WithParamInterface<Words> {
 protected:
  static void SetUpTestSuite() {
    WindowPanels::SetUpTestSuite();
    // From the cache that all tests share, before each has a home of its own.
    manikin_ = builtin_patient(
        curricula::load_curriculum(curricula_folder() / "first-intubation.yaml").scenarios.front().manikin, {});
  }
  WindowLargeTextOfATube() {
    LookSettings look;
    look.text_scale = GetParam().scale;
    keep_look(look);
    apply_look(look);
    EXPECT_TRUE(install_language(*qApp, GetParam().language));
  }
  ~WindowLargeTextOfATube() override {
    apply_look({});
    install_language(*qApp, "en");
  }
  std::string name_of(const std::string& what) const {
    return "large-" + what + "-" + GetParam().language + "-" + std::to_string(std::lround(100 * GetParam().scale)) +
           ".png";
  }
  void open_tube(MainWindow& window, bool introduced = true) {
    const auto file = curricula_folder() / "first-intubation.yaml";
    TrialSetup setup;
    setup.curriculum = file;
    setup.scenario = curricula::load_curriculum(file).scenarios.front().id;
    setup.device = "mouse";
    setup.patient = manikin_;
    setup.out = box_ / "tube";
    user_settings()->setValue("mouse/introduced-tube", introduced);
    window.resize(1280, 800);
    window.show();
    bool ready = false;
    const auto heard = QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
    window.prepare(setup, false);
    ASSERT_TRUE(wait_for([&] { return ready; }));
    QObject::disconnect(heard);
  }
  /// All of the page's words, of widgets and painted.
  void look_at(MainWindow& window, const std::string& when) {
    const TrialPage& page = window.trial_page();
    wait_for([&] { return cut_texts(page).empty(); }, 5000);  // once all has its place
    EXPECT_EQ(window.size(), QSize(1280, 800)) << when << ": the window did not grow";
    EXPECT_EQ(cut_texts(page), std::vector<std::string>()) << when << lines(cut_texts(page));
    for (QWidget* painted : {static_cast<QWidget*>(page.findChild<ForceBars*>()),
                             static_cast<QWidget*>(page.findChild<MonitorPanel*>())}) {
      const auto trouble = trouble_of(painted_words(*painted), painted->size());
      EXPECT_EQ(trouble, std::vector<std::string>()) << when << lines(trouble);
    }
    for (const QWidget* part : {static_cast<const QWidget*>(page.findChild<ForceBars*>()),
                                static_cast<const QWidget*>(page.findChild<TrialReadings*>())})
      EXPECT_GE(part->width(), part->minimumSizeHint().width()) << when;
    const QSize picture = page.findChild<OperatorView*>()->size();
    EXPECT_GT(picture.width(), 0.55 * window.width()) << when;
    for (const auto panel : {TrialPanels::cut, TrialPanels::video, TrialPanels::force, TrialPanels::readings}) {
      const QSize beside = const_cast<TrialPage&>(page).panels().dock(panel)->widget()->size();
      EXPECT_GT(picture.width() * picture.height(), beside.width() * beside.height()) << when << ": " << panel;
    }
    keep_picture(window, name_of(when));
  }
  static inline std::filesystem::path manikin_;
};

TEST_P(WindowLargeTextOfATube, NothingOnTheTrialPageIsCut) {
  MainWindow window;
  open_tube(window);
  TrialPage& page = window.trial_page();
  TrialPanels& panels = page.panels();
  drawn(page, 0);
  look_at(window, "before");
  page.start();
  drawn(page, 10);
  look_at(window, "begun");
  EXPECT_GE(panels.dock(TrialPanels::cut)->widget()->height(), 100);
  // Every mark of the bars is named.
  QStringList painted;
  for (const PaintedWord& word : painted_words(*page.findChild<ForceBars*>())) painted << word.text;
  for (const char* mark : {"target %1", "pass limit %1", "device limit %1"}) {
    const QString name = ForceBars::tr(mark).section('%', 0, 0);
    EXPECT_TRUE(std::any_of(painted.begin(), painted.end(), [&](const QString& one) { return one.contains(name); }))
        << mark << " in " << painted.join(", ").toStdString();
  }
  // The catheter's button says more than before, and the picture stays where it is.
  const QRect picture = page.operator_view().geometry();
  key(page, Qt::Key_C);
  drawn(page, 20);
  EXPECT_EQ(page.operator_view().geometry(), picture);
  look_at(window, "catheter");
  panels.distractions().set_said_for(600000);
  page.say(
      "Lift along the handle, do not lever: the upper gum bears nothing, and the tip stays in the vallecula until you "
      "see the cords. Then wait for the tube.");
  drawn(page, 10);
  ASSERT_TRUE(wait_for([&] { return !panels.distractions().visibleRegion().isEmpty(); }, 20000));
  look_at(window, "said");
  panels.dock(TrialPanels::video)->toggleViewAction()->trigger();
  drawn(page, 10);
  look_at(window, "all");
  // Of docks behind one another each name is whole.
  for (const QTabBar* tabs : panels.findChildren<QTabBar*>())
    for (int i = 0; i < tabs->count(); ++i)
      if (!tabs->visibleRegion().isEmpty())
        EXPECT_GE(tabs->tabRect(i).width(), tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)))
            << tabs->tabText(i).toStdString();
  page.close_trial();
}

TEST_P(WindowLargeTextOfATube, TheCardThatIntroducesTheMouseShowsAllItsWords) {
  MainWindow window;
  open_tube(window, false);
  TrialPage& page = window.trial_page();
  drawn(page, 0);
  const auto* card = page.findChild<MouseIntroduction*>();
  ASSERT_NE(card, nullptr);
  ASSERT_TRUE(wait_for([&] { return !card->visibleRegion().isEmpty(); }, 20000));
  const auto* words = card->findChild<QScrollArea*>();
  ASSERT_NE(words, nullptr);
  EXPECT_TRUE(wait_for([&] { return words->verticalScrollBar()->maximum() == 0; }, 5000))
      << words->verticalScrollBar()->maximum() << " px are not seen";
  EXPECT_TRUE(page.rect().contains(QRect(card->mapTo(&page, QPoint()), card->size())));
  for (const auto panel : {TrialPanels::cut, TrialPanels::force, TrialPanels::readings}) {
    const QWidget* beside = page.panels().dock(panel)->widget();
    EXPECT_FALSE(QRect(card->mapToGlobal(QPoint()), card->size())
                     .intersects(QRect(beside->mapToGlobal(QPoint()), beside->size())))
        << "it speaks of what stands beside it";
  }
  keep_picture(window, name_of("introduction"));
  page.close_trial();
}

TEST_P(WindowLargeTextOfATube, TheLongestReadingsStandInTwoLinesAndNoneIsCut) {
  TrialReadings readings;
  readings.show_tube(true);
  engine::Snapshot snapshot;
  snapshot.has_intubation = true;
  snapshot.intubation.in_hand = engine::InHand::catheter;
  snapshot.intubation.at_mouth_m = 0.128;
  snapshot.intubation.model_force_n = {10.4, 0.0, 0.0};
  snapshot.state = engine::HapticState::recovering;
  snapshot.loop_rate_hz = 1000.0;
  snapshot.ticks = 240000;
  snapshot.deadline_misses = 12345;
  snapshot.overruns = 12345;
  snapshot.glottis_visible = 1.0;
  readings.show_snapshot(snapshot);
  readings.show_drawing(30.0, "less");
  readings.resize(readings.minimumSizeHint().width(), 10);
  readings.resize(readings.width(), readings.heightForWidth(readings.width()));
  readings.show();
  QApplication::processEvents();
  EXPECT_LE(readings.width(), 0.36 * 1260) << "in the side's width";
  EXPECT_EQ(cut_texts(readings), std::vector<std::string>()) << lines(cut_texts(readings));
  keep_picture(readings, name_of("readings"));
}

TEST_P(WindowLargeTextOfATube, AQuestionsAnswersStandBelowOneAnotherWhereTheyAreLong) {
  MainWindow window;
  open(window, "busy");  // with questions
  TrialPage& page = window.trial_page();
  page.start();
  ASSERT_TRUE(wait_for(
      [&] {
        const auto buttons = page.panels().distractions().findChildren<QPushButton*>();
        return std::any_of(buttons.begin(), buttons.end(), [](const QPushButton* one) { return one->isVisible(); });
      },
      60000));
  QApplication::processEvents();
  EXPECT_EQ(cut_texts(page), std::vector<std::string>()) << lines(cut_texts(page));
  keep_picture(window, name_of("asked"));
  page.close_trial();
}

INSTANTIATE_TEST_SUITE_P(Words, WindowLargeTextOfATube,
                         ::testing::Values(Words{"en", 1.35}, Words{"de", 1.35}, Words{"de", 1.0}),
                         [](const auto& tested) {
                           return std::string(tested.param.language) +
                                  std::to_string(static_cast<int>(100 * tested.param.scale + 0.5));
                         });

}  // namespace
}  // namespace vallecula::gui::window_test
