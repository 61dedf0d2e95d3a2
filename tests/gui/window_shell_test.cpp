// The window's frame: the first page, the menus, the settings, what is dropped on it.
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QUrl>

#include "curricula/trial_log.h"
#include "gui/import/import_wizard.h"
#include "gui/import/source_page.h"
#include "gui/pages/look_settings.h"
#include "gui/pages/main_menu.h"
#include "gui/pages/open_dialog.h"
#include "gui/pages/result_page.h"
#include "gui/pages/settings_dialog.h"
#include "gui/pages/trial_page.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"
#include "gui/views/gl_view.h"
#include "gui/views/theme.h"
#include "tests/gui/accessible.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

class WindowShell : public Screen {
 protected:
  WindowShell() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~WindowShell() override {
    window_.reset();
    apply_look({});
    unsetenv("VALLECULA_HOME");
  }
  void open() {
    window_ = std::make_unique<MainWindow>();
    window_->show_start({curricula::load_curriculum(test::write_curriculum(box_.folder())),
                         curricula::load_curriculum(default_curriculum())});
    window_->show();
    QApplication::setActiveWindow(window_.get());  // shortcuts go to the active window, and no window manager makes one
    QApplication::processEvents();
  }
  HomePage& home() { return window_->home_page(); }
  QString page() { return window_->page_name(); }
  QAction* action(const char* name) {
    auto* found = window_->menu().findChild<QAction*>(name);
    if (found == nullptr)
      for (QMenu* menu : window_->menuBar()->findChildren<QMenu*>())
        if (found == nullptr) found = menu->findChild<QAction*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void key(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
    QApplication::setActiveWindow(window_.get());  // no window manager gives it back after a dialog
    QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : window_.get(), key, with);
  }
  /// As a file manager does; false: the window does not take it.
  bool drop(const std::vector<fs::path>& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const fs::path& path : paths) urls << QUrl::fromLocalFile(QString::fromStdString(path.string()));
    data.setUrls(urls);
    QDragEnterEvent enter({400, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QApplication::sendEvent(window_.get(), &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent dropped({400, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &dropped);
    return true;
  }
  QString message() { return home().findChild<QLabel*>("message")->text(); }

  test::Sandbox box_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(WindowShell, OpensAtHomeWithTheWayToEverythingByKeys) {
  open();
  EXPECT_EQ(page(), "home");
  auto* practise = home().findChild<QPushButton*>("practise");
  EXPECT_TRUE(practise->hasFocus()) << "Enter goes on";
  EXPECT_TRUE(practise->accessibleDescription().contains("the built-in manikin"));
  EXPECT_TRUE(practise->accessibleDescription().contains("ouse"));
  keep_picture(*window_, "home-dark.png");
  const std::vector<std::pair<Qt::Key, const char*>> ways = {
      {Qt::Key_2, "start"}, {Qt::Key_3, "records"}, {Qt::Key_4, "devices"}, {Qt::Key_1, "home"}};
  for (const auto& [number, name] : ways) {
    key(number, Qt::ControlModifier);
    EXPECT_EQ(page(), name);
  }
  choose_at_home(*window_, "course");
  key(Qt::Key_Escape);  // as a button that is pressed, which is seen for a moment
  ASSERT_TRUE(wait_for([&] { return page() == "home"; }, 5000));
  choose_at_home(*window_, "new_patient");
  EXPECT_EQ(page(), "import");
  key(Qt::Key_1, Qt::ControlModifier);
  choose_at_home(*window_, "write_course");
  EXPECT_EQ(page(), "authoring");
  key(Qt::Key_1, Qt::ControlModifier);
  EXPECT_EQ(page(), "authoring") << "it has a way out of its own, which asks for what is not saved";
}

TEST_F(WindowShell, GoesBackToWhereOneCameFrom) {
  open();
  choose_at_home(*window_, "devices");
  key(Qt::Key_Escape);  // as a button that is pressed, which is seen for a moment
  ASSERT_TRUE(wait_for([&] { return page() == "home"; }, 5000));
  open_course_page(*window_);
  for (QPushButton* button : window_->start_page().findChildren<QPushButton*>())
    if (button->text() == "Devices ...") button->click();
  EXPECT_EQ(page(), "devices");
  key(Qt::Key_Escape);
  EXPECT_TRUE(wait_for([&] { return page() == "start"; }, 5000));
}

TEST_F(WindowShell, PractiseGoesOnWithTheLastChoiceAndTheTrialIsRemembered) {
  const fs::path patient = test::write_block_patient(box_.folder());
  {
    const auto kept = user_settings();
    kept->setValue("scenario", "plain");
    kept->setValue("device", "mouse");
    kept->setValue("patient", QString::fromStdString(patient.string()));
  }
  open();
  EXPECT_TRUE(home().findChild<QPushButton*>("practise")->accessibleDescription().contains("block"));
  bool ready = false;
  QObject::connect(window_.get(), &MainWindow::prepared, [&] { ready = true; });
  key(Qt::Key_Return);
  EXPECT_EQ(page(), "prepare");
  EXPECT_FALSE(window_->menuBar()->isVisible()) << "no clutter";
  ASSERT_TRUE(wait_for([&] { return ready; }));
  EXPECT_EQ(page(), "trial");
  EXPECT_FALSE(window_->menuBar()->isVisible());
  EXPECT_FALSE(drop({patient})) << "not in a trial";
  int frames = 0;
  window_->trial_page().set_frame_hook([&](const engine::Snapshot& seen) { frames += seen.step > 0 ? 1 : 0; });
  window_->trial_page().start();
  ASSERT_TRUE(wait_for([&] { return frames > 1; }));
  bool finished = false;
  QObject::connect(window_.get(), &MainWindow::trial_finished, [&] { finished = true; });
  window_->trial_page().end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished; }));
  EXPECT_TRUE(window_->menuBar()->isVisible());
  QPushButton* other = nullptr;
  for (auto* button : window_->findChild<ResultPage*>()->findChildren<QPushButton*>())
    if (button->text() == "Other scenario") other = button;
  ASSERT_NE(other, nullptr);
  QTest::mouseClick(other, Qt::LeftButton);
  ASSERT_EQ(page(), "start") << "where scenarios are chosen";
  EXPECT_EQ(window_->start_page().choice().patient, patient);
  EXPECT_EQ(window_->start_page().choice().scenario.id, "plain");
  EXPECT_EQ(window_->findChild<QComboBox*>("curriculum")->currentText(), "Test course");
  key(Qt::Key_1, Qt::ControlModifier);
  ASSERT_EQ(page(), "home");
  auto* recent = home().findChild<QListWidget*>("recent");
  ASSERT_TRUE(wait_for([&] { return recent->count() == 2; }));
  EXPECT_TRUE(recent->item(0)->text().startsWith("Trial: Blocks & <plain> shapes, "))
      << recent->item(0)->text().toStdString();
  EXPECT_EQ(recent->item(1)->text(), "Patient: block");
  keep_picture(*window_, "home-recent.png");
  bool replayed = false;
  QObject::connect(window_.get(), &MainWindow::replay_opened, [&] { replayed = true; });
  recent->setFocus();
  recent->setCurrentRow(0);
  key(Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return replayed; }));
  EXPECT_EQ(page(), "replay");
}

