// Through the whole window by mouse and keys, as a person goes; VALLECULA_PICTURES=DIR keeps a picture of every page,
// on the dark and on the light ground, to be looked at in one folder; in another language, size or text as
// window_wishes.h says. VALLECULA_SLOW adds the import's further steps (in English).
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>

#include "gui/authoring/authoring_page.h"
#include "gui/import/import_wizard.h"
#include "gui/import/source_page.h"
#include "gui/pages/about_dialog.h"
#include "gui/pages/first_run.h"
#include "gui/pages/help_dialog.h"
#include "gui/pages/look_settings.h"
#include "gui/pages/main_menu.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/result_page.h"
#include "gui/pages/settings_dialog.h"
#include "gui/pages/trial_page.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/user_paths.h"
#include "gui/views/theme.h"
#include "pipeline/manikin/manikin.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"
#include "tests/gui/window_wishes.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

class WindowTour : public Screen, public ::testing::WithParamInterface<const char*> {
 protected:
  WindowTour() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~WindowTour() override {
    window_.reset();
    apply_look({});
    install_language(*qApp, "en");
    unsetenv("VALLECULA_HOME");
  }
  /// By mouse, where it is seen.
  void click(QWidget* on) {
    ASSERT_NE(on, nullptr);
    ASSERT_TRUE(on->isVisible()) << on->objectName().toStdString();
    QTest::mouseClick(on, Qt::LeftButton);
    settle(150);
  }
  /// What `within` says in its class's words, by its English.
  void click(QWidget& within, const char* english) {
    const QString text = within.metaObject()->tr(english, nullptr).remove('&');
    for (QAbstractButton* button : within.findChildren<QAbstractButton*>())
      if (button->isVisible() && QString(button->text()).remove('&').startsWith(text)) return click(button);
    FAIL() << "no button says " << text.toStdString() << " on " << window_->page_name().toStdString();
  }
  void key(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
    QApplication::setActiveWindow(window_.get());  // no window manager gives it back after a dialog
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus != nullptr && focus->isVisible() ? focus : window_.get(), key, with);
    settle(150);
  }
  void settle(int ms) {
    QElapsedTimer timer;
    timer.start();
    wait_for([&] { return timer.elapsed() > ms; });
  }
  /// Kept to be looked at; a page that shows nothing fails.
  void picture(QWidget& of, const std::string& name) {
    settle(50);
    EXPECT_GT(colours_in(of.grab().toImage()), 6) << name;
    keep_picture(of, std::string(GetParam()) + "-" + name + ".png");
  }
  void page(const char* name, const std::string& file) {
    ASSERT_EQ(window_->page_name(), name);
    picture(*window_, file);
  }
  template <class Dialog>
  Dialog* dialog() {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* found = qobject_cast<Dialog*>(widget); found != nullptr && found->isVisible()) return found;
    return nullptr;
  }
  template <class Dialog>
  void dialog_by(void (MainMenu::*wanted)(), const std::string& name) {
    emit (window_->menu().*wanted)();
    settle(200);
    Dialog* found = dialog<Dialog>();
    ASSERT_NE(found, nullptr) << name;
    picture(*found, name);
    QTest::keyClick(found, Qt::Key_Escape);
    ASSERT_TRUE(wait_for([&] { return dialog<Dialog>() == nullptr; }, 5000)) << name << " does not go by Esc";
  }

  test::Sandbox box_;
  std::unique_ptr<MainWindow> window_;
};

