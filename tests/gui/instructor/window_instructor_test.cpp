// The instructor's second window beside a trial: what it shows, what it does to it, what is kept of the ticks.
#include "tests/gui/instructor/window_instructor.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "curricula/records/ratings.h"
#include "gui/instructor/instructor_controls.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/session/languages.h"
#include "gui/views/force_bars.h"
#include "gui/views/monitor_panel.h"
#include "gui/views/operator_view.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"
#include "tests/gui/accessible.h"
#include "tests/gui/arc_patient.h"
#include "tests/gui/picture_difference.h"

namespace vallecula::gui::window_test {
namespace {

TEST_F(WindowInstructor, WatchesAnIntubationAndActsOnIt) {
  open_with_course();
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000)) << "nobody has registered an instructor: anybody may";
  EXPECT_EQ(state(), "Waiting for a trial");
  EXPECT_FALSE(button("Freeze")->isEnabled());
  TrialSetup whole = setup("tube");
  whole.curriculum = test::write_tube_curriculum(box_.folder());
  whole.patient = test::write_arc_patient(box_.folder());
  prepare(whole);
  EXPECT_EQ(state(), "Prepared, not started");
  TrialPage& page = window_->trial_page();
  int frames = 0;
  QObject::connect(&page, &TrialPage::frame, [&] { ++frames; });
  QElapsedTimer running;
  running.start();
  page.start();
  ASSERT_TRUE(wait_for([&] { return second().drawn() >= 5; }, 20000));
  EXPECT_TRUE(state().startsWith("Running, 0:0")) << state().toStdString();
  EXPECT_LE(second().drawn(), 2 + running.elapsed() / 100) << "ten pictures a second, no more";
  EXPECT_LE(second().drawn(), frames);
  auto* view = second().findChild<OperatorView*>();
  EXPECT_GT(colours_in(view->picture()), 40) << "the patient, not an empty ground";

  // A click is held long enough to be seen by a servo that looks a thousand times a second.
  const auto held = [&](std::uint32_t action) {
    return page.session()->actions().held(static_cast<engine::Action>(action));
  };
  auto* lower = button("SpO2 \xe2\x96\xbc");
  ASSERT_NE(lower, nullptr);
  QElapsedTimer since;
  since.start();
  QTest::mouseClick(lower, Qt::LeftButton);
  EXPECT_TRUE(held(engine::kInstructorSaturationDown));
  ASSERT_TRUE(wait_for([&] { return !held(engine::kInstructorSaturationDown); }, 5000));
  EXPECT_GE(since.elapsed(), kLeastHoldMs - 1);
  EXPECT_TRUE(told("You lower the saturation"));
  QTest::mousePress(button("Heart \xe2\x96\xb2"), Qt::LeftButton);
  wait_for([] { return false; }, 2 * kLeastHoldMs);
  EXPECT_TRUE(held(engine::kInstructorHeartUp)) << "as long as it is pressed";
  QTest::mouseRelease(button("Heart \xe2\x96\xb2"), Qt::LeftButton);
  ASSERT_TRUE(wait_for([&] { return !held(engine::kInstructorHeartUp); }, 5000));
  QTest::keyClick(button("Laryngospasm"), Qt::Key_Space);
  EXPECT_TRUE(held(engine::kInstructorSpasm)) << "stays until it is pressed again";
  QTest::keyClick(button("Laryngospasm"), Qt::Key_Space);
  EXPECT_FALSE(held(engine::kInstructorSpasm));
  QTest::keyClick(button("Laryngospasm"), Qt::Key_Space);
  EXPECT_TRUE(held(engine::kInstructorSpasm));
  page.reset();
  ASSERT_TRUE(wait_for([&] { return told("Begun anew"); }, 10000));
  EXPECT_FALSE(button("Laryngospasm")->isChecked()) << "the new attempt's cords are nobody's";
  EXPECT_FALSE(held(engine::kInstructorSpasm));
  QTest::keyClick(button("Laryngospasm"), Qt::Key_Space);
  EXPECT_TRUE(held(engine::kInstructorSpasm)) << "and one press closes them again";
  QTest::keyClick(button("Laryngospasm"), Qt::Key_Space);

