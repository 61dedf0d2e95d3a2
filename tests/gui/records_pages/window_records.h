// The records' pages in a window, used with mouse and keys on a real database.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QTabWidget>
#include <cstdlib>

#include "curricula/records/people.h"
#include "gui/pages/main_window.h"
#include "gui/records_pages/account_tab.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/trial_record.h"
#include "gui/session/user_paths.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {

using curricula::People;
using curricula::RecordRow;
using curricula::Records;

inline void click_at(QWidget* widget, const QPointF& at) {
  for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
    QMouseEvent event(type, at, widget->mapToGlobal(at.toPoint()), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(widget, &event);
  }
}

inline void press(QWidget* widget, int key, const QString& text = {}) {
  for (const auto type : {QEvent::KeyPress, QEvent::KeyRelease}) {
    QKeyEvent event(type, key, Qt::NoModifier, text);
    QApplication::sendEvent(widget, &event);
  }
}

inline void type(QWidget* widget, const QString& text) {
  for (const QChar c : text) press(widget, 0, c);
}

class WindowRecords : public Screen {
 protected:
  WindowRecords() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~WindowRecords() override { unsetenv("VALLECULA_HOME"); }

  void open() {
    window_ = std::make_unique<MainWindow>();
    window_->show_start({curricula::load_curriculum(default_curriculum())});
    window_->show();
    QApplication::processEvents();
  }
  RecordsPage& page() { return window_->records_page(); }
  RecordsDesk& desk() { return page().desk(); }
  template <class Widget>
  static Widget* seen(QWidget* within, const QString& text) {
    for (Widget* one : within->findChildren<Widget*>())
      if (one->isVisible() && one->text().remove('&').startsWith(text)) return one;
    ADD_FAILURE() << "nothing is seen that says " << text.toStdString();
    return nullptr;
  }
  static void click(QWidget* within, const QString& text) {
    QWidget* button = seen<QPushButton>(within, text);
    if (button != nullptr) click_at(button, button->rect().center());
  }
  QString text_of(const char* label) { return window_->findChild<QLabel*>(label)->text(); }
  void show_tab(const QString& title) {
    auto* tabs = page().findChild<QTabWidget*>();
    for (int i = 0; i < tabs->count(); ++i)
      if (tabs->tabText(i) == title) {
        click_at(tabs->tabBar(), tabs->tabBar()->tabRect(i).center());
        EXPECT_EQ(tabs->currentIndex(), i);
        return;
      }
    ADD_FAILURE() << "no tab " << title.toStdString();
  }
  void settle() {
    ASSERT_TRUE(wait_for([&] { return !seen_waiting(); }, 20000));
  }
  bool seen_waiting() {
    for (QLabel* label : page().findChildren<QLabel*>())
      if (label->text() == "Asking the records ..." && label->isVisible()) return true;
    return false;
  }
  /// Fills the dialog that is open, field for field, and takes it by Enter.
  static void fill(const QStringList& fields) {
    QWidget* dialog = nullptr;
    ASSERT_TRUE(wait_for([&] { return (dialog = QApplication::activeModalWidget()) != nullptr; }, 5000));
    const auto edits = dialog->findChildren<QLineEdit*>();
    ASSERT_EQ(edits.size(), fields.size());
    for (int i = 0; i < fields.size(); ++i) type(edits[i], fields[i]);
    press(edits.last(), Qt::Key_Return);
  }
  void sign_in(const QString& name, const QString& pin) {
    auto* names = page().findChild<AccountTab*>()->findChild<QComboBox*>();
    ASSERT_TRUE(wait_for([&] { return names->findText(name) >= 0; }, 10000));
    names->setCurrentIndex(names->findText(name));
    auto* field = page().findChild<AccountTab*>()->findChild<QLineEdit*>();
    type(field, pin);
    press(field, Qt::Key_Return);
  }
  static RecordRow row(long long trainee, int day, bool passed, const std::string& kind = "mouse",
                       bool complete = true) {
    RecordRow one;
    const std::string two = (day < 10 ? "0" : "") + std::to_string(day);
    one.started_utc = "2026-05-" + two + "T09:58:00Z";
    one.finished_utc = "2026-05-" + two + "T10:00:00Z";
    one.curriculum_id = "first-steps";
    one.scenario_id = "term";
    one.device_kind = kind;
    one.trainee_id = trainee;
    one.trial_path = "/nowhere/trial.vtrial";
    one.duration_s = 31.4;
    one.score.passed = passed;
    one.score.complete = complete;
    one.score.attempt_begun = true;
    one.score.attempt_time_s = 40.0 - day;
    one.score.peak_tongue_force_n = passed ? 4.5 + 0.1 * (day % 3) : 8.0 - 0.2 * day;
    one.score.glottis_visible_max_percent = 60.0;
    return one;
  }

  test::Sandbox box_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace vallecula::gui::window_test
