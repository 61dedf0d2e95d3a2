// A window with a course, people in its records, and the instructor's second window beside it.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "gui/instructor/instructor_window.h"
#include "gui/instructor/station.h"
#include "gui/views/theme.h"
#include "tests/gui/accessible.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/busy_course.h"
#include "tests/gui/records_pages/window_records.h"

namespace vallecula::gui::window_test {

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

}  // namespace vallecula::gui::window_test