  // The team's line, typed.
  auto* line = second().findChild<InstructorControls*>()->findChild<QLineEdit*>();
  QTest::keyClicks(line, "The cords are closed.");
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_TRUE(told("The team says: The cords are closed."));
  EXPECT_TRUE(held(engine::kActionAided)) << "that one was told is in the log";
  EXPECT_TRUE(wait_for([&] { return !held(engine::kActionAided); }, 10000));
  EXPECT_TRUE(line->text().isEmpty());
  EXPECT_TRUE(wait_for(
      [&] {
        const auto now = page.findChildren<QLabel*>();
        return std::any_of(now.begin(), now.end(), [](const QLabel* label) {
          return label->isVisible() && label->text().contains("The cords are closed.");
        });
      },
      5000))
      << "on the trainee's screen";

  // Frozen, the trial's time stands.
  QTest::keyClick(&second(), Qt::Key_F5);
  if (!page.session()->frozen()) QTest::mouseClick(button("Freeze"), Qt::LeftButton);
  EXPECT_TRUE(page.session()->frozen());
  ASSERT_TRUE(wait_for([&] { return state().startsWith("FROZEN"); }, 5000)) << state().toStdString();
  const auto vital_signs = [&] { return QList<QPushButton*>{button("SpO2"), button("Heart"), button("Laryngospasm")}; };
  wait_for([&] { return !vital_signs().front()->isEnabled(); }, 5000);  // told with the next picture
  for (const QPushButton* vital : vital_signs()) {
    EXPECT_FALSE(vital->isEnabled()) << "the infant's clock stands";
    EXPECT_TRUE(vital->toolTip().contains("once the trial goes on")) << vital->toolTip().toStdString();
  }
  EXPECT_TRUE(wait_for(
      [&] {
        const auto now = page.findChildren<QLabel*>();
        return std::any_of(now.begin(), now.end(), [](const QLabel* label) {
          return label->isVisible() && label->text().contains("held by the instructor");
        });
      },
      5000))
      << "the trainee is told by whom";
  keep_pictures("frozen");
  wait_for([] { return false; },
           700);  // what the recorder has not counted yet: the pauses it tells of come a little later
  const QString stood = state();
  wait_for([] { return false; }, 1500);
  EXPECT_EQ(state(), stood);
  QTest::mouseClick(button("Continue"), Qt::LeftButton);
  EXPECT_FALSE(page.session()->frozen());
  page.session()->confirm();
  EXPECT_TRUE(wait_for([&] { return state().startsWith("Running"); }, 5000)) << state().toStdString();
  for (const QPushButton* vital : vital_signs()) EXPECT_TRUE(vital->isEnabled()) << vital->text().toStdString();
  keep_pictures("running");
  second().close();
  window_->close();
}

