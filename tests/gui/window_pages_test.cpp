// The window as a person uses it: choosing, steering, ending, closing; and the virtual display it is tested on.
#include <QCloseEvent>
#include <QComboBox>
#include <QLabel>
#include <QTreeWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QStandardItemModel>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <set>

#include "device/drivers/mouse_device.h"
#include "gui/report/advice.h"
#include "gui/pages/blade_control.h"
#include "gui/pages/key_moments.h"
#include "gui/pages/main_window.h"
#include "gui/pages/result_page.h"
#include "gui/pages/trial_page.h"
#include "gui/session/user_paths.h"
#include "gui/views/operator_view.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/window_patient.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

/// Sets an environment variable for one scope.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* now = std::getenv(name)) before_ = now, had_ = true;
    value != nullptr ? setenv(name, value, 1) : unsetenv(name);
  }
  ~Variable() { had_ ? setenv(name_, before_.c_str(), 1) : unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::string before_;
  bool had_ = false;
};

TEST(VirtualDisplay, IsThereForItsTimeAndGoneAfterwards) {
  const Variable none("DISPLAY", nullptr);
  const Variable no_wayland("WAYLAND_DISPLAY", nullptr);
  EXPECT_NE(display_problem(), "");
  pid_t server = 0;
  {
    const VirtualDisplay display;
    server = display.process();
    EXPECT_STREQ(std::getenv("DISPLAY"), display.name().c_str());
    EXPECT_EQ(display_problem(), "");
    EXPECT_EQ(kill(server, 0), 0);
    const VirtualDisplay second;
    EXPECT_NE(second.name(), display.name());
  }
  EXPECT_NE(kill(server, 0), 0) << "the server was left behind";
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
}

TEST(VirtualDisplay, SaysWhatToInstallWhereThereIsNoXvfb) {
  const Variable nowhere("PATH", "/nonexistent");
  const Variable display("DISPLAY", ":987");
  EXPECT_NE(display_problem().find(":987"), std::string::npos);
  try {
    const VirtualDisplay made;
    FAIL() << "a display without a server";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("install xvfb"), std::string::npos) << error.what();
  }
  EXPECT_STREQ(std::getenv("DISPLAY"), ":987");
}

TEST(WindowCommand, WithoutADisplaySaysWhatWorks) {
  const test::Sandbox box;
  const test::Outcome outcome = box.run({}, {"DISPLAY=", "WAYLAND_DISPLAY="});
  EXPECT_EQ(outcome.exit_code, 1);
  ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
  EXPECT_NE(outcome.err.find("vallecula demo"), std::string::npos) << outcome.err;
}

TEST(Advice, PutsTheGumFirstAndAlwaysSaysSomething) {
  curricula::Scenario scenario;
  scenario.targets = {5.0, 2.0};
  scenario.pass = {6.8, 3.0, 50.0, 30.0, 3.0, 0.2};
  curricula::Score score;
  EXPECT_NE(what_to_change(score, scenario).find("never entered"), std::string::npos) << "nothing was done yet";
  score.attempt_begun = true;
  score.passed = true;
  score.glottis_visible_max_percent = 70.0;
  score.peak_tongue_force_n = 4.0;
  score.attempt_time_s = 15.0;
  EXPECT_EQ(what_to_change(score, scenario).find("Well done"), 0u);
  score.attempt_time_s = 21.0;  // of 30 s: nearer its limit than the force is
  score.mouth_entries = 1;
  EXPECT_EQ(what_to_change(score, scenario), "Well done. Do it the same way again.") << "in once, and nothing to blame";
  score.mouth_entries = 3;
  EXPECT_NE(what_to_change(score, scenario).find("in one motion: the blade went in 3 times"), std::string::npos);
  score.mouth_entries = 1;
  score.passed = false;
  std::set<std::string> said;
  score.attempt_time_s = 40.0;
  said.insert(what_to_change(score, scenario));
  score.time_over_target_s = 4.0;
  said.insert(what_to_change(score, scenario));
  score.glottis_visible_max_percent = 20.0;
  said.insert(what_to_change(score, scenario));
  score.glottis_visible_max_percent = 0.0;
  said.insert(what_to_change(score, scenario));
  score.peak_tongue_force_n = 9.0;
  said.insert(what_to_change(score, scenario));
  score.time_over_force_limit_s = 1.0;
  said.insert(what_to_change(score, scenario));
  score.peak_gum_force_n = 10.0;
  said.insert(what_to_change(score, scenario));
  EXPECT_EQ(said.size(), 7u) << "each shortcoming has its own sentence, the weightier one first";
  EXPECT_NE(what_to_change(score, scenario).find("gum"), std::string::npos);
  EXPECT_EQ(what_to_change(score, scenario).find("upper"), std::string::npos) << "the score does not tell which gum";
}

