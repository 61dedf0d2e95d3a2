// The window plays what a scenario says: distractions, helps, assessment with the own rating first, attempts that are
// drawn, modules that open.
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>
#include <cstdlib>

#include "curricula/records/ratings.h"
#include "curricula/trial_log.h"
#include "gui/pages/distraction_panel.h"
#include "gui/pages/main_window.h"
#include "gui/pages/result_page.h"
#include "gui/pages/self_rating_page.h"
#include "gui/pages/trial_page.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/user_paths.h"
#include "gui/views/force_bars.h"
#include "gui/views/operator_view.h"
#include "gui/views/sagittal_view.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/busy_course.h"
#include "tests/gui/program.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

using Kind = curricula::LogEvent::Kind;

/// How often a signal came.
struct Count {
  template <class Object, class Signal>
  Count(Object* object, Signal signal) {
    QObject::connect(object, signal, [this] { ++times; });
  }
  int times = 0;
};

class WindowPlaying : public Screen {
 protected:
  WindowPlaying() { ::setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  TrialSetup setup(const std::string& scenario) {
    TrialSetup setup;
    setup.patient = patient_;
    setup.curriculum = course_;
    setup.scenario = scenario;
    setup.device = "mouse";
    setup.out = box_ / "out";
    return setup;
  }
  /// Opens the trial and starts it.
  void play(MainWindow& window, const TrialSetup& setup) {
    window.show();
    bool ready = false;
    const auto heard = QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
    window.prepare(setup, false);
    ASSERT_TRUE(wait_for([&] { return ready; }));
    QObject::disconnect(heard);
    window.trial_page().start();
    ASSERT_TRUE(window.trial_page().running());
  }
  static void press(QWidget& page, int code) {
    for (const auto type : {QEvent::KeyPress, QEvent::KeyRelease}) {
      QKeyEvent event(type, code, Qt::NoModifier);
      QApplication::sendEvent(&page, &event);
    }
  }
  static QPushButton* button(QWidget& of, const QString& words) {
    for (auto* one : of.findChildren<QPushButton*>())
      if (one->isVisible() && one->text().contains(words)) return one;
    return nullptr;
  }
  static bool shows(QWidget& of, const QString& words) {
    const auto labels = of.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* label) { return label->isVisible() && label->text().contains(words); });
  }
  test::Sandbox box_;
  const std::filesystem::path patient_ = test::write_block_patient(box_.folder());
  const std::filesystem::path course_ = test::write_busy_course(box_.folder());
};

TEST_F(WindowPlaying, AsksSoundsAndTalksBesideTheViewAndLogsTheAnswers) {
  MainWindow window;
  play(window, setup("busy"));
  TrialPage& page = window.trial_page();
  auto* panel = page.findChild<DistractionPanel*>();
  ASSERT_NE(panel, nullptr);
  EXPECT_TRUE(panel->isVisible());
  EXPECT_FALSE(page.sagittal_view().isVisible()) << "no cut in this scenario";
  EXPECT_FALSE(page.findChild<ForceBars*>()->isVisible()) << "no bars either";
  ASSERT_TRUE(wait_for([&] { return shows(*panel, "free now"); }, 15000));
  EXPECT_TRUE(shows(*panel, "How long has it been?")) << "without its marks";
  keep_picture(window, "distractions.png");
  const QRect view(page.operator_view().mapTo(&window, QPoint(0, 0)), page.operator_view().size());
  const QRect over(panel->mapTo(&window, QPoint(0, 0)), panel->size());
  EXPECT_FALSE(view.intersects(over)) << "nothing lies over the operator's view";
  press(page, Qt::Key_9);  // no such answer
  EXPECT_TRUE(shows(*panel, "Question"));
  press(page, Qt::Key_3);
  ASSERT_TRUE(wait_for([&] { return !shows(*panel, "Question"); }, 5000));
  QPushButton* silence = nullptr;  // the rows were laid out anew: it comes up with the next events
  ASSERT_TRUE(wait_for([&] { return (silence = button(*panel, "Silence (M)")) != nullptr; }, 5000));
  silence->click();
  ASSERT_TRUE(wait_for([&] { return !shows(*panel, "Alarm"); }, 5000));
  const Count finished(&window, &MainWindow::trial_finished);
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished.times > 0; }));
  EXPECT_EQ(window.page_name(), "result") << "practice: the score at once";
  const auto events = curricula::read_trial_log(box_ / "out").events;
  ASSERT_EQ(events.size(), 5u);
  const auto of = [&](Kind kind) {
    return std::find_if(events.begin(), events.end(), [&](const curricula::LogEvent& e) { return e.kind == kind; });
  };
  ASSERT_NE(of(Kind::answered), events.end());
  EXPECT_EQ(of(Kind::answered)->distraction, 1);
  EXPECT_EQ(of(Kind::answered)->answer, 3);
  ASSERT_NE(of(Kind::silenced), events.end());
  EXPECT_EQ(of(Kind::silenced)->distraction, 2);
}

