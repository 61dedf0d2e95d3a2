// What a start tells: the first one its steps, one after a program that ended too early what is left; and the log of a
// session.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QRadioButton>
#include <QSlider>
#include <QTest>

#include "curricula/records/people.h"
#include "device/found_devices.h"
#include "gui/authoring/authoring_page.h"
#include "gui/authoring/kept_draft.h"
#include "gui/instructor/station.h"
#include "gui/pages/about_dialog.h"
#include "gui/pages/first_run.h"
#include "gui/pages/help_dialog.h"
#include "gui/pages/main_menu.h"
#include "gui/pages/remade_window.h"
#include "gui/pages/settings_dialog.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/versions.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/files.h"
#include "gui/session/languages.h"
#include "gui/session/program_log.h"
#include "gui/session/trial_record.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/coarse_infant.h"
#include "tests/gui/program.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

class WindowStart : public Screen {
 protected:
  WindowStart() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~WindowStart() override {
    window_.reset();
    program_log::end();
    install_language(*qApp, "en");
    apply_look({});
    unsetenv("VALLECULA_HOME");
  }
  void open() {
    window_ = std::make_unique<MainWindow>();
    window_->show_start({curricula::load_curriculum(test::write_curriculum(box_.folder()))});
    window_->show();
    QApplication::setActiveWindow(window_.get());
    QApplication::processEvents();
  }
  template <class Dialog>
  static Dialog* opened() {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<Dialog*>(widget); dialog != nullptr && dialog->isVisible()) return dialog;
    return nullptr;
  }
  /// A number that no running process has: of one that has just ended.
  static pid_t gone_process() {
    const pid_t child = fork();
    if (child == 0) _exit(0);
    int status = 0;
    waitpid(child, &status, 0);
    return child;
  }

  test::Sandbox box_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(WindowStart, TheFirstOneAsksThreeThingsAndBeginsTheFirstScenario) {
  // The block patient stands in for the manikin, which takes half a minute to be made.
  const fs::path patient = test::write_block_patient(box_.folder());
  open();
  window_->start_page().add_patient(patient, true);
  window_->welcome();
  QPointer<FirstRun> steps = opened<FirstRun>();
  ASSERT_NE(steps, nullptr);
  EXPECT_EQ(steps->device(), "mouse") << "enough, and chosen";
  keep_picture(*steps, "first-run-1.png");
  QTest::keyClick(steps->focusWidget(), Qt::Key_Return);
  auto* text = steps->findChild<QSlider*>("text_scale");
  ASSERT_TRUE(text->isVisible());
  text->setValue(120);
  ASSERT_TRUE(wait_for([] { return std::abs(theme::look().text_scale - 1.2) < 1e-9; }, 5000)) << "seen at once";
  keep_picture(*steps, "first-run-2.png");
  steps->findChild<QPushButton*>("primary")->click();
  keep_picture(*steps, "first-run-3.png");
  bool ready = false;
  QObject::connect(window_.get(), &MainWindow::prepared, [&] { ready = true; });
  steps->findChild<QPushButton*>("primary")->click();
  ASSERT_TRUE(wait_for([&] { return ready; }));
  EXPECT_EQ(window_->trial_page().scenario().id, "plain");
  EXPECT_NEAR(look_settings().text_scale, 1.2, 1e-9);
  EXPECT_FALSE(is_first_run());
  window_->close();
}

TEST_F(WindowStart, TheFirstStepsOfferTheLanguageAndGoOnInIt) {
  open();
  window_->welcome();
  QPointer<FirstRun> steps = opened<FirstRun>();
  ASSERT_NE(steps, nullptr);
  auto* box = steps->findChild<QComboBox*>("language");
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->currentText(), "English");
  const int german = box->findText("Deutsch");
  ASSERT_GE(german, 0) << "by its own name";
  box->setCurrentIndex(german);
  emit box->activated(german);
  ASSERT_TRUE(wait_for([&] { return (steps.isNull() || !steps->isVisible()) && opened<FirstRun>() != nullptr; }, 5000));
  EXPECT_EQ(opened<FirstRun>()->windowTitle().toStdString(), "Willkommen bei Vallecula");
  EXPECT_EQ(chosen_language(), "de") << "and from the next start on";
  keep_picture(*opened<FirstRun>(), "first-run-german.png");
  bool anew = false;
  QObject::connect(window_.get(), &MainWindow::words_changed, [&] { anew = true; });
  box = opened<FirstRun>()->findChild<QComboBox*>("language");
  box->setCurrentIndex(box->findText("English"));
  emit box->activated(box->currentIndex());
  EXPECT_TRUE(anew) << "whoever made the window makes it anew";
  EXPECT_EQ(language(), "en");
}