TEST(Advice, OfAnIntubationPutsTheInfantAndTheTubeBeforeTheView) {
  curricula::Scenario scenario;
  scenario.pass = {6.8, 3.0, 50.0, 30.0, 3.0, 0.2};
  scenario.intubation.emplace();
  auto& pass = scenario.intubation->pass;
  pass.lowest_heart_per_min = 100.0;
  pass.lowest_spo2_percent = 70.0;
  pass.tube_force_n = 3.0;
  pass.attempts = 2;
  pass.co2_confirmed = true;
  curricula::Score score;
  score.attempt_begun = true;
  score.peak_gum_force_n = 10.0;
  auto& tube = score.intubation.emplace();
  std::set<std::string> said;
  using curricula::Outcome;
  for (const Outcome outcome : {Outcome::oesophagus, Outcome::mainstem, Outcome::too_deep, Outcome::too_shallow,
                                Outcome::cricoid_too_narrow, Outcome::cords_closed, Outcome::abandoned}) {
    tube.outcome = outcome;
    said.insert(what_to_change(score, scenario));
  }
  score.time_of_first_sight_s = 5.0;
  EXPECT_EQ(what_to_change(score, scenario).find("The glottis was in sight"), 0u) << "it need not be told to look";
  tube.lowest_heart_per_min = 80.0;
  EXPECT_NE(what_to_change(score, scenario).find("heart"), std::string::npos) << "given up or not, the infant first";
  tube.lowest_heart_per_min.reset();
  score.time_of_first_sight_s = -1.0;
  tube.recognised_late = true;
  EXPECT_NE(what_to_change(score, scenario).find("oesophagus"), std::string::npos);
  said.insert(what_to_change(score, scenario));
  tube.recognised_late = false;
  tube.outcome = Outcome::good_depth;
  tube.attempts.resize(3);
  said.insert(what_to_change(score, scenario));  // not confirmed
  tube.co2_confirmed = true;
  said.insert(what_to_change(score, scenario));  // three attempts
  tube.tip_load_n.value = 4.0;
  said.insert(what_to_change(score, scenario));
  tube.lowest_spo2_percent = 60.0;
  said.insert(what_to_change(score, scenario));
  tube.lowest_heart_per_min = 80.0;
  said.insert(what_to_change(score, scenario));
  EXPECT_EQ(said.size(), 13u) << "each has a sentence of its own, the weightier one first";
  EXPECT_NE(what_to_change(score, scenario).find("heart"), std::string::npos);
  tube = {};
  tube.outcome = Outcome::good_depth;
  tube.co2_confirmed = true;
  EXPECT_NE(what_to_change(score, scenario).find("gum"), std::string::npos) << "then the laryngoscopy";
}