TEST_F(WindowInstructor, OpenedInTheMiddleOfATrialItHasAllOfIt) {
  open_with_course();
  // In at 1 s, a press long enough to be seen in some picture, out again from 9 s on.
  std::string csv = "t,x,y,z,qw,qx,qy,qz\n";
  for (const char* row : {"0,0,-0.1,0.02", "1.0,0,0.005,0.006", "1.2,0,0.005,0.002", "1.6,0,0.005,-0.004",
                          "8.0,0,0.005,-0.004", "8.4,0,0.005,0.006", "9.0,0,-0.1,0.02", "600,0,-0.1,0.02"})
    csv += std::string(row) + ",0,0.70710678118654752,-0.70710678118654752,0\n";
  test::write_text(box_.folder() / "press-and-out.csv", csv);
  TrialSetup pressing = setup("helped");
  pressing.device = "scripted:" + (box_.folder() / "press-and-out.csv").string();
  prepare(pressing);
  TrialPage& page = window_->trial_page();
  double now_s = 0.0;
  QObject::connect(&page, &TrialPage::frame, [&](const engine::Snapshot& snapshot) { now_s = snapshot.time_s; });
  page.start();
  const auto pressed = [&] { return page.panels().bars().tongue_peak_n() > 0.1; };
  ASSERT_TRUE(wait_for(pressed, 60000));
  ASSERT_TRUE(wait_for([&] { return now_s > 11.0; }, 60000));
  const double peak_n = page.panels().bars().tongue_peak_n();
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open() && second().drawn() > 0; }, 20000));
  EXPECT_TRUE(told("Blade in the mouth"));
  EXPECT_TRUE(told("Blade out"));
  const QStringList before = events();
  EXPECT_EQ(std::count_if(before.begin(), before.end(),
                          [](const QString& one) { return one.contains("Blade in the mouth"); }),
            1);
  EXPECT_DOUBLE_EQ(second().findChild<ForceBars*>()->tongue_peak_n(), peak_n);
  const auto clock_s = [](const TrialReadings& readings) {
    double longest_s = 0.0;
    for (const auto* label : readings.findChildren<QLabel*>())
      if (label->text().endsWith(" s") && !label->text().startsWith("at most"))
        longest_s = std::max(longest_s, label->text().chopped(2).toDouble());
    return longest_s;
  };
  EXPECT_GT(clock_s(*second().findChild<TrialReadings*>()), 3.0) << "since the blade came in, not since the window did";
  EXPECT_NEAR(clock_s(*second().findChild<TrialReadings*>()), clock_s(page.panels().readings_panel()), 1.5);
  // Closed and opened again it misses nothing of what was meanwhile.
  second().close();
  page.reset();
  ASSERT_TRUE(wait_for([&] { return now_s < 8.0; }, 20000));
  ASSERT_TRUE(wait_for(pressed, 60000));
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 20000));
  EXPECT_TRUE(told("Begun anew"));
  const QStringList after = events();
  EXPECT_EQ(
      std::count_if(after.begin(), after.end(), [](const QString& one) { return one.contains("Blade in the mouth"); }),
      2);
  // It draws less often than the page: once both have drawn.
  EXPECT_TRUE(wait_for(
      [&] {
        const double shown_n = second().findChild<ForceBars*>()->tongue_peak_n();
        return shown_n > 0.0 && shown_n == page.panels().bars().tongue_peak_n();
      },
      20000));
  page.close_trial();
}

TEST_F(WindowInstructor, ItsKeysAndItsButtonCloseItAndTheTrialGoesOn) {
  open_with_course();
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000));
  prepare(setup("busy"));
  TrialPage& page = window_->trial_page();
  page.start();
  ASSERT_TRUE(wait_for([&] { return page.running(); }));
  const auto by_key = [&](Qt::Key key, Qt::KeyboardModifiers with) {
    QApplication::setActiveWindow(&second());
    QTest::keyClick(&second(), key, with);
    return wait_for([&] { return !second_is_open(); }, 5000);
  };
  const auto again = [&] {
    open_second();
    return wait_for([&] { return second_is_open(); }, 5000);
  };
  EXPECT_TRUE(by_key(Qt::Key_I, Qt::ControlModifier)) << "the key that opened it";
  ASSERT_TRUE(again());
  EXPECT_TRUE(by_key(Qt::Key_Escape, Qt::NoModifier));
  EXPECT_TRUE(page.running()) << "Esc was this window's";
  ASSERT_TRUE(again());
  button("Freeze")->click();
  ASSERT_TRUE(wait_for([&] { return page.session()->frozen_by(Holder::instructor); }, 5000));
  QTest::mouseClick(button("Close"), Qt::LeftButton);
  EXPECT_FALSE(second_is_open());
  EXPECT_TRUE(page.running());
  EXPECT_FALSE(page.session()->frozen_by(Holder::instructor)) << "nobody could let it go any more";
}