// At the first start after an older program: what it left is told, the window is as large as its person made it, and
// then they choose their language in the first steps.
TEST_F(WindowStart, MadeAnewInAnotherLanguageItKeepsWhatItToldAndItsSize) {
  const fs::path folder = user_data_folder() / "unsaved";
  const fs::path draft = folder / ("unsaved-" + std::to_string(gone_process()) + ".yaml");
  fs::create_directories(folder);
  write_file_whole(draft, "# never saved\nschema: 2\n");
  const auto choose = [](const QString& name) {
    auto* steps = opened<FirstRun>();
    ASSERT_NE(steps, nullptr);
    auto* box = steps->findChild<QComboBox*>("language");
    box->setCurrentIndex(box->findText(name));
    emit box->activated(box->currentIndex());
  };
  RemadeWindow shown({curricula::load_curriculum(test::write_curriculum(box_.folder()))});
  bool remade = false;
  QObject::connect(&shown, &RemadeWindow::remade, [&] { remade = true; });
  const auto notice = [&] { return shown.window().home_page().findChild<QLabel*>("notice"); };
  shown.window().look_back();
  shown.window().welcome();
  shown.window().showMaximized();
  ASSERT_TRUE(shown.window().looking_back()) << "the language is chosen before it has looked back";
  choose("Deutsch");
  ASSERT_TRUE(wait_for([&] { return remade; }, 10000));
  EXPECT_TRUE(shown.window().isVisible());
  EXPECT_TRUE(shown.window().isMaximized());
  ASSERT_TRUE(notice()->isVisible()) << "what is found once is not lost with the window before";
  EXPECT_TRUE(notice()->text().contains("Daran weiterschreiben")) << notice()->text().toStdString();
  ASSERT_NE(opened<FirstRun>(), nullptr) << "they begin anew";
  EXPECT_EQ(opened<FirstRun>()->windowTitle().toStdString(), "Willkommen bei Vallecula");
  keep_picture(shown.window(), "home-remade-german.png");
  // And back, from a window of its own size.
  shown.window().showNormal();
  shown.window().setGeometry(40, 50, 1111, 777);
  QApplication::processEvents();
  remade = false;
  choose("English");
  ASSERT_TRUE(wait_for([&] { return remade; }, 10000));
  EXPECT_FALSE(shown.window().isMaximized());
  EXPECT_EQ(shown.window().size(), QSize(1111, 777));
  ASSERT_TRUE(notice()->isVisible());
  opened<FirstRun>()->close();
  emit notice()->linkActivated("draft:drop");
  EXPECT_FALSE(notice()->isVisible());
  EXPECT_FALSE(fs::exists(draft)) << "the window made anew can let it go";
}

TEST_F(WindowStart, AnotherLanguageOfTheSettingsIsFollowedAtOnceWhereNothingIsLost) {
  const auto choose = [&](const QString& code) {
    emit window_->menu().settings_wanted();
    auto* settings = opened<SettingsDialog>();
    ASSERT_NE(settings, nullptr);
    auto* box = settings->findChild<QComboBox*>("language");
    box->setCurrentIndex(box->findData(code));
    settings->accept();
  };
  open();
  choose("de");
  EXPECT_EQ(language(), "en") << "nobody makes this window anew";
  EXPECT_EQ(chosen_language(), "de") << "but from the next start on";
  choose("en");
  int anew = 0;
  bool steps = false;
  QObject::connect(window_.get(), &MainWindow::words_changed, [&](bool first_steps) {
    ++anew;
    steps = first_steps;
  });
  choose("de");
  EXPECT_EQ(anew, 1) << "whoever made the window makes it anew";
  EXPECT_FALSE(steps) << "without the first steps";
  EXPECT_EQ(language(), "de");
  window_->write_course();
  choose("en");
  EXPECT_EQ(anew, 1) << "a course is being written";
  EXPECT_EQ(language(), "de");
}