TEST(KeyMoments, ComeInTheOrderOfTheProcedure) {
  const auto package = coarse_patient();
  KeyMoments moments(package, 25.0);
  std::vector<std::string> seen;
  const auto pass = [&](double into, double lift_mm, double visible) {
    auto snapshot = lifted_snapshot(package, into, lift_mm);
    snapshot.glottis_visible = visible;
    for (const auto& moment : moments.at(snapshot)) seen.push_back(moment);
  };
  engine::Snapshot nothing_yet;
  EXPECT_TRUE(moments.at(nothing_yet).empty());
  for (int i = 0; i <= 40; ++i) pass(i / 40.0, 0.0, 0.0);
  for (int i = 0; i <= 12; ++i) pass(1.0, i, 0.05 * i);
  for (int i = 40; i >= 0; --i) pass(i / 40.0, 12.0 * i / 40.0, 0.0);
  const std::vector<std::string> firsts = {"1-lips",        "2-sweep",      "3-vallecula",
                                           "4-first-sight", "5-best-sight", "6-withdrawal"};
  std::vector<std::string> order;
  for (const auto& moment : seen)
    if (std::find(order.begin(), order.end(), moment) == order.end()) order.push_back(moment);
  EXPECT_EQ(order, firsts);
  EXPECT_GT(std::count(seen.begin(), seen.end(), "5-best-sight"), 1) << "a better view is a new picture";
  for (const auto& moment : firsts) {
    if (moment == "5-best-sight") continue;
    EXPECT_EQ(std::count(seen.begin(), seen.end(), moment), 1) << moment;
  }
}

TEST(KeyMoments, OfAnIntubationGoOnUntilTheDetectorTells) {
  const auto package = coarse_patient();
  KeyMoments moments(package, 25.0);
  std::vector<std::string> seen;
  const auto pass = [&](double into, engine::TipPlace place, double past_cords_m, bool yellow) {
    auto snapshot = lifted_snapshot(package, into, 0.0);
    snapshot.has_intubation = true;
    snapshot.glottis_visible = 0.0;
    snapshot.intubation.place = place;
    snapshot.intubation.past_cords_m = past_cords_m;
    snapshot.intubation.detector_yellow = yellow;
    for (const auto& moment : moments.at(snapshot))
      if (std::find(seen.begin(), seen.end(), moment) == seen.end()) seen.push_back(moment);
  };
  for (int i = 0; i <= 40; ++i) pass(i / 40.0, engine::TipPlace::mouth, 0.0, false);
  pass(1.0, engine::TipPlace::oesophagus, 0.020, false);
  const std::vector<std::string> before = {"1-lips", "2-sweep", "3-vallecula"};
  EXPECT_EQ(seen, before) << "a tube behind the larynx is between no cords";
  for (int mm = -10; mm <= 24; ++mm)
    pass(1.0, mm < 0 ? engine::TipPlace::larynx : engine::TipPlace::trachea, 1e-3 * mm, false);
  for (int i = 40; i >= 0; --i) pass(i / 40.0, engine::TipPlace::trachea, 0.024, false);
  pass(0.0, engine::TipPlace::trachea, 0.024, true);
  const std::vector<std::string> all = {"1-lips",          "2-sweep",      "3-vallecula",      "6-tip-at-cords",
                                        "7-between-cords", "8-withdrawal", "9-detector-yellow"};
  EXPECT_EQ(seen, all);
}

/// What a window said.
struct Heard {
  explicit Heard(MainWindow& window) {
    QObject::connect(&window, &MainWindow::trial_finished, [this](const TrialOutcome&) { ++finished; });
    QObject::connect(&window, &MainWindow::trial_failed, [this](const QString& message) { failure = message; });
  }
  int finished = 0;
  QString failure;
};

class Window : public Screen {
 protected:
  Window() : home_("VALLECULA_HOME", box_.home().c_str()) {}
  TrialSetup scripted() {
    TrialSetup setup;
    setup.patient = test::write_block_patient(box_.folder());
    setup.curriculum = test::write_curriculum(box_.folder());
    setup.scenario = "plain";
    setup.device = "scripted:" + test::write_press(box_.folder()).string();
    setup.out = box_ / "out";
    return setup;
  }
  TrialSetup by_mouse() {
    TrialSetup setup = scripted();
    setup.device = "mouse";
    return setup;
  }

  test::Sandbox box_;
  Variable home_;
};