TEST_F(WindowInstructor, FitsItsScreenInBothLanguagesAndWithLargeText) {
  struct Room {
    QSize size;
    double text;
  };
  for (const char* language : {"en", "de"})
    for (const Room& room : {Room{{1280, 800}, 1.0}, {{1024, 700}, 1.0}, {{1280, 800}, 1.35}, {{1024, 700}, 1.35}}) {
      const std::string name = std::string(language) + "-" + std::to_string(room.size.width()) + "-" +
                               std::to_string(static_cast<int>(100 * room.text));
      ASSERT_TRUE(install_language(*qApp, language));
      theme::apply(*qApp, {theme::Ground::dark, room.text});
      window_.reset();
      open_with_course();
      open_second();
      ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000));
      TrialSetup whole = setup("tube");
      whole.curriculum = test::write_tube_curriculum(box_.folder());
      whole.patient = test::write_arc_patient(box_.folder());
      prepare(whole);
      second().resize(room.size);
      wait_for([] { return false; }, 200);
      EXPECT_LE(second().width(), room.size.width()) << name << lines(wider_than(second(), room.size.width() / 2));
      EXPECT_LE(second().height(), room.size.height()) << name;
      for (const QScrollBar* bar : second().findChildren<QScrollBar*>())
        EXPECT_FALSE(bar->isVisible() && bar->orientation() == Qt::Horizontal) << name << described(*bar);
      EXPECT_EQ(cut_texts(second()), std::vector<std::string>()) << name << lines(cut_texts(second()));
      keep_picture(second(), "instructor-fits-" + name + ".png");
      window_->trial_page().close_trial();
    }
  install_language(*qApp, "en");
  theme::apply(*qApp, {});
}

TEST_F(WindowInstructor, WhatIsFrozenHereOnlyThisWindowLetsGo) {
  open_with_course();
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000));
  const auto rules_begin = [&](const char* words) {
    const auto labels = second().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* one) { return one->text().startsWith(words); });
  };
  EXPECT_TRUE(rules_begin("No trial runs."));
  prepare(setup("helped"));
  EXPECT_TRUE(rules_begin("The trial is prepared"));
  TrialPage& page = window_->trial_page();
  page.start();
  ASSERT_TRUE(wait_for([&] { return second().drawn() >= 2; }, 20000));
  const auto state_begins = [&](const char* words) {
    return wait_for([&] { return state().startsWith(words); }, 10000);
  };
  page.show_expert();
  ASSERT_TRUE(page.expert_shown());
  ASSERT_TRUE(state_begins("Stands at")) << state().toStdString();
  QTest::mouseClick(button("Freeze"), Qt::LeftButton);
  EXPECT_TRUE(state_begins("FROZEN")) << state().toStdString();
  QTest::mouseClick(button("Continue"), Qt::LeftButton);
  EXPECT_TRUE(page.session()->frozen()) << "the trainee still looks at the expert";
  EXPECT_TRUE(state_begins("Stands at")) << state().toStdString();
  QTest::mouseClick(button("Freeze"), Qt::LeftButton);
  page.end_expert();
  EXPECT_TRUE(page.session()->frozen()) << "the end of the expert is not the instructor's";
  EXPECT_TRUE(state_begins("FROZEN")) << state().toStdString();
  page.reset();
  EXPECT_TRUE(page.session()->frozen()) << "nor is a reset";
  ASSERT_TRUE(wait_for([&] { return told("Begun anew"); }, 10000));
  EXPECT_TRUE(state_begins("FROZEN")) << state().toStdString();
  EXPECT_NE(button("Continue"), nullptr);
  second().close();
  EXPECT_FALSE(page.session()->frozen()) << "nobody is left who could let it go";
}

TEST_F(WindowInstructor, BeforeTheStartItShowsToolsAndMonitorAsTheyAreAtTheBlade) {
  open_with_course();
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000));
  TrialSetup whole = setup("tube");
  whole.curriculum = test::write_tube_curriculum(box_.folder());
  whole.patient = test::write_arc_patient(box_.folder());
  prepare(whole);
  ASSERT_EQ(state(), "Prepared, not started");
  const TrialSession& session = *window_->trial_page().session();
  const auto* tube = &*session.scene().intubation;
  OperatorView truth, bare;  // as the trial begins; and the patient alone
  auto* view = second().findChild<OperatorView*>();
  for (OperatorView* one : {&truth, &bare}) {
    one->resize(view->size());
    one->show_patient(window_->trial_page().look(), session.scene().tool.surface, tube);
    one->settle();
  }
  truth.update_from(session.at_start());
  truth.settle();
  ASSERT_GT(picture_difference(truth.picture(), bare.picture()).mean_grey, 0.5) << "tools are seen in it";
  EXPECT_LT(picture_difference(view->picture(), truth.picture()).mean_grey, 0.3);
  auto* monitor = second().findChild<MonitorPanel*>();
  MonitorPanel says(&second()), silent(&second());
  for (MonitorPanel* one : {&says, &silent}) one->resize(monitor->size());
  says.set_breathes(tube->breathes);
  says.show_snapshot(session.at_start());
  const auto off = [&](MonitorPanel& one) {
    return picture_difference(one.grab().toImage(), says.grab().toImage()).mean_grey;
  };
  EXPECT_LT(off(*monitor), 0.1 * off(silent)) << "the infant's signs, as at a bedside";
  keep_picture(second(), "instructor-before-start.png");
}