TEST_F(WindowShell, WhatIsDroppedIsOpenedOrToldInOneMessage) {
  const fs::path patient = test::write_block_patient(box_.folder());
  const fs::path ct = box_ / "ct";
  fs::create_directories(ct);
  test::write_text(ct / "I1", "no DICOM");
  open();
  ASSERT_TRUE(drop({patient}));
  ASSERT_TRUE(wait_for([&] { return window_->start_page().choice().patient == patient; }));
  EXPECT_EQ(page(), "home");
  ASSERT_TRUE(drop({ct}));
  ASSERT_TRUE(wait_for([&] { return page() == "import"; }));
  EXPECT_EQ(window_->import_wizard().source_page().findChild<QLineEdit*>()->text().toStdString(), ct.string());
  ASSERT_TRUE(wait_for([&] { return !window_->import_wizard().work().busy(); }));
  key(Qt::Key_1, Qt::ControlModifier);

  test::write_text(box_ / "photo.jpeg", "x");
  ASSERT_TRUE(drop({box_ / "photo.jpeg"}));
  ASSERT_TRUE(wait_for([&] { return message().contains("photo.jpeg"); }));
  keep_picture(*window_, "home-message.png");
  test::write_text(box_ / "broken.yaml", "schema: 2\nid: [\n");
  ASSERT_TRUE(drop({box_ / "broken.yaml"}));
  ASSERT_TRUE(wait_for([&] { return message().contains("broken.yaml"); }));
  EXPECT_EQ(page(), "home");

  // A copy of the shipped course under an id of its own.
  std::string course = test::text_of(default_curriculum());
  const std::string id = "id: " + curricula::load_curriculum(default_curriculum()).id;
  ASSERT_NE(course.find(id), std::string::npos);
  test::write_text(box_ / "same.yaml", course);
  ASSERT_TRUE(drop({box_ / "same.yaml"}));
  ASSERT_TRUE(wait_for([&] { return message().contains("give it another id"); }));
  course.replace(course.find(id), id.size(), "id: ours");
  test::write_text(box_ / "ours.yaml", course);
  ASSERT_TRUE(drop({box_ / "ours.yaml"}));
  ASSERT_TRUE(wait_for([&] { return page() == "start"; }));
  EXPECT_EQ(window_->start_page().choice().curriculum, box_ / "ours.yaml");

  // Where there is no place for it on the page, it is a box.
  key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_EQ(page(), "records");
  ASSERT_TRUE(drop({box_ / "photo.jpeg"}));
  QMessageBox* box = nullptr;
  ASSERT_TRUE(wait_for([&] { return (box = window_->findChild<QMessageBox*>()) != nullptr; }));
  EXPECT_TRUE(box->text().contains("photo.jpeg"));
  box->accept();
  EXPECT_EQ(page(), "records");
}