TEST_F(Window, OpensOnTheShippedScenariosAndHandsOverTheChoice) {
  MainWindow window;
  window.show_start({curricula::load_curriculum(default_curriculum())});
  window.show();
  QApplication::processEvents();
  open_course_page(window);
  EXPECT_GT(colours_in(window.grab().toImage()), 6);
  EXPECT_EQ(window.start_page().findChild<QTreeWidget*>()->topLevelItemCount(), 3);
  ASSERT_TRUE(window.start_page().select("preterm", "scripted:expert"));
  const Choice choice = window.start_page().choice();
  EXPECT_EQ(choice.scenario.id, "preterm");
  EXPECT_EQ(choice.device, "scripted:expert");
  EXPECT_TRUE(choice.patient.empty()) << "the built-in manikin unless another is chosen";
  EXPECT_FALSE(window.start_page().select("no such scenario", "mouse"));
}

TEST_F(Window, OffersEveryCurriculumAndAsksWhoHasTheTube) {
  MainWindow window;
  window.show_start({curricula::load_curriculum(default_curriculum()),
                     curricula::load_curriculum(curricula_folder() / "first-intubation.yaml")});
  window.show();
  QApplication::processEvents();
  open_course_page(window);
  StartPage& page = window.start_page();
  auto* curriculum = page.findChild<QComboBox*>("curriculum");
  auto* device = page.findChild<QComboBox*>("device");
  auto* second = page.findChild<QComboBox*>("second");
  EXPECT_EQ(curriculum->count(), 2);
  EXPECT_FALSE(second->isVisibleTo(&page)) << "laryngoscopy alone needs no second hand";
  const int novice = device->findData("scripted:novice");
  EXPECT_TRUE(qobject_cast<QStandardItemModel*>(device->model())->item(novice)->isEnabled());
  ASSERT_TRUE(page.select("term-tube", "mouse"));
  EXPECT_EQ(curriculum->currentIndex(), 1);
  EXPECT_FALSE(second->isVisibleTo(&page)) << "a mouse takes blade and tube in turn";
  EXPECT_FALSE(qobject_cast<QStandardItemModel*>(device->model())->item(novice)->isEnabled()) << "it has no tube";
  page.choose_device("falcon", "Falcon");
  EXPECT_TRUE(second->isVisibleTo(&page));
  EXPECT_EQ(page.choice().second.toStdString(), "");
  second->setCurrentIndex(second->findData("mouse"));
  const Choice choice = page.choice();
  EXPECT_EQ(choice.second.toStdString(), "mouse");
  EXPECT_EQ(choice.device.toStdString(), "falcon");
  EXPECT_EQ(choice.curriculum.filename(), "first-intubation.yaml");
  keep_picture(window, "start.png");
  ASSERT_TRUE(page.select("term", "scripted:novice"));
  EXPECT_TRUE(page.choice().second.isEmpty());
}

TEST_F(Window, RunsAScriptedTrialToItsResultPage) {
  MainWindow window;
  window.show();
  Heard heard(window);
  int frames = 0;
  double deepest = 0.0;
  window.trial_page().set_frame_hook([&](const engine::Snapshot& snapshot) {
    ++frames;
    deepest = std::min(deepest, snapshot.proxy_pose.position.z());
  });
  window.prepare(scripted(), true);
  EXPECT_EQ(window.page_name(), "prepare") << "the window does not wait for the scene";
  ASSERT_TRUE(wait_for([&] { return window.trial_page().running(); }));
  EXPECT_EQ(window.page_name(), "trial");
  const QImage trial = window.grab().toImage();
  ASSERT_TRUE(wait_for([&] { return heard.finished > 0 || !heard.failure.isEmpty(); }));
  ASSERT_EQ(heard.failure.toStdString(), "");
  EXPECT_EQ(window.page_name(), "result");
  EXPECT_GT(colours_in(trial), 10);
  EXPECT_GT(frames, 0);  // how many depends on what else the machine does
  EXPECT_LT(deepest, -0.0005) << "the pressing blade was seen on its way";
  for (const char* name : {"trial.vtrial", "score.json", "report.html", "force.png"})
    EXPECT_TRUE(fs::exists(box_ / "out" / name)) << name;
  EXPECT_GT(colours_in(window.grab().toImage()), 20) << "the plot and the figures";
  const auto labels = window.findChild<ResultPage*>()->findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->toolTip().contains("step was not finished in time") &&
           label->toolTip().contains("Real-time set-up: servo: ");
  }));
}