TEST_F(WindowInstructor, OpenedAfterAnAssessmentItTellsOfItOnlyToAnInstructor) {
  open_with_course();
  prepare(setup("helped", curricula::Mode::assessment));
  TrialPage& page = window_->trial_page();
  bool finished = false;
  QObject::connect(window_.get(), &MainWindow::trial_finished, [&] { finished = true; });
  int frames = 0;
  QObject::connect(&page, &TrialPage::frame, [&] { ++frames; });
  page.start();
  ASSERT_TRUE(wait_for([&] { return frames > 3; }, 20000));
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000)) << "nobody has registered an instructor: anybody may";
  auto* list = second().findChild<QListWidget*>("events");
  EXPECT_FALSE(list->isVisible());
  EXPECT_FALSE(second().findChild<ForceBars*>()->isVisible());
  register_people();
  Records records(records_location());
  People people(records);
  for (const auto& person : people.list())
    if (person.name == "Boss") second().desk().sign_in(people.sign_in(person.id, "4321"), person);
  EXPECT_TRUE(list->isVisible());
}

TEST_F(WindowInstructor, WhatWasToldOfATrialGoesWithItsTrainee) {
  register_people();
  open_with_course();
  sign_in_directly("Boss", "4321");
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000));
  sign_in_directly("Emu", "1234");
  prepare(setup("helped"));
  TrialPage& page = window_->trial_page();
  page.start();
  ASSERT_TRUE(wait_for([&] { return second().drawn() > 2; }, 20000));
  button("Freeze")->click();
  button("Continue")->click();
  ASSERT_TRUE(told("You froze the trial"));
  bool finished = false;
  QObject::connect(window_.get(), &MainWindow::trial_finished, [&] { finished = true; });
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
  EXPECT_TRUE(told("You froze the trial")) << "to be talked over";
  sign_in_directly("Kiwi", "1234");
  EXPECT_EQ(events(), QStringList()) << "it was Emu's";
  second().close();
  open_second();
  ASSERT_TRUE(wait_for([&] { return QApplication::activeModalWidget() != nullptr || second_is_open(); }, 10000));
  EXPECT_EQ(events(), QStringList()) << "opened again as well";
}

TEST_F(WindowInstructor, TellsOfTheTraineesPausesByWhatTheyAreFor) {
  open_with_course();
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000));
  prepare(setup("helped"));
  TrialPage& page = window_->trial_page();
  page.start();
  ASSERT_TRUE(wait_for([&] { return second().drawn() >= 2; }, 20000));
  page.session()->freeze(Holder::reader, true);
  EXPECT_TRUE(wait_for([&] { return state().contains("the list of keys is read"); }, 10000)) << state().toStdString();
  EXPECT_TRUE(wait_for([&] { return told("Paused: the trainee reads the list of keys"); }, 10000));
  EXPECT_FALSE(told("held by you")) << "who watches does not hold it";
  page.close_trial();
}

