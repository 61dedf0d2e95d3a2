// The instructor's second window beside a trial: what it shows, what it does to it, what is kept of the ticks; and the
// next trainee at the same machine.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollBar>
#include <QTabWidget>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "curricula/records/ratings.h"
#include "gui/authoring/authoring_page.h"
#include "gui/instructor/instructor_controls.h"
#include "gui/instructor/instructor_window.h"
#include "gui/instructor/run_checklist.h"
#include "gui/instructor/sign_in_dialog.h"
#include "gui/instructor/station.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/records_pages/person_dialog.h"
#include "gui/session/languages.h"
#include "gui/views/force_bars.h"
#include "gui/views/operator_view.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"
#include "tests/gui/accessible.h"
#include "tests/gui/arc_patient.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/busy_course.h"
#include "tests/gui/records_pages/window_records.h"

namespace vallecula::gui::window_test {
namespace {

class WindowInstructor : public WindowRecords {
 protected:
  void register_people() {
    Records records(records_location());
    People people(records);
    people.create_first_instructor("Boss", "4321");
    for (const char* name : {"Emu", "Kiwi", "Moa"}) people.register_trainee(name, "1234");
  }
  /// Signed in at the blade, as the records' page would.
  void sign_in_directly(const std::string& name, const std::string& pin) {
    Records records(records_location());
    People people(records);
    for (const auto& person : people.list())
      if (person.name == name) desk().sign_in(people.sign_in(person.id, pin), person);
    ASSERT_EQ(desk().person().name, name);
  }
  void open_with_course() {
    window_ = std::make_unique<MainWindow>();
    window_->show_start({curricula::load_curriculum(course_)});
    window_->show();
    QApplication::setActiveWindow(window_.get());
    QApplication::processEvents();
  }
  TrialSetup setup(const std::string& scenario, curricula::Mode mode = curricula::Mode::practice) {
    TrialSetup setup;
    setup.patient = patient_;
    setup.curriculum = course_;
    setup.scenario = scenario;
    setup.device = "mouse";
    setup.out = box_ / "out";
    setup.mode = mode;
    setup.trainee_id = desk().person().id;
    return setup;
  }
  void prepare(const TrialSetup& setup) {
    bool ready = false;
    QString failure;
    const auto heard = QObject::connect(window_.get(), &MainWindow::prepared, [&] { ready = true; });
    const auto failed =
        QObject::connect(window_.get(), &MainWindow::trial_failed, [&](const QString& m) { failure = m; });
    window_->prepare(setup, false);
    ASSERT_TRUE(wait_for([&] { return ready || !failure.isEmpty(); }));
    ASSERT_EQ(failure.toStdString(), "");
    QObject::disconnect(heard);
    QObject::disconnect(failed);
  }
  InstructorWindow& second() { return *window_->station().instructor_window(); }
  bool second_is_open() { return window_->station().instructor_window() != nullptr && second().isVisible(); }
  /// By its key in the first window.
  void open_second() {
    QApplication::setActiveWindow(window_.get());
    QTest::keyClick(window_.get(), Qt::Key_I, Qt::ControlModifier);
  }
  QString state() { return second().findChild<QLabel*>("instructor_state")->text(); }
  QStringList events() {
    QStringList all;
    auto* list = second().findChild<QListWidget*>();
    for (int i = 0; i < list->count(); ++i) all << list->item(i)->text();
    return all;
  }
  bool told(const QString& what) {
    const QStringList all = events();
    return std::any_of(all.begin(), all.end(), [&](const QString& one) { return one.contains(what); });
  }
  QPushButton* button(const QString& text) {
    for (auto* one : second().findChildren<QPushButton*>())
      if (one->text().remove('&').startsWith(text)) return one;
    return nullptr;
  }
  QToolButton* tick(const QString& name) {
    for (auto* one : second().findChildren<QToolButton*>())
      if (one->accessibleName() == name) return one;
    return nullptr;
  }
  template <class Dialog>
  Dialog* dialog() {
    Dialog* found = nullptr;
    EXPECT_TRUE(
        wait_for([&] { return (found = qobject_cast<Dialog*>(QApplication::activeModalWidget())) != nullptr; }, 10000));
    if (found == nullptr) return nullptr;
    EXPECT_TRUE(wait_for([&] { return found->template findChild<QComboBox*>()->count() > 0; }, 10000));
    return found;
  }
  /// A picture of the second window at both sizes, on both grounds.
  void keep_pictures(const std::string& name) {
    if (std::getenv("VALLECULA_PICTURES") == nullptr) return;
    for (const auto ground : {theme::Ground::light, theme::Ground::dark}) {
      theme::apply(*qobject_cast<QApplication*>(QCoreApplication::instance()), {ground, 1.0});
      for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
        second().resize(size);
        wait_for([] { return false; }, 400);
        keep_picture(second(), "instructor-" + name + (ground == theme::Ground::dark ? "-dark-" : "-light-") +
                                   std::to_string(size.width()) + ".png");
      }
    }
  }