TEST_F(WindowStart, ItsStepsCanBeSkippedAndComeAgainOnlyWhenAskedFor) {
  open();
  window_->welcome();
  QPointer<FirstRun> steps = opened<FirstRun>();
  ASSERT_NE(steps, nullptr);
  device::FoundDevice falcon;
  falcon.info.kind = "falcon";
  falcon.info.model = "Falcon";
  falcon.problem = "no permission";
  steps->set_found_devices({device::found_mouse(), falcon});
  EXPECT_EQ(steps->findChildren<QRadioButton*>().size(), 1) << "what cannot be used is not offered";
  QTest::keyClick(steps, Qt::Key_Escape);
  ASSERT_TRUE(wait_for([&] { return steps.isNull() || !steps->isVisible(); }, 5000));
  EXPECT_EQ(window_->page_name(), "home");
  window_->welcome();
  EXPECT_EQ(opened<FirstRun>(), nullptr);
  emit window_->menu().first_steps_wanted();
  EXPECT_NE(opened<FirstRun>(), nullptr);
}

TEST_F(WindowStart, ACourseThatWasBeingWrittenIsOffered) {
  const fs::path folder = user_data_folder() / "unsaved";
  const std::string text = "# never saved\nschema: 2\n";
  fs::create_directories(folder);
  write_file_whole(folder / ("unsaved-" + std::to_string(gone_process()) + ".yaml"), text);
  write_file_whole(folder / ("unsaved-" + std::to_string(getppid()) + ".yaml"), "of a program that still runs");
  open();
  window_->look_back();
  auto* notice = window_->home_page().findChild<QLabel*>("notice");
  ASSERT_TRUE(wait_for([&] { return notice->isVisible(); }));
  EXPECT_TRUE(notice->text().contains("was being written"));
  keep_picture(*window_, "home-unsaved-course.png");
  emit notice->linkActivated("draft:open");
  ASSERT_EQ(window_->page_name(), "authoring");
  EXPECT_EQ(window_->authoring_page().document().text().toStdString(), text);
  EXPECT_TRUE(window_->authoring_page().document().modified()) << "it is still to be saved";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "offered once; another program's stays";
  window_->authoring_page().document().undo().undo();
}

TEST_F(WindowStart, WhatIsBeingWrittenIsKeptAsideUntilItIsSavedOrGivenUp) {
  open();
  window_->write_course();
  window_->draft().set_interval(20);
  const fs::path kept = user_data_folder() / "unsaved" / ("unsaved-" + std::to_string(getpid()) + ".yaml");
  CourseDocument& document = window_->authoring_page().document();
  document.set_text(document.text() + "# not to be lost\n", "Type");
  ASSERT_TRUE(wait_for([&] { return fs::exists(kept); }));
  EXPECT_EQ(test::text_of(kept), document.bytes());
  EXPECT_FALSE(left_draft(kept.parent_path())) << "this program is there and offers nothing to another";
  document.undo().undo();
  ASSERT_TRUE(wait_for([&] { return !fs::exists(kept); })) << "all is as it was saved";
}