TEST_F(WindowPlaying, ShowsHelpsInPracticeAndNoneInAssessmentWhereTheOwnRatingComesFirst) {
  {
    MainWindow window;
    play(window, setup("helped"));
    EXPECT_TRUE(window.trial_page().sagittal_view().isVisible());
    EXPECT_TRUE(window.trial_page().findChild<ForceBars*>()->isVisible());
    EXPECT_FALSE(window.trial_page().findChild<DistractionPanel*>()->isVisible()) << "there is nothing to be asked";
    ASSERT_TRUE(wait_for([&] { return window.trial_page().frames_per_second() > 0.0; }));
    keep_picture(window, "helps.png");
    window.close();
  }
  MainWindow window;
  TrialSetup assessed = setup("helped");
  assessed.mode = curricula::Mode::assessment;
  play(window, assessed);
  EXPECT_FALSE(window.trial_page().sagittal_view().isVisible());
  EXPECT_FALSE(window.trial_page().findChild<ForceBars*>()->isVisible());
  TrialOutcome outcome;
  bool finished = false;
  QObject::connect(&window, &MainWindow::trial_finished, [&](const TrialOutcome& given) {
    outcome = given;
    finished = true;
  });
  engine::Snapshot last;
  window.trial_page().set_frame_hook([&](const engine::Snapshot& snapshot) { last = snapshot; });
  ASSERT_TRUE(wait_for([&] { return last.step > 20; }));
  window.trial_page().end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
  EXPECT_EQ(window.page_name(), "rating") << "before anything of the score is seen";
  EXPECT_FALSE(outcome.replay_allowed);
  EXPECT_TRUE(outcome.by_person);
  auto* rating = window.findChild<SelfRatingPage*>();
  QApplication::processEvents();
  keep_picture(window, "self-rating.png");
  press(*rating, Qt::Key_Return);
  EXPECT_EQ(window.page_name(), "rating") << "nothing is chosen yet";
  press(*rating, Qt::Key_4);
  press(*rating, Qt::Key_Return);
  EXPECT_TRUE(wait_for([&] { return window.page_name() == "result"; }, 10000)) << "once the records have it";
  EXPECT_TRUE(shows(*window.findChild<ResultPage*>(), "replay stays locked"));
  curricula::Records records(box_.home() / "records.sqlite");
  const auto ratings = curricula::Ratings(records).of_trial({}, outcome.record_id);
  ASSERT_EQ(ratings.size(), 1u) << "no tube, so no question about it";
  EXPECT_EQ(ratings[0].by, "self");
  EXPECT_EQ(ratings[0].value, 4.0);
  const auto rows = records.newest(5);
  EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [&](const curricula::RecordRow& row) {
    return row.id == outcome.record_id && row.mode == curricula::Mode::assessment;
  }));
}

