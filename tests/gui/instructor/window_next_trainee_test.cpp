// The next trainee at the same machine, who may watch and help whom, and the check of a device before its first trial.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "gui/authoring/authoring_page.h"
#include "gui/instructor/instructor_controls.h"
#include "gui/instructor/sign_in_dialog.h"
#include "gui/instructor/station.h"
#include "gui/pages/trial_page.h"
#include "gui/records_pages/person_dialog.h"
#include "tests/gui/instructor/window_instructor.h"

namespace vallecula::gui::window_test {
namespace {

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
  const auto no_dialog = [] { return wait_for([] { return QApplication::activeModalWidget() == nullptr; }, 10000); };
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

TEST_F(WindowInstructor, OpenedWithNobodySignedInOneSignsInRightThere) {
  open_with_course();
  open_second();
  ASSERT_TRUE(wait_for([&] { return second_is_open(); }, 10000)) << "nobody is registered: nobody is asked for";
  auto* sign_in = second().findChild<QPushButton*>("sign_in_here");
  ASSERT_NE(sign_in, nullptr);
  EXPECT_TRUE(sign_in->isVisible());
  const auto asked = [&] {
    SignInDialog* found = nullptr;
    EXPECT_TRUE(wait_for(
        [&] {
          for (auto* one : second().findChildren<SignInDialog*>())
            if (one->isVisible()) found = one;
          return found != nullptr;
        },
        10000));
    return found;
  };
  // There is no instructor yet: it is said how there comes to be one.
  QTest::mouseClick(sign_in, Qt::LeftButton);
  auto* nobody = asked();
  ASSERT_NE(nobody, nullptr);
  auto* message = nobody->findChild<QLabel*>("dialog_message");
  ASSERT_TRUE(wait_for([&] { return message->text().contains("No instructor is registered"); }, 10000))
      << message->text().toStdString();
  EXPECT_TRUE(message->text().contains("Records"));
  QApplication::processEvents();
  EXPECT_GE(message->height(), message->heightForWidth(message->width())) << "all of it";
  keep_picture(*nobody, "instructor-sign-in-nobody.png");
  nobody->reject();
  register_people();
  QTest::mouseClick(sign_in, Qt::LeftButton);
  auto* asks = asked();
  ASSERT_NE(asks, nullptr);
  ASSERT_TRUE(wait_for([&] { return asks->findChild<QComboBox*>()->count() == 1; }, 10000)) << "instructors only";
  auto* pin = asks->findChild<QLineEdit*>();
  QTest::keyClicks(pin, "4321");
  QTest::keyClick(pin, Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return second().desk().instructor(); }, 10000));
  EXPECT_FALSE(desk().who()) << "at the blade nobody is";
  EXPECT_FALSE(sign_in->isVisible()) << "somebody is signed in";
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