TEST_F(WindowShell, OneDialogOpensFilesAndFolders) {
  const fs::path patient = test::write_block_patient(box_.folder());
  const fs::path ct = box_ / "scans" / "ct";
  fs::create_directories(ct);
  test::write_text(ct / "I1", "no DICOM");
  open();
  QPointer<OpenDialog> dialog;
  const auto ask = [&] {
    key(Qt::Key_O, Qt::ControlModifier);
    for (auto* one : window_->findChildren<OpenDialog*>())
      if (one->isVisible()) dialog = one;
    return !dialog.isNull() && dialog->isVisible();
  };
  const auto type_and_open = [&](const fs::path& path) {
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(QString::fromStdString(path.string()));
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)->click();
  };
  const auto gone = [&] { return dialog.isNull() || !dialog->isVisible(); };
  ASSERT_TRUE(ask());
  keep_picture(*dialog, "open-dialog.png");
  // A patient is a folder: Open takes it as a whole.
  dialog->setDirectory(QString::fromStdString(patient.parent_path().string()));
  type_and_open(patient);
  ASSERT_TRUE(wait_for(gone, 5000));
  ASSERT_TRUE(wait_for([&] { return window_->start_page().choice().patient == patient; }));

  // It begins where something was found, and any other folder has a button: here a CT's.
  ASSERT_TRUE(ask());
  EXPECT_EQ(dialog->directory().absolutePath().toStdString(), patient.parent_path().string());
  dialog->setDirectory(QString::fromStdString(ct.string()));
  auto* whole = dialog->findChild<QPushButton*>("whole_folder");
  ASSERT_TRUE(whole->isVisible());
  whole->click();
  ASSERT_TRUE(wait_for([&] { return page() == "import"; }));
  EXPECT_EQ(window_->import_wizard().source_page().findChild<QLineEdit*>()->text().toStdString(), ct.string());
  ASSERT_TRUE(wait_for([&] { return !window_->import_wizard().work().busy(); }));
  key(Qt::Key_1, Qt::ControlModifier);

  // A file, as ever.
  std::string course = test::text_of(default_curriculum());
  const std::string id = "id: " + curricula::load_curriculum(default_curriculum()).id;
  course.replace(course.find(id), id.size(), "id: ours");
  test::write_text(box_ / "ours.yaml", course);
  ASSERT_TRUE(ask());
  type_and_open(box_ / "ours.yaml");
  ASSERT_TRUE(wait_for([&] { return page() == "start"; }));
  EXPECT_EQ(window_->start_page().choice().curriculum, box_ / "ours.yaml");
}