TEST_F(WindowStart, ATrialThatWasCutOffIsToldOnceWithTheWayToIt) {
  const fs::path patient = test::write_block_patient(box_.folder());
  const pid_t killed = box_.start({"trial", "--patient", patient.string(), "--scenario",
                                   test::write_curriculum(box_.folder()).string() + ":plain", "--device",
                                   "scripted:" + test::write_press(box_.folder()).string(), "--headless", "--out",
                                   (box_ / "cut").string()});
  // A whole block is on the disk once the log is longer than its header.
  const auto recorded = [&] {
    std::error_code error;
    const auto size = fs::file_size(box_ / "cut" / "trial.vtrial", error);
    return !error && size > 200000;
  };
  ASSERT_TRUE(wait_for(recorded, 30000));
  kill(killed, SIGKILL);
  box_.wait(killed);
  open();
  window_->look_back();
  auto* notice = window_->home_page().findChild<QLabel*>("notice");
  ASSERT_TRUE(wait_for([&] { return notice->isVisible(); }));
  EXPECT_TRUE(notice->text().contains("cut off")) << notice->text().toStdString();
  EXPECT_TRUE(notice->text().contains("Look at it"));
  keep_picture(*window_, "home-cut-off-trial.png");
  bool replayed = false;
  QObject::connect(window_.get(), &MainWindow::replay_opened, [&] { replayed = true; });
  emit notice->linkActivated("trial:" + QString::fromStdString((box_ / "cut" / "trial.vtrial").string()));
  EXPECT_TRUE(wait_for([&] { return replayed; }));
}

TEST_F(WindowStart, SizeAndPageAreThereAgain) {
  open();
  window_->resize(1100, 740);
  open_course_page(*window_);
  window_->close();
  open();
  EXPECT_EQ(window_->size(), QSize(1100, 740));
  EXPECT_EQ(window_->page_name(), "start");
}

TEST_F(WindowStart, TheLogOfASessionNamesNobody) {
  const std::string trainee = "Wilhelmina Quist", patient_name = "Ottokar von Born";
  fs::path patient = test::write_block_patient(box_.folder());
  const fs::path named = box_ / (patient_name + ".patient");
  fs::rename(patient, named);
  ASSERT_TRUE(program_log::begin(user_data_folder() / "logs"));
  open();
  RecordsDesk& desk = window_->records_page().desk();
  bool in = false;
  desk.ask<std::pair<curricula::SignedIn, long long>>(
      &desk,
      [&](curricula::Records& records) {
        curricula::People people(records);
        const long long id = people.register_trainee(trainee, "1234");
        return std::make_pair(people.sign_in(id, "1234"), id);
      },
      [&](const std::pair<curricula::SignedIn, long long>& who) {
        desk.sign_in(who.first, {who.second, curricula::Role::trainee, trainee, {}});
        in = true;
      });
  ASSERT_TRUE(wait_for([&] { return in; }));
  window_->open_files({named});
  ASSERT_TRUE(wait_for([&] { return window_->start_page().choice().patient == named; }));
  bool ready = false, finished = false;
  QString failed;
  QObject::connect(window_.get(), &MainWindow::prepared, [&] { ready = true; });
  QObject::connect(window_.get(), &MainWindow::trial_finished, [&] { finished = true; });
  QObject::connect(window_.get(), &MainWindow::trial_failed, [&](const QString& message) { failed = message; });
  window_->home_page().findChild<QPushButton*>("practise")->click();
  ASSERT_TRUE(wait_for([&] { return ready; }));
  int frames = 0;
  window_->trial_page().set_frame_hook([&](const engine::Snapshot& seen) { frames += seen.step > 0 ? 1 : 0; });
  window_->trial_page().start();
  ASSERT_TRUE(wait_for([&] { return frames > 1; }));
  window_->trial_page().end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
  emit window_->menu().home_wanted();
  // And one that fails, whose message names the patient's file.
  test::write_text(named / "face.vtp", "damaged");
  window_->home_page().findChild<QPushButton*>("practise")->click();
  ASSERT_TRUE(wait_for([&] { return !failed.isEmpty(); }));
  EXPECT_TRUE(failed.contains("face.vtp")) << "the person who sits there is told";
  program_log::note("what another message may say: " + (named / "tongue.vtu").string() + ", of " + trainee);
  window_->save_log(box_ / "sent.txt");
  auto* message = window_->home_page().findChild<QLabel*>("message");
  ASSERT_TRUE(wait_for([&] { return message->text().contains("log is saved"); }));
  const std::string sent = test::text_of(box_ / "sent.txt");
  for (const char* said : {"Vallecula ", "Qt ", "VTK ", "drawn by ", "page home", "page trial", "trial prepared in ",
                           "device mouse", "trial ended after", "trial failed: "})
    EXPECT_NE(sent.find(said), std::string::npos) << said << "\n" << sent;
  for (const std::string& never : {trainee, std::string("Quist"), patient_name, std::string("Ottokar"),
                                   box_.folder().string(), std::string("/home/"), std::string("/tmp/")})
    EXPECT_EQ(sent.find(never), std::string::npos) << never << "\n" << sent;
}