TEST_F(WindowPlaying, AnAssessmentThatWasBegunCounts) {
  MainWindow window;
  TrialSetup assessed = setup("helped");
  assessed.mode = curricula::Mode::assessment;
  play(window, assessed);
  TrialPage& page = window.trial_page();
  EXPECT_EQ(button(page, "Reset"), nullptr);
  EXPECT_FALSE(button(page, "Back")->isEnabled());
  engine::Snapshot last;
  page.set_frame_hook([&](const engine::Snapshot& snapshot) { last = snapshot; });
  ASSERT_TRUE(wait_for([&] { return last.step > 20; }));
  const Count finished(&window, &MainWindow::trial_finished);
  window.close();
  EXPECT_TRUE(window.isVisible());
  ASSERT_TRUE(wait_for([&] { return finished.times > 0; }));
  EXPECT_EQ(window.page_name(), "rating");
  const auto rows = curricula::Records(box_.home() / "records.sqlite").newest(5);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_TRUE(rows[0].score.complete);
  EXPECT_EQ(curricula::read_trial_log(box_ / "out").footer.ended, "ended by trainee");
  window.close();
  EXPECT_TRUE(window.isVisible()) << "the rating is asked for once more";
  EXPECT_TRUE(shows(*window.findChild<SelfRatingPage*>(), "rating is still missing"));
  window.close();
  EXPECT_FALSE(window.isVisible());
}

TEST_F(WindowPlaying, ATubesPlaceIsAskedForAsWell) {
  SelfRatingPage page;
  page.resize(1000, 700);
  curricula::Scenario scenario;
  scenario.title = "Tube 3.5 on a stylet";
  scenario.intubation.emplace();
  SelfRating given;
  int times = 0;
  QObject::connect(&page, &SelfRatingPage::rated, [&](const SelfRating& rating) {
    given = rating;
    ++times;
  });
  page.ask(scenario);
  page.show();
  QApplication::processEvents();
  for (const int key : {Qt::Key_2, Qt::Key_N}) press(page, key);
  press(page, Qt::Key_Return);
  EXPECT_EQ(times, 0) << "sure or not is still to be said";
  press(page, Qt::Key_S);
  keep_picture(page, "self-rating-tube.png");
  press(page, Qt::Key_Return);
  press(page, Qt::Key_3);
  press(page, Qt::Key_Return);
  ASSERT_EQ(times, 1) << "one answer until it is kept";
  EXPECT_EQ(given.global, 2);
  EXPECT_EQ(given.tube_in_trachea, false);
  EXPECT_EQ(given.sure, true);
  page.ask(scenario);
  press(page, Qt::Key_Return);
  EXPECT_EQ(times, 1) << "asked anew, nothing is chosen";
}