TEST_F(WindowShell, TextSizeAndGroundChangeByKeysAndAreKept) {
  open();
  const double before = QApplication::font().pointSizeF();
  key(Qt::Key_Plus, Qt::ControlModifier);
  EXPECT_NEAR(QApplication::font().pointSizeF(), 1.1 * before, 0.05);
  EXPECT_NEAR(look_settings().text_scale, 1.1, 1e-9);
  for (int i = 0; i < 12; ++i) key(Qt::Key_Plus, Qt::ControlModifier);
  EXPECT_NEAR(look_settings().text_scale, theme::kMostTextScale, 1e-9);
  for (int i = 0; i < 5; ++i) QApplication::processEvents(QEventLoop::AllEvents, 20);
  keep_picture(*window_, "home-large-text.png");
  key(Qt::Key_0, Qt::ControlModifier);
  EXPECT_NEAR(QApplication::font().pointSizeF(), before, 0.05);
  const int dark = window_->grab().toImage().pixelColor(8, window_->height() - 8).lightness();
  action("ground_light")->trigger();
  EXPECT_GT(window_->grab().toImage().pixelColor(8, window_->height() - 8).lightness(), dark + 120);
  EXPECT_EQ(look_settings().ground, "light");
  keep_picture(*window_, "home-light.png");
}

TEST_F(WindowShell, SettingsAreSeenAtOnceAndTakenBackByCancel) {
  open();
  const auto settings = [&]() -> SettingsDialog* {
    key(Qt::Key_Comma, Qt::ControlModifier);
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<SettingsDialog*>(widget); dialog != nullptr && dialog->isVisible()) return dialog;
    return nullptr;
  };
  QPointer<SettingsDialog> dialog = settings();
  ASSERT_NE(dialog, nullptr);
  auto* ground = dialog->findChild<QComboBox*>("ground");
  ground->setCurrentIndex(ground->findData("light"));
  dialog->findChild<QSlider*>("text_scale")->setValue(140);
  EXPECT_EQ(theme::look().ground, theme::Ground::light) << "seen at once";
  ASSERT_TRUE(wait_for([] { return std::abs(theme::look().text_scale - 1.4) < 1e-9; }, 5000));
  wait_for([] { return false; }, 300);
  EXPECT_EQ(cut_texts(*dialog), std::vector<std::string>()) << lines(cut_texts(*dialog));
  // By its last pixels: an underlined letter parts two that stood close, and what a label asks for is too little then.
  for (QLabel* label : dialog->findChildren<QLabel*>()) {
    const QImage words = label->grab().toImage();
    for (int y = 0; y < words.height(); ++y)
      EXPECT_LT(std::abs(qGray(words.pixel(words.width() - 1, y)) - qGray(words.pixel(words.width() - 1, 0))), 60)
          << label->text().toStdString() << ": a stroke ends there, not its soft edge";
  }
  keep_picture(*dialog, "settings-light-large.png");
  QTest::keyClick(dialog, Qt::Key_Escape);
  ASSERT_TRUE(wait_for([&] { return dialog.isNull() || !dialog->isVisible(); }, 5000));
  EXPECT_EQ(theme::look().ground, theme::Ground::dark);
  EXPECT_EQ(theme::look().text_scale, 1.0);
  EXPECT_EQ(look_settings().ground, "dark");

  dialog = settings();
  ASSERT_NE(dialog, nullptr);
  keep_picture(*dialog, "settings.png");
  auto* trachea = dialog->findChild<QComboBox*>("trachea");
  trachea->setCurrentIndex(trachea->findData("blue"));
  auto* quality = dialog->findChild<QComboBox*>("quality");
  quality->setCurrentIndex(quality->findData("low"));
  dialog->findChild<QSlider*>("volume")->setValue(80);
  dialog->accept();
  EXPECT_EQ(user_settings()->value("look/trachea").toString(), "blue");
  EXPECT_EQ(GlView::governor().mode(), QualityGovernor::Mode::low) << "used, not only kept";
  EXPECT_EQ(user_settings()->value("sound/volume").toDouble(), 0.8);
  EXPECT_TRUE(user_settings()->value("sound/monitor").toBool());
}

}  // namespace
}  // namespace vallecula::gui::window_test
