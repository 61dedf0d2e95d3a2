// The window answers while others work. What is timed prints figures and judges nothing: it runs by hand, with
// VALLECULA_SLOW, on a machine that does nothing else.
#include <QApplication>
#include <QLabel>
#include <QSettings>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QTest>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <thread>

#include "curricula/records/people.h"
#include "gui/authoring/authoring_page.h"
#include "gui/import/import_wizard.h"
#include "gui/import/source_page.h"
#include "gui/pages/look_settings.h"
#include "gui/pages/main_menu.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/trial_page.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"
#include "pipeline/manikin/manikin.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/busy_course.h"
#include "tests/gui/program.h"
#include "tests/gui/stall_watch.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

class WindowStall : public Screen {
 protected:
  WindowStall() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~WindowStall() override {
    window_.reset();
    unsetenv("VALLECULA_HOME");
  }
  void open() {
    window_ = std::make_unique<MainWindow>();
    window_->show_start({curricula::load_curriculum(default_curriculum())});
    window_->show();
    QApplication::processEvents();
  }
  void settle(int ms = 300) {
    QElapsedTimer timer;
    timer.start();
    wait_for([&] { return timer.elapsed() > ms; });
  }

  test::Sandbox box_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(WindowStall, TheWatchSeesAStallAndNoneWhereThereIsNone) {
  StallWatch watch;
  settle(100);
  watch.take_longest_ms();
  std::this_thread::sleep_for(std::chrono::milliseconds(250));
  settle(50);
  EXPECT_GE(watch.take_longest_ms(), 240.0);
  watch.take_most_work_ms();
  const auto worked = [] { return std::clock(); };
  for (const auto begin = worked(); worked() - begin < CLOCKS_PER_SEC / 5;) continue;
  settle(50);
  EXPECT_GE(watch.take_most_work_ms(), 90.0) << "at least half of what all threads worked together";
}

TEST_F(WindowStall, ALockedDatabaseStopsNothing) {
  open();
  int troubles = 0;
  bool open_now = false;
  RecordsDesk& desk = window_->records_page().desk();
  QObject::connect(&desk, &RecordsDesk::trouble, [&] { ++troubles; });
  desk.ask<bool>(
      &desk, [](curricula::Records& records) { return curricula::People(records).has_instructor(); },
      [&](bool) { open_now = true; });
  ASSERT_TRUE(wait_for([&] { return open_now; }));
  {
    QSqlDatabase other = QSqlDatabase::addDatabase("QSQLITE", "another program");
    other.setDatabaseName(QString::fromStdString(records_database().string()));
    ASSERT_TRUE(other.open());
    QSqlQuery query(other);
    ASSERT_TRUE(query.exec("begin immediate")) << query.lastError().text().toStdString();
    bool asked = false;
    // A question that must write waits for the lock.
    desk.ask<long long>(
        &desk, [](curricula::Records& records) { return curricula::People(records).register_trainee("Kea", "1234"); },
        [&](long long) { asked = true; });
    for (const char* page : {"course", "records", "devices"}) {
      emit window_->menu().home_wanted();
      choose_at_home(*window_, page);
      QApplication::processEvents();
    }
    EXPECT_EQ(window_->page_name(), "devices");
    EXPECT_FALSE(asked) << "all of this while the records did not answer";
    EXPECT_EQ(troubles, 0) << "and before they gave up";
    ASSERT_TRUE(query.exec("rollback"));
    query.clear();
    other.close();
    EXPECT_TRUE(wait_for([&] { return asked || troubles > 0; }));
    EXPECT_TRUE(asked);
  }
  QSqlDatabase::removeDatabase("another program");
}

TEST_F(WindowStall, BackWaitsForNoDatabaseAndTheNextTrialForTheOneBefore) {
  user_settings()->setValue("mouse/introduced", true);
  open();
  TrialSetup setup;
  setup.patient = test::write_block_patient(box_.folder());
  setup.curriculum = test::write_busy_course(box_.folder());
  setup.scenario = "helped";
  setup.device = "mouse";
  setup.out = box_ / "one";
  int ready = 0;
  QObject::connect(window_.get(), &MainWindow::prepared, [&] { ++ready; });
  window_->prepare(setup, false);
  ASSERT_TRUE(wait_for([&] { return ready == 1; }));
  TrialPage& page = window_->trial_page();
  {
    QSqlDatabase other = QSqlDatabase::addDatabase("QSQLITE", "another program");
    other.setDatabaseName(QString::fromStdString(records_database().string()));
    ASSERT_TRUE(other.open());
    QSqlQuery query(other);
    ASSERT_TRUE(query.exec("begin exclusive")) << query.lastError().text().toStdString();
    page.start();
    settle(200);
    ASSERT_TRUE(page.session()->starting()) << "it waits for the records";
    QElapsedTimer clock;
    clock.start();
    emit page.left();
    EXPECT_LT(clock.elapsed(), 5000) << "the records are patient for ten seconds";
    EXPECT_NE(window_->page_name(), "trial");
    setup.out = box_ / "two";
    window_->prepare(setup, false);
    settle(300);
    EXPECT_EQ(window_->page_name(), "prepare");
    EXPECT_EQ(ready, 1);
    EXPECT_NE(page.gone().wait_for(std::chrono::seconds(0)), std::future_status::ready);
    ASSERT_TRUE(query.exec("rollback"));
    query.clear();
    other.close();
  }
  QSqlDatabase::removeDatabase("another program");
  ASSERT_TRUE(wait_for([&] { return ready == 2; }));
  EXPECT_EQ(page.gone().wait_for(std::chrono::seconds(0)), std::future_status::ready) << "its device was free";
}

TEST_F(WindowStall, FiguresOfEveryFlow) {
  if (std::getenv("VALLECULA_SLOW") == nullptr) GTEST_SKIP() << "figures for a quiet machine: VALLECULA_SLOW=1";
  StallWatch watch;
  const auto told = [&watch](const char* flow) {
    const double longest = watch.take_longest_ms(), work = watch.take_most_work_ms();
    std::printf("%8.0f ms longest without an answer, %4.0f ms of them worked: %s\n", longest, work, flow);
  };
  bool ready = false, finished = false, replayed = false;
  struct Round {
    const char* what;
    bool new_start;
    int at_home_ms;
  };
  for (const Round& round : {Round{"manikin made", true, 300}, Round{"the same again", false, 0},
                             Round{"manikin cached, at once after the start", true, 0},
                             Round{"manikin cached, after 10 s at home", true, 10000}}) {
    if (round.new_start) {
      window_.reset();
      open();
      settle(300);
      told("window opens at home");
      QObject::connect(window_.get(), &MainWindow::prepared, [&] { ready = true; });
      QObject::connect(window_.get(), &MainWindow::trial_finished, [&] { finished = true; });
      QObject::connect(window_.get(), &MainWindow::replay_opened, [&] { replayed = true; });
    }
    settle(round.at_home_ms);
    told("home");
    QElapsedTimer clock;
    clock.start();
    ready = finished = false;
    QString stage;
    auto* stage_label = window_->findChild<QLabel*>("stage");
    window_->home_page().findChild<QPushButton*>("practise")->click();
    const auto tell_stage = [&] {
      if (stage_label->text() == stage) return;
      stage = stage_label->text();
      std::printf("%8.2f s after the click: %s\n", 1e-3 * static_cast<double>(clock.elapsed()), qPrintable(stage));
    };
    ASSERT_TRUE(wait_for([&] { return tell_stage(), ready; }, 300000));
    const double opened_s = 1e-3 * static_cast<double>(clock.elapsed());
    told("prepare and open the trial");
    int frames = 0;
    window_->trial_page().set_frame_hook([&](const engine::Snapshot& seen) { frames += seen.step > 0 ? 1 : 0; });
    window_->trial_page().start();
    ASSERT_TRUE(wait_for([&] { return frames > 0; }));
    std::printf("%8.2f s from the click to the trial's page, %.2f s to its first moving picture (%s)\n", opened_s,
                1e-3 * static_cast<double>(clock.elapsed()), round.what);
    told("start");
    settle(2000);
    told("two seconds of trial");
    window_->trial_page().reset();
    settle();
    told("reset");
    window_->trial_page().end("ended by trainee");
    ASSERT_TRUE(wait_for([&] { return finished; }));
    window_->trial_page().set_frame_hook({});
    settle();
    told("end and result");
    emit window_->menu().home_wanted();
  }
  const fs::path trials = user_data_folder() / "trials";
  window_->replay(fs::directory_iterator(trials)->path());
  ASSERT_TRUE(wait_for([&] { return replayed; }, 120000));
  settle(2000);
  told("replay");
  emit window_->menu().home_wanted();
  for (const char* page : {"course", "records", "devices"}) {
    choose_at_home(*window_, page);
    settle();
    told(page);
    emit window_->menu().home_wanted();
    settle(100);
  }
  watch.take_longest_ms();
  watch.take_most_work_ms();
  window_->write_course(curricula_folder() / "neonatal-intubation.yaml");
  settle();
  told("authoring of a large course");
  emit window_->authoring_page().left();
  apply_look({"light", 1.0});
  settle();
  told("another ground");
  apply_look({"light", 1.2});
  settle();
  told("larger text");
  apply_look({});
  settle();
  pipeline::ManikinOptions options;
  options.weight_kg = 0.8;
  pipeline::write_manikin(options, box_ / "ct");
  settle(50);  // what was asked meanwhile is answered
  watch.take_longest_ms();
  watch.take_most_work_ms();
  window_->import_series(QString::fromStdString((box_ / "ct").string()));
  ASSERT_TRUE(wait_for([&] { return !window_->import_wizard().work().busy(); }));
  settle();
  told("import: series listed");
  for (QPushButton* button : window_->import_wizard().source_page().findChildren<QPushButton*>())
    if (button->objectName() == "primary") button->click();
  ASSERT_TRUE(wait_for([&] { return window_->import_wizard().step() == "check"; }, 300000));
  settle(2000);
  told("import: found structures shown");
}

}  // namespace
}  // namespace vallecula::gui::window_test