TEST_F(WindowPlaying, ModulesOpenOneAfterAnother) {
  MainWindow window;
  window.show_start({curricula::load_curriculum(course_),
                     curricula::load_curriculum(curricula_folder() / "neonatal-intubation.yaml")});
  window.show();
  open_course_page(window);
  StartPage& page = window.start_page();
  // What the records say comes later, and would take the place of what this test says was done.
  const Count answered(&window.records_page().desk(), &RecordsDesk::answered);
  ASSERT_TRUE(wait_for([&] { return answered.times > 0; }, 20000));
  ASSERT_TRUE(page.select("later", "mouse"));
  EXPECT_EQ(page.states(), (QStringList{"First things: open", "Later things: closed"}));
  QPushButton* go = button(page, "Prepare the trial");
  ASSERT_NE(go, nullptr);
  EXPECT_FALSE(go->isEnabled());
  EXPECT_TRUE(shows(page, "Opens after First things is mastered."));
  EXPECT_EQ(page.choice().mode, curricula::Mode::assessment) << "its module allows nothing else";
  const auto passed = [](const char* scenario, const char* device) {
    return curricula::PastResult{scenario, device, curricula::Mode::practice, true, 1};
  };
  page.set_past({{"busy-course", {passed("busy", "mouse"), passed("helped", "touch")}}});
  EXPECT_FALSE(go->isEnabled()) << "with another device it was another hand";
  page.set_past({}, true);
  EXPECT_TRUE(go->isEnabled()) << "an instructor may show anything";
  page.set_past({{"busy-course", {passed("busy", "mouse"), passed("helped", "mouse")}}});
  EXPECT_EQ(page.states(), (QStringList{"First things: mastered", "Later things: open"}));
  EXPECT_TRUE(go->isEnabled());
  EXPECT_EQ(page.choice().scenario.id, "later") << "what was chosen stays chosen";
  ASSERT_TRUE(page.select("busy", "mouse"));
  EXPECT_EQ(page.choice().mode, curricula::Mode::practice)
      << "where it may be had it is had, unless one chose the other";

  page.findChild<QComboBox*>("curriculum")->setCurrentIndex(1);
  QApplication::processEvents();
  EXPECT_EQ(page.states().size(), 5);
  EXPECT_EQ(page.choice().scenario.id, "way-in") << "where a beginner begins";
  EXPECT_TRUE(go->isEnabled());
  keep_picture(window, "start-course.png");
  ASSERT_TRUE(page.select("questions", "mouse"));
  EXPECT_FALSE(go->isEnabled());
  EXPECT_TRUE(shows(page, "recognised within 6 breaths"));
  keep_picture(window, "start-closed.png");
  ASSERT_TRUE(page.select("questions", "scripted:expert"));
  EXPECT_TRUE(go->isEnabled()) << "a scripted hand may be watched at anything";
  auto* tree = page.findChild<QTreeWidget*>();
  tree->setCurrentItem(tree->topLevelItem(0));
  QApplication::processEvents();
  EXPECT_TRUE(shows(page, "Bring the blade to the vallecula"));
  EXPECT_FALSE(go->isEnabled());
  keep_picture(window, "start-goals.png");
  page.findChild<QComboBox*>("device")->setCurrentIndex(0);
  tree->setCurrentItem(tree->topLevelItem(3));
  QApplication::processEvents();
  EXPECT_TRUE(shows(page, "Not validated"));
  keep_picture(window, "start-module.png");
}

TEST_F(WindowPlaying, AnAttemptIsDrawnAnewOrDoneAgain) {
  MainWindow window;
  window.show_start({curricula::load_curriculum(course_)});
  window.show();
  open_course_page(window);
  StartPage& page = window.start_page();
  page.add_patient(patient_, true);
  ASSERT_TRUE(page.select("helped", "mouse"));
  Count ready(&window, &MainWindow::prepared), finished(&window, &MainWindow::trial_finished);
  const auto play_it = [&] {
    ready.times = finished.times = 0;
    EXPECT_TRUE(wait_for([&] { return ready.times > 0; }));
    const std::uint32_t seed = window.trial_page().scenario().attempt.seed;
    engine::Snapshot last;
    window.trial_page().set_frame_hook([&](const engine::Snapshot& snapshot) { last = snapshot; });
    window.trial_page().start();
    EXPECT_TRUE(wait_for([&] { return last.step > 5; }));
    window.trial_page().end("ended by trainee");
    EXPECT_TRUE(wait_for([&] { return finished.times > 0; }));
    window.trial_page().set_frame_hook({});
    return seed;
  };
  button(page, "Prepare the trial")->click();
  const std::uint32_t first = play_it();
  EXPECT_NE(first, 0u);
  auto* result = window.findChild<ResultPage*>();
  EXPECT_TRUE(shows(*result, QString("Attempt seed %1").arg(first)));
  keep_picture(window, "result-attempt.png");
  button(*result, "Same attempt again")->click();
  EXPECT_EQ(play_it(), first);
  button(*result, "Next attempt")->click();
  EXPECT_NE(play_it(), first);
}

}  // namespace
}  // namespace vallecula::gui::window_test