  const std::filesystem::path patient_ = test::write_block_patient(box_.folder());
  const std::filesystem::path course_ = test::write_busy_course(box_.folder());
};

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
  const auto vital_signs = [&] {
    return QList<QPushButton*>{button("SpO2"), button("Heart"), button("Laryngospasm")};
  };
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
  wait_for([] { return false; }, 700);  // what the recorder has not counted yet: the pauses it tells of come a little later
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
  EXPECT_DOUBLE_EQ(second().findChild<ForceBars*>()->tongue_peak_n(), page.panels().bars().tongue_peak_n());
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

TEST_F(WindowInstructor, TheNextTraineeWaitsForTheOwnRatingAndForAnUnsavedCourse) {
  register_people();
  open_with_course();
  sign_in_directly("Emu", "1234");
  const auto next = [&] {
    QApplication::setActiveWindow(window_.get());
    QTest::keyClick(window_.get(), Qt::Key_T, Qt::ControlModifier);
  };
  window_->write_course();
  AuthoringPage& writing = window_->authoring_page();
  writing.new_course();
  writing.document().set_text(writing.document().text() + "# more\n", "typed");
  ASSERT_TRUE(writing.document().modified());
  const QString text = writing.document().text();
  int asked = 0;
  QTimer answers;  // whatever asks is cancelled
  QObject::connect(&answers, &QTimer::timeout, [&asked] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) return;
    ++asked;
    box->button(QMessageBox::Cancel)->click();
  });
  answers.start(50);
  const auto nobody = [&](SignInDialog* asks) {
    for (auto* one : asks->findChildren<QPushButton*>())
      if (one->text().remove('&') == "Go on as nobody") return QTest::mouseClick(one, Qt::LeftButton);
    ADD_FAILURE() << "no such button";
  };
  const auto no_dialog = [] {
    return wait_for([] { return QApplication::activeModalWidget() == nullptr; }, 10000);
  };
  next();
  auto* asks = dialog<SignInDialog>();
  ASSERT_NE(asks, nullptr);
  EXPECT_EQ(asked, 0) << "nothing is lost by looking";
  QTest::keyClick(asks, Qt::Key_Escape);
  ASSERT_TRUE(no_dialog());
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(desk().person().name, "Emu");
  EXPECT_EQ(writing.document().text(), text) << "cancelled, all is as it was";
  next();
  asks = dialog<SignInDialog>();
  ASSERT_NE(asks, nullptr);
  nobody(asks);
  ASSERT_TRUE(no_dialog());
  EXPECT_EQ(asked, 1) << "now it would be";
  EXPECT_EQ(desk().person().name, "Emu");
  EXPECT_EQ(window_->page_name(), "authoring");
  EXPECT_EQ(writing.document().text(), text);
  next();
  asks = dialog<SignInDialog>();  // and so by somebody else's PIN
  ASSERT_NE(asks, nullptr);
  QTest::keyClicks(asks->findChild<QLineEdit*>(), "1234");
  QTest::keyClick(asks->findChild<QLineEdit*>(), Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return asked == 2; }, 10000));
  ASSERT_TRUE(no_dialog());
  EXPECT_EQ(desk().person().name, "Emu");
  writing.document().undo().undo();
  ASSERT_FALSE(writing.document().modified());
  emit writing.left();

  prepare(setup("helped", curricula::Mode::assessment));
  window_->trial_page().start();
  bool finished = false;
  QObject::connect(window_.get(), &MainWindow::trial_finished, [&] { finished = true; });
  int frames = 0;
  window_->trial_page().set_frame_hook([&](const engine::Snapshot&) { ++frames; });
  ASSERT_TRUE(wait_for([&] { return frames > 3; }));
  window_->trial_page().end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
  ASSERT_EQ(window_->page_name(), "rating");
  next();
  asks = dialog<SignInDialog>();
  ASSERT_NE(asks, nullptr);
  nobody(asks);
  ASSERT_TRUE(no_dialog());
  EXPECT_EQ(desk().person().name, "Emu") << "first the rating that only Emu can give";
  EXPECT_EQ(window_->page_name(), "rating");
}