TEST_F(Window, SaysWhatIsWrongWithAPatientAndStaysOpen) {
  MainWindow window;
  window.show_start({curricula::load_curriculum(default_curriculum())});
  window.show();
  Heard heard(window);
  TrialSetup setup = scripted();
  std::ofstream(setup.patient / "face.vtp", std::ios::app) << "x";
  window.prepare(setup, true);
  ASSERT_TRUE(wait_for([&] { return !heard.failure.isEmpty(); }));
  EXPECT_TRUE(heard.failure.contains("face.vtp"));
  EXPECT_EQ(window.page_name(), "home");
  EXPECT_EQ(window.home_page().findChild<QLabel*>("message")->text(), heard.failure);
  EXPECT_TRUE(window.isVisible());
  EXPECT_FALSE(fs::exists(box_ / "out" / "trial.vtrial"));
}

TEST_F(Window, SteersTheBladeWithTheMouseAndResetsIt) {
  MainWindow window;
  window.show();
  bool ready = false;
  QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
  window.prepare(by_mouse(), false);
  ASSERT_TRUE(wait_for([&] { return ready; }));
  TrialPage& page = window.trial_page();
  EXPECT_FALSE(page.running()) << "a person presses Start";
  engine::Snapshot last;
  page.set_frame_hook([&](const engine::Snapshot& snapshot) { last = snapshot; });
  page.start();
  ASSERT_TRUE(wait_for([&] { return last.step > 50; }));
  const engine::Vec3 begin = last.device_pose.position;
  OperatorView& view = page.operator_view();
  const auto mouse = [&](QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons) {
    QMouseEvent event(type, at, view.mapToGlobal(at), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  };
  mouse(QEvent::MouseButtonPress, {200, 200}, Qt::LeftButton, Qt::LeftButton);
  const double expected_m = 1e-3 * view.mm_per_pixel() * 40;
  mouse(QEvent::MouseMove, {240, 200}, Qt::NoButton, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, {240, 200}, Qt::LeftButton, Qt::NoButton);
  ASSERT_TRUE(wait_for([&] { return (last.device_pose.position - begin).norm() > 0.95 * expected_m; }, 5000));
  const engine::Vec3 moved = last.device_pose.position - begin;
  EXPECT_GT(moved.dot(-engine::Vec3::UnitX()), 0.9 * expected_m)
      << "to the right on the screen is to the patient's right";

  page.reset();
  last = {};
  ASSERT_TRUE(wait_for([&] { return last.step > 20; }));
  EXPECT_LT((last.device_pose.position - begin).norm(), 1e-4) << "the hand begins where it began";
  Heard heard(window);
  page.end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return heard.finished > 0; }));
  EXPECT_EQ(window.page_name(), "result");
}

TEST_F(Window, ClosedInTheMiddleOfATrialItKeepsTheLog) {
  {
    MainWindow window;
    window.show();
    int frames = 0;
    window.trial_page().set_frame_hook([&](const engine::Snapshot& snapshot) { frames += snapshot.step > 0 ? 1 : 0; });
    window.prepare(scripted(), true);
    ASSERT_TRUE(wait_for([&] { return frames > 1; }));
    window.close();
  }
  EXPECT_TRUE(fs::exists(box_ / "out" / "trial.vtrial"));
  EXPECT_FALSE(fs::exists(box_ / "out" / "score.json"));
}

}  // namespace
}  // namespace vallecula::gui::window_test