TEST_P(WindowTour, EveryPageByMouseAndKeys) {
  LookSettings look;
  look.ground = GetParam();
  wish_words(look);
  const fs::path patient = test::write_block_patient(box_.folder());
  window_ = std::make_unique<MainWindow>();
  window_->show_start({curricula::load_curriculum(test::write_curriculum(box_.folder())),
                       curricula::load_curriculum(default_curriculum()),
                       curricula::load_curriculum(curricula_folder() / "neonatal-intubation.yaml")});
  window_->start_page().add_patient(patient, true);
  wish_size(*window_);
  window_->show();
  QApplication::setActiveWindow(window_.get());
  settle(300);
  page("home", "01-home");
  dialog_by<FirstRun>(&MainMenu::first_steps_wanted, "02-first-steps");
  dialog_by<SettingsDialog>(&MainMenu::settings_wanted, "03-settings");
  dialog_by<AboutDialog>(&MainMenu::about_wanted, "04-about");
  dialog_by<HelpDialog>(&MainMenu::help_wanted, "05-help");

  click(window_->home_page().findChild<QPushButton*>("course"));
  auto* course = window_->start_page().findChild<QComboBox*>("curriculum");
  course->setFocus();
  key(Qt::Key_Down);
  key(Qt::Key_Down);
  page("start", "06-course");
  course->setFocus();
  key(Qt::Key_Up);
  key(Qt::Key_Up);
  key(Qt::Key_Escape);
  ASSERT_TRUE(wait_for([&] { return window_->page_name() == "home"; }, 5000));

  click(window_->home_page().findChild<QPushButton*>("records"));
  settle(600);
  page("records", "07-records");
  key(Qt::Key_Escape);
  ASSERT_TRUE(wait_for([&] { return window_->page_name() == "home"; }, 5000));
  click(window_->home_page().findChild<QPushButton*>("devices"));
  settle(600);
  page("devices", "08-devices");
  key(Qt::Key_Escape);
  ASSERT_TRUE(wait_for([&] { return window_->page_name() == "home"; }, 5000));

  click(window_->home_page().findChild<QPushButton*>("write_course"));
  page("authoring", "09-authoring");
  auto* tabs = window_->authoring_page().findChild<QTabWidget*>();
  for (int i = 1; i < tabs->count(); ++i) {
    QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, Qt::NoModifier, tabs->tabBar()->tabRect(i).center());
    page("authoring", "09-authoring-" + std::to_string(i + 1));
  }
  click(window_->authoring_page(), "Back");
  ASSERT_EQ(window_->page_name(), "home");

  click(window_->home_page().findChild<QPushButton*>("new_patient"));
  page("import", "10-import-source");
  if (std::getenv("VALLECULA_SLOW") != nullptr) {
    pipeline::ManikinOptions options;
    options.weight_kg = 0.8;
    pipeline::write_manikin(options, box_ / "ct");
    auto* place = window_->import_wizard().source_page().findChild<QLineEdit*>();
    QTest::keyClicks(place, QString::fromStdString((box_ / "ct").string()));
    QTest::keyClick(place, Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return !window_->import_wizard().work().busy(); }));
    page("import", "10-import-source-found");
    click(window_->import_wizard(), "Read and find");
    settle(1500);
    page("import", "11-import-segment");
    ASSERT_TRUE(wait_for([&] { return window_->import_wizard().step() == "check"; }, 300000));
    settle(3000);
    page("import", "12-import-check");
    click(window_->import_wizard(), "Build the patient");
    ASSERT_TRUE(wait_for([&] { return window_->import_wizard().step() == "build" && !window_->import_wizard().work().busy(); }, 300000));
    settle(1000);
    page("import", "13-import-build");
    click(window_->import_wizard(), "Leave");
  } else {
    click(window_->import_wizard().source_page(), "&Back to the start");
  }
  ASSERT_EQ(window_->page_name(), "home");

  bool ready = false, finished = false, replayed = false;
  QObject::connect(window_.get(), &MainWindow::prepared, [&] { ready = true; });
  QObject::connect(window_.get(), &MainWindow::trial_finished, [&] { finished = true; });
  QObject::connect(window_.get(), &MainWindow::replay_opened, [&] { replayed = true; });
  click(window_->home_page().findChild<QPushButton*>("practise"));
  ASSERT_TRUE(wait_for([&] { return ready; }));
  page("trial", "14-trial-introduction");
  int frames = 0;
  window_->trial_page().set_frame_hook([&](const engine::Snapshot& seen) { frames += seen.step > 0 ? 1 : 0; });
  // Enter closes the card, Enter again starts.
  for (int i = 0; i < 2; ++i) {
    QTest::keyClick(&window_->trial_page(), Qt::Key_Return);
    settle(100);
  }
  ASSERT_TRUE(wait_for([&] { return frames > 2; })) << "Enter starts";
  page("trial", "15-trial");
  QTest::keyClick(&window_->trial_page(), Qt::Key_Escape);
  ASSERT_TRUE(wait_for([&] { return finished; })) << "Esc ends";
  page("result", "16-result");
  click(window_->findChild<ResultPage*>()->findChild<QPushButton*>("replay"));
  ASSERT_TRUE(wait_for([&] { return replayed; }));
  settle(1500);
  page("replay", "17-replay");
  QTest::keyClick(&window_->replay_page(), Qt::Key_Escape);
  ASSERT_TRUE(wait_for([&] { return window_->page_name() == "result"; }, 5000));
  key(Qt::Key_1, Qt::ControlModifier);
  ASSERT_EQ(window_->page_name(), "home");
  auto* recent = window_->home_page().findChild<QListWidget*>("recent");
  ASSERT_TRUE(wait_for([&] { return recent->count() == 2; })) << "the patient and the trial";
  page("home", "18-home-afterwards");
}

INSTANTIATE_TEST_SUITE_P(Grounds, WindowTour, ::testing::Values("dark", "light"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace vallecula::gui::window_test