TEST_F(WindowInstructor, ATrialThatBeganMeanwhileStaysItsTrainees) {
  register_people();
  open_with_course();
  sign_in_directly("Emu", "1234");
  prepare(setup("helped"));
  QApplication::setActiveWindow(window_.get());
  QTest::keyClick(window_.get(), Qt::Key_T, Qt::ControlModifier);
  auto* asks = dialog<SignInDialog>();
  ASSERT_NE(asks, nullptr);
  QString told;
  QObject::connect(&window_->station(), &InstructorStation::told, [&](const QString& message) { told = message; });
  window_->trial_page().start();
  ASSERT_TRUE(window_->trial_page().running());
  QTest::keyClicks(asks->findChild<QLineEdit*>(), "1234");
  QTest::keyClick(asks->findChild<QLineEdit*>(), Qt::Key_Return);
  QMessageBox* box = nullptr;
  ASSERT_TRUE(wait_for([&] { return (box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) != nullptr; },
                       10000));
  box->button(QMessageBox::Ok)->click();
  EXPECT_EQ(desk().person().name, "Emu");
  EXPECT_TRUE(window_->trial_page().running());
  EXPECT_TRUE(told.contains("A trial runs")) << told.toStdString();
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

TEST_F(WindowInstructor, WhereThereIsAnInstructorOnlyOneOpensItAndTheTraineeStaysAtTheBlade) {
  register_people();
  open_with_course();
  sign_in_directly("Kiwi", "1234");
  open_second();
  auto* asks = dialog<SignInDialog>();
  ASSERT_NE(asks, nullptr);
  EXPECT_EQ(asks->findChild<QComboBox*>()->count(), 1) << "instructors only";
  auto* pin = asks->findChild<QLineEdit*>();
  QTest::keyClicks(pin, "1234");
  QTest::keyClick(pin, Qt::Key_Return);
  auto* message = asks->findChild<QLabel*>("dialog_message");
  ASSERT_TRUE(
      wait_for([&] { return message->text().contains("PIN") && !message->text().startsWith("Looking"); }, 10000));
  EXPECT_FALSE(second_is_open());
  QTest::keyClicks(pin, "4321");
  QTest::keyClick(pin, Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000));
  EXPECT_EQ(desk().person().name, "Kiwi");
  EXPECT_TRUE(second().desk().instructor());
}

TEST_F(WindowInstructor, InAnAssessmentNothingHelpsOrHoldsTheTraineeUp) {
  open_with_course();
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000));
  prepare(setup("helped", curricula::Mode::assessment));
  window_->trial_page().start();
  ASSERT_TRUE(wait_for([&] { return second().drawn() > 0; }, 20000));
  EXPECT_FALSE(button("Say")->isEnabled());
  EXPECT_FALSE(second().findChild<InstructorControls*>()->findChild<QComboBox*>()->isEnabled());
  EXPECT_FALSE(button("Freeze")->isEnabled());
  const auto labels = second().findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->isVisible() && label->text().startsWith("Assessment: ");
  }));
  EXPECT_FALSE(window_->station().next_trainee_action()->isEnabled()) << "a trial belongs to whoever began it";
  window_->trial_page().end("ended by trainee");
  EXPECT_TRUE(wait_for([&] { return window_->station().next_trainee_action()->isEnabled(); }, 20000));
}

