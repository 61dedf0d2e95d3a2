// The import wizard opened on a small manikin's CT, for tests that use it as a clinician does. With
// VALLECULA_PICTURES=DIR every step is kept there as a picture.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QTabBar>
#include <cstdlib>
#include <memory>
#include <set>

#include "gui/import/check_page.h"
#include "gui/import/import_wizard.h"
#include "gui/import/source_page.h"
#include "gui/pages/main_window.h"
#include "gui/session/user_paths.h"
#include "gui/views/label_view.h"
#include "pipeline/manikin/manikin.h"
#include "tests/gui/program.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {

namespace fs = std::filesystem;
using pipeline::Point;

constexpr double kWeight = 0.8;  // small, so that it is quickly read
constexpr std::uint64_t kSeed = 3;

class WindowImport : public Screen {
 protected:
  static void SetUpTestSuite() {
    Screen::SetUpTestSuite();
    series_box_ = std::make_unique<test::Sandbox>();
    pipeline::ManikinOptions options;
    options.weight_kg = kWeight;
    options.seed = kSeed;
    pipeline::write_manikin(options, *series_box_ / "ct");
  }
  static void TearDownTestSuite() {
    series_box_.reset();
    Screen::TearDownTestSuite();
  }
  WindowImport() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~WindowImport() override { unsetenv("VALLECULA_HOME"); }

  static QString series() { return QString::fromStdString((*series_box_ / "ct").string()); }
  void open_window() {
    window_ = std::make_unique<MainWindow>();
    window_->show_start({curricula::load_curriculum(default_curriculum())});
    window_->show();
    open_course_page(*window_);
    QPushButton* from_ct = button(window_->start_page(), "New patient from a CT ...");
    from_ct->click();
    ASSERT_EQ(window_->page_name(), "import");
    QObject::connect(&wizard().work(), &ImportWork::progressed, window_.get(),
                     [this](const QString& stage, double share, double) {
                       if (stages_.empty() || stages_.back() != stage) stages_.push_back(stage);
                       share_ = share;
                     });
  }
  void open(const QString& source) {
    open_window();
    ASSERT_FALSE(HasFatalFailure());
    auto* place = wizard().source_page().findChild<QLineEdit*>();
    place->setText(source);
    emit place->returnPressed();
    ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }));
  }
  /// Up to where a person looks at the result.
  void segment(const QString& source) {
    open(source);
    picture("1-source");
    button(wizard().source_page(), "&Read and find the structures")->click();
    ASSERT_EQ(wizard().step(), "segment");
    ASSERT_TRUE(wait_for([&] { return wizard().step() != "segment"; }, 180000));
    ASSERT_EQ(wizard().step(), "check");
    ASSERT_TRUE(wait_for([&] { return check().view_3d().up_to_date(); }));
  }
  ImportWizard& wizard() { return window_->import_wizard(); }
  CheckPage& check() { return wizard().check_page(); }
  static QPushButton* button(QWidget& in, const QString& text) {
    for (QPushButton* candidate : in.findChildren<QPushButton*>())
      if (candidate->text() == text) return candidate;
    throw std::runtime_error("no button " + text.toStdString());
  }
  static void mouse(QWidget& on, QEvent::Type type, QPointF at, Qt::MouseButtons buttons) {
    QMouseEvent event(type, at, on.mapToGlobal(at.toPoint()), Qt::LeftButton, buttons, Qt::NoModifier);
    QApplication::sendEvent(&on, &event);
  }
  static void drag(QWidget& on, QPointF from, QPointF to) {
    mouse(on, QEvent::MouseButtonPress, from, Qt::LeftButton);
    mouse(on, QEvent::MouseMove, to, Qt::LeftButton);
    mouse(on, QEvent::MouseButtonRelease, to, Qt::NoButton);
  }
  void picture(const std::string& name) {
    if (std::getenv("VALLECULA_PICTURES") == nullptr) return;
    for (int i = 0; i < 10; ++i) QApplication::processEvents(QEventLoop::AllEvents, 20);
    check().view_3d().draw();
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    keep_picture(*window_, std::string(test->name()) + "-" + name + ".png");
  }
  /// No two things that can be seen at once answer to the same Alt key.
  void expect_each_its_own_key(QWidget& page) {
    std::map<QString, QString> taken;
    const auto take = [&](const QString& text) {
      const QString key = QKeySequence::mnemonic(text).toString();
      if (key.isEmpty()) return;
      EXPECT_EQ(taken.count(key), 0u) << key.toStdString() << ": " << text.toStdString() << " and "
                                      << taken[key].toStdString();
      taken[key] = text;
    };
    for (auto* button : page.findChildren<QAbstractButton*>())
      if (button->isVisible()) take(button->text());
    for (auto* label : page.findChildren<QLabel*>())
      if (label->isVisible() && label->buddy() != nullptr) take(label->text());
    for (auto* tabs : page.findChildren<QTabBar*>())
      for (int i = 0; i < tabs->count(); ++i) take(tabs->tabText(i));
    EXPECT_GT(taken.size(), 2u);
  }
  /// Everything under the user's folder, and half-done work in the temporary one.
  std::vector<std::string> left_behind() const {
    std::vector<std::string> names;
    // The window opens the records when it starts and keeps its size when it closes, whether anything is imported or not.
    const std::set<fs::path> of_the_records{"settings.ini", "records.sqlite", "records.sqlite-wal", "records.sqlite-shm", "station-id"};
    for (const auto& entry : fs::recursive_directory_iterator(box_.home()))
      if (!entry.is_directory() && of_the_records.count(fs::relative(entry.path(), box_.home())) == 0)
        names.push_back(entry.path().string());
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path())) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("vallecula-labels-" + std::to_string(::getpid()), 0) == 0) names.push_back(name);
    }
    return names;
  }

  static inline std::unique_ptr<test::Sandbox> series_box_;
  test::Sandbox box_;
  std::unique_ptr<MainWindow> window_;
  std::vector<QString> stages_;
  double share_ = 0.0;
};

}  // namespace vallecula::gui::window_test