TEST_F(WindowStart, WhatWasBeingPreparedForTheOneBeforeGivesWay) {
  const fs::path patient = test::write_block_patient(box_.folder());
  open();
  window_->open_files({patient});
  ASSERT_TRUE(wait_for([&] { return window_->start_page().choice().patient == patient; }));
  int ready = 0;
  QObject::connect(window_.get(), &MainWindow::prepared, [&] { ++ready; });
  auto* practise = window_->home_page().findChild<QPushButton*>("practise");
  practise->click();
  ASSERT_EQ(window_->page_name(), "prepare");
  emit window_->station().next_trainee_begins();
  EXPECT_EQ(window_->page_name(), "home");
  practise->click();  // by the next one, while the former's still ends
  EXPECT_EQ(window_->page_name(), "prepare");
  ASSERT_TRUE(wait_for([&] { return ready > 0; }));
  EXPECT_EQ(window_->page_name(), "trial");
  EXPECT_EQ(ready, 1) << "the former's is not opened";
  emit window_->trial_page().left();
  ASSERT_EQ(window_->page_name(), "home");
  practise->click();
  emit window_->station().next_trainee_begins();
  emit window_->menu().records_wanted();
  QElapsedTimer timer;
  timer.start();
  wait_for([&] { return timer.elapsed() > 1500; });
  EXPECT_EQ(window_->page_name(), "records") << "what ended then takes nobody away from where he is";
  EXPECT_EQ(ready, 1);
}

// The manikin of 3.2 kg is no infant of 1.2 kg: its scenario is changed, and what was told of that is taken back.
TEST_F(WindowStart, WhatIsToldOfAPatientsSizeGoesWithTheChoiceItSpeaksOf) {
  const fs::path patient = test::coarse_infant();
  window_ = std::make_unique<MainWindow>();
  window_->show_start({curricula::load_curriculum(curricula_folder() / "first-intubation.yaml")});
  window_->show();
  StartPage& start = window_->start_page();
  const auto told = [&] {
    for (const QLabel* label : window_->findChildren<QLabel*>())
      if (label->text().contains("as large as an infant of")) return true;
    return false;
  };
  const auto take = [&] {
    start.select("preterm-premedicated", "scripted:expert");
    ASSERT_EQ(start.chosen_scenario(), "preterm-premedicated");
    start.take_patient(patient);
  };
  take();
  ASSERT_TRUE(wait_for([&] { return start.chosen_scenario() == "term-tube"; }));
  EXPECT_TRUE(told());
  start.select("delivery-room", "scripted:expert");
  EXPECT_FALSE(told());
  take();
  start.select("laryngospasm", "scripted:expert");  // before the patient was looked at
  QElapsedTimer timer;
  timer.start();
  wait_for([&] { return timer.elapsed() > 1500; });
  EXPECT_EQ(start.chosen_scenario(), "laryngospasm");
  EXPECT_FALSE(told());
}

TEST_F(WindowStart, AboutNamesEveryPartWithVersionAndLicence) {
  for (const Part& part : program_parts()) {
    EXPECT_FALSE(part.version.isEmpty()) << part.name.toStdString();
    EXPECT_FALSE(part.licence.isEmpty()) << part.name.toStdString();
  }
  AboutDialog about;
  about.show();
  QApplication::processEvents();
  QString all;
  for (const QLabel* label : about.findChildren<QLabel*>()) all += label->text() + "\n";
  EXPECT_TRUE(all.contains("not a medical device") && all.contains("GNU Affero General Public License"));
  EXPECT_FALSE(opengl_renderer().isEmpty()) << "there is one on this screen: the views need it";
  keep_picture(about, "about.png");
}

}  // namespace
}  // namespace vallecula::gui::window_test