TEST_F(WindowInstructor, TheNextTraineeTakesOverByOneKeyAndThePin) {
  register_people();
  open_with_course();
  sign_in_directly("Emu", "1234");
  StartPage& start = window_->start_page();
  start.add_patient(patient_, true);
  ASSERT_TRUE(start.select("helped", "mouse"));
  QTest::keyClick(start.findChild<QComboBox*>("mode"), Qt::Key_Down);
  ASSERT_EQ(start.choice().mode, curricula::Mode::assessment);
  const Choice before = start.choice();
  prepare(setup("busy"));
  ASSERT_EQ(window_->page_name(), "trial");

  QApplication::setActiveWindow(window_.get());
  QTest::keyClick(window_.get(), Qt::Key_T, Qt::ControlModifier);
  auto* asks = dialog<SignInDialog>();
  ASSERT_NE(asks, nullptr);
  EXPECT_EQ(asks->findChild<QComboBox*>()->currentText(), "Kiwi (trainee)") << "the one after Emu";
  keep_picture(*asks, "next-trainee.png");
  QTest::keyClick(asks, Qt::Key_Escape);
  EXPECT_EQ(desk().person().name, "Emu") << "cancelled, all is as it was";
  EXPECT_EQ(window_->page_name(), "trial");
  ASSERT_TRUE(wait_for([] { return QApplication::activeModalWidget() == nullptr; }, 5000));
  QApplication::setActiveWindow(window_.get());
  QTest::keyClick(window_.get(), Qt::Key_T, Qt::ControlModifier);
  asks = dialog<SignInDialog>();
  ASSERT_NE(asks, nullptr);
  auto* pin = asks->findChild<QLineEdit*>();
  QTest::keyClick(pin, Qt::Key_Down);  // Moa, not Kiwi
  QTest::keyClicks(pin, "1234");
  QTest::keyClick(pin, Qt::Key_Return);
  wait_for([&] { return desk().person().name == "Moa"; }, 10000);
  EXPECT_EQ(desk().person().name, "Moa") << "three keys and the PIN";
  EXPECT_NE(window_->page_name(), "trial") << "what was prepared was for the one before";
  const Choice after = start.choice();
  EXPECT_EQ(after.scenario.id, before.scenario.id);
  EXPECT_EQ(after.patient, before.patient);
  EXPECT_EQ(after.device, before.device);
  EXPECT_EQ(after.mode, curricula::Mode::practice);

  QToolButton* next = nullptr;  // the same by a click, where one begins
  for (auto* one : window_->findChildren<QToolButton*>())
    if (one->isVisible() && one->defaultAction() == window_->station().next_trainee_action()) next = one;
  ASSERT_NE(next, nullptr);
  keep_picture(*window_, "next-trainee-begin.png");
  QTest::mouseClick(next, Qt::LeftButton);
  asks = dialog<SignInDialog>();
  ASSERT_NE(asks, nullptr);
  EXPECT_EQ(asks->findChild<QComboBox*>()->currentText(), "Emu (trainee)") << "after the last one the first";
  const auto press = [&](QDialog* in, const QString& text) {
    for (auto* one : in->findChildren<QPushButton*>())
      if (one->text().remove('&') == text) return QTest::mouseClick(one, Qt::LeftButton);
    ADD_FAILURE() << "no " << text.toStdString();
  };
  press(asks, "Go on as nobody");
  EXPECT_FALSE(desk().who());
  ASSERT_TRUE(wait_for([] { return QApplication::activeModalWidget() == nullptr; }, 5000));

  // Somebody new is asked for a name at once, and signed in with it.
  QTest::mouseClick(next, Qt::LeftButton);
  asks = dialog<SignInDialog>();
  ASSERT_NE(asks, nullptr);
  press(asks, "Somebody new ...");
  PersonDialog* registers = nullptr;
  ASSERT_TRUE(wait_for(
      [&] { return (registers = qobject_cast<PersonDialog*>(QApplication::activeModalWidget())) != nullptr; }, 10000));
  EXPECT_EQ(window_->page_name(), "records");
  const auto lines = registers->findChildren<QLineEdit*>();
  ASSERT_EQ(lines.size(), 3);
  QTest::keyClicks(lines[0], "Rhea");
  QTest::keyClicks(lines[1], "1234");
  QTest::keyClicks(lines[2], "1234");
  QTest::keyClick(lines[2], Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return desk().who().has_value(); }, 10000));
  EXPECT_EQ(desk().person().name, "Rhea");
}

TEST_F(WindowInstructor, AHapticDeviceIsCheckedBeforeItsFirstTrial) {
  open_with_course();
  window_->station().set_device_maker(
      []() -> std::unique_ptr<device::HapticDevice> { throw std::runtime_error("no libHD.so was found"); });
  window_->start_page().add_patient(patient_, true);
  window_->start_page().choose_device("touch", "Touch X");
  ASSERT_TRUE(window_->start_page().select("helped", "touch"));
  QString failure;
  QObject::connect(window_.get(), &MainWindow::trial_failed, [&](const QString& message) { failure = message; });
  emit window_->start_page().chosen(window_->start_page().choice());
  DeviceCheck* check = nullptr;
  ASSERT_TRUE(wait_for(
      [&] { return (check = qobject_cast<DeviceCheck*>(QApplication::activeModalWidget())) != nullptr; }, 5000));
  ASSERT_TRUE(wait_for([&] { return window_->station().checks().find("touch") != nullptr; }, 10000));
  EXPECT_TRUE(failure.isEmpty()) << "no trial before the check is closed";
  QTest::keyClick(check, Qt::Key_Escape);
  ASSERT_TRUE(wait_for([&] { return !failure.isEmpty(); }, 20000)) << "it goes on, and says what the trial says of it";
  EXPECT_FALSE(window_->station().checks().due("touch")) << "once a session";
}

}  // namespace
}  // namespace vallecula::gui::window_test