TEST_F(WindowInstructor, InAnAssessmentOnlyASignedInInstructorSeesFiguresAndDrivesTheInfant) {
  open_with_course();
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000)) << "nobody has registered an instructor: anybody may";
  TrialSetup tube = setup("tube", curricula::Mode::assessment);
  tube.curriculum = test::write_tube_curriculum(box_.folder());
  tube.patient = test::write_arc_patient(box_.folder());
  prepare(tube);
  TrialPage& page = window_->trial_page();
  page.start();
  ASSERT_TRUE(wait_for([&] { return second().drawn() >= 2; }, 20000));
  auto* tabs = second().findChild<QTabWidget*>();
  const auto open_to_see = [&] {
    const bool forces = second().findChild<ForceBars*>()->isVisible();
    EXPECT_EQ(second().findChild<QListWidget*>("events")->isVisible(), forces);
    EXPECT_EQ(tabs->isTabEnabled(tabs->indexOf(second().findChild<TrialReadings*>())), forces);
    EXPECT_EQ(button("Heart \xe2\x96\xbc")->isEnabled(), forces);
    EXPECT_EQ(button("SpO2 \xe2\x96\xb2")->isEnabled(), forces);
    return forces;
  };
  EXPECT_FALSE(open_to_see());
  EXPECT_FALSE(second().findChild<TrialReadings*>()->isVisible());
  keep_pictures("assessment");
  register_people();
  Records records(records_location());
  People people(records);
  for (const auto& person : people.list())
    if (person.name == "Boss") second().desk().sign_in(people.sign_in(person.id, "4321"), person);
  EXPECT_TRUE(open_to_see());
  second().desk().sign_out();
  EXPECT_FALSE(open_to_see());
  bool finished = false;
  QObject::connect(window_.get(), &MainWindow::trial_finished, [&] { finished = true; });
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
  EXPECT_FALSE(second().findChild<ForceBars*>()->isVisible()) << "over, it has not been rated by the trainee yet";
  EXPECT_FALSE(second().findChild<QListWidget*>("events")->isVisible());
}

TEST_F(WindowInstructor, TicksMadeDuringTheRunAreKeptByOneClickAsTheInstructorsRating) {
  register_people();
  open_with_course();
  sign_in_directly("Boss", "4321");
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000));
  sign_in_directly("Kiwi", "1234");
  EXPECT_TRUE(second().desk().instructor()) << "who sits at the second window stays signed in there";
  prepare(setup("busy"));
  TrialPage& page = window_->trial_page();
  TrialOutcome outcome;
  QObject::connect(window_.get(), &MainWindow::trial_finished, [&](const TrialOutcome& given) { outcome = given; });
  page.start();
  ASSERT_TRUE(wait_for([&] { return second().drawn() > 2; }, 20000));
  QToolButton* yes = tick("Handle in the left hand: yes");
  QToolButton* no = tick("Handle in the left hand: no");
  ASSERT_TRUE(yes != nullptr && no != nullptr);
  QTest::mouseClick(no, Qt::LeftButton);
  QTest::mouseClick(yes, Qt::LeftButton);
  EXPECT_FALSE(no->isChecked());
  QTest::keyClick(tick("Told the team what was seen and done: no"), Qt::Key_Space);
  for (auto* step : second().findChildren<QToolButton*>())
    if (step->text() == "4") QTest::mouseClick(step, Qt::LeftButton);
  EXPECT_FALSE(button("Keep as my rating")->isEnabled()) << "there is no record yet";
  ASSERT_TRUE(wait_for([&] { return told("Beside the hands: How long has it been?"); }, 10000));
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return outcome.record_id != 0; }));
  ASSERT_TRUE(button("Keep as my rating")->isEnabled());
  keep_pictures("recorded");
  QTest::mouseClick(button("Keep as my rating"), Qt::LeftButton);
  ASSERT_TRUE(
      wait_for([&] { return second().findChild<QLabel*>("checklist_message")->text().contains("is kept"); }, 10000));
  Records records(records_location());
  People people(records);
  curricula::Who boss;
  for (const auto& person : people.list())
    if (person.name == "Boss") boss = people.sign_in(person.id, "4321");
  std::map<std::string, double> kept;
  for (const auto& rating : curricula::Ratings(records).of_trial(boss, outcome.record_id)) {
    EXPECT_EQ(rating.by, "instructor");
    kept[rating.item] = rating.value;
  }
  EXPECT_EQ(kept, (std::map<std::string, double>{{"global", 4.0}, {"handle_in_left_hand", 1.0}, {"team_told", 0.0}}));
  second().close();
  EXPECT_FALSE(second().desk().who()) << "closed, nobody's sign-in is left behind";
  EXPECT_EQ(desk().person().name, "Kiwi");
}

}  // namespace
}  // namespace vallecula::gui::window_test
