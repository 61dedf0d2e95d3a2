// The records as a person uses them: with mouse and keys, on a real database.
#include "tests/gui/records_pages/window_records.h"

#include <QCalendarWidget>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTextCharFormat>
#include <QTimer>
#include <fstream>

#include "curricula/records/migrations.h"
#include "curricula/records/ratings.h"
#include "curricula/score/figures.h"
#include "gui/records_pages/cohort_tab.h"
#include "gui/records_pages/people_tab.h"
#include "gui/records_pages/progress_tab.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

TEST_F(WindowRecords, FromTheFirstInstructorToATraineesOwnProgress) {
  open();
  EXPECT_EQ(desk().person().id, 0);
  EXPECT_TRUE(text_of("who_is_signed_in").contains("belong to nobody"));
  keep_picture(*window_, "records-0-start.png");
  click(window_.get(), "Records ...");
  ASSERT_EQ(window_->page_name(), "records");
  settle();
  EXPECT_TRUE(text_of("sign_in_message").contains("register as a trainee")) << text_of("sign_in_message").toStdString();
  EXPECT_FALSE(page().findChild<PeopleTab*>()->isVisible()) << "an instructor's";
  keep_picture(*window_, "records-1-sign-in.png");
  click(&page(), "Set up the first instructor");
  fill({"Boss", "4321", "4322"});
  QWidget* dialog = QApplication::activeModalWidget();
  ASSERT_NE(dialog, nullptr) << "two PINs that differ are not taken";
  EXPECT_NE(seen<QLabel>(dialog, "The two PINs"), nullptr);
  keep_picture(*dialog, "records-2-dialog.png");
  for (QLineEdit* edit : dialog->findChildren<QLineEdit*>()) edit->clear();
  fill({"Boss", "4321", "4321"});
  ASSERT_TRUE(wait_for([&] { return desk().instructor(); }, 20000));
  EXPECT_EQ(page().findChild<QTabWidget*>()->count(), 4);
  settle();
  show_tab("My account");
  keep_picture(*window_, "records-3-account.png");
  click(&page(), "Sign out");
  EXPECT_EQ(page().findChild<ProgressTab*>()->findChild<QListWidget*>()->count(), 0) << "nor of the person's";
  EXPECT_EQ(page().findChild<QTabWidget*>()->count(), 2) << "nothing of an instructor's is left";
  settle();
  show_tab("Sign in");
  settle();
  for (QPushButton* button : page().findChildren<QPushButton*>())
    EXPECT_FALSE(button->isVisible() && button->text().contains("first &instructor")) << "there is one";
  click(&page(), "Register as a trainee");
  fill({"Kiwi", "1234", "1234"});
  ASSERT_TRUE(wait_for([&] { return desk().who().has_value(); }, 20000));
  EXPECT_FALSE(desk().instructor());
  settle();

  const long long kiwi = desk().person().id;
  const fs::path log = box_ / "done" / "trial.vtrial";
  {
    Records records(records_location());
    for (int day = 1; day <= 12; ++day) records.add(row(kiwi, day, day != 1 && day != 3));
    records.add(row(kiwi, 13, false, "mouse", false));
    records.add(row(kiwi, 14, true, "touch"));
    fs::create_directories(log.parent_path());
    std::ofstream(log) << "a log";
    RecordRow last = row(kiwi, 15, true);
    last.trial_path = log.string();
    last.mode = curricula::Mode::assessment;
    curricula::Ratings(records).add(People(records).sign_in(kiwi, "1234"), records.add(last),
                                    {"self", curricula::kGlobalRating, 4.0});
  }
  show_tab("My account");
  show_tab("Progress");
  auto* progress = page().findChild<ProgressTab*>();
  auto* curves = progress->findChild<QListWidget*>();
  auto* trials = progress->findChild<QTableWidget*>();
  ASSERT_TRUE(wait_for([&] { return trials->rowCount() == 14; }, 20000));
  EXPECT_EQ(curves->count(), 2) << "kinds of device are not pooled";
  EXPECT_TRUE(curves->item(0)->text().contains("mouse · 11 of 13 passed · 1 cut off"))
      << curves->item(0)->text().toStdString();
  EXPECT_TRUE(text_of("mastery").contains("Three in a row: after 6 trials"));
  EXPECT_TRUE(text_of("mastery").contains("Interrupted: 1")) << text_of("mastery").toStdString();
  EXPECT_EQ(trials->item(1, 3)->text(), "interrupted");
  const auto format = progress->findChild<QCalendarWidget*>()->dateTextFormat(QDate(2026, 5, 3));
  EXPECT_EQ(format.toolTip(), "1 trial, 0 passed");
  keep_picture(*window_, "records-4-progress.png");

  // The figure by keys, the trial by the mouse on its point and by Enter.
  auto* figure = progress->findChildren<QComboBox*>().last();
  for (QComboBox* box : progress->findChildren<QComboBox*>())
    if (box->accessibleName().startsWith("Figure")) figure = box;
  const int before = figure->currentIndex();
  press(figure, Qt::Key_Down);
  EXPECT_EQ(figure->currentIndex(), before + 1);
  for (int i = 0; i < figure->count(); ++i)
    EXPECT_FALSE(curricula::find_figure(figure->itemData(i).toString().toStdString())->for_researchers);
  QString wanted;
  QObject::disconnect(&page(), &RecordsPage::trial_wanted, window_.get(), nullptr);
  bool with_replay = true;
  QObject::connect(&page(), &RecordsPage::trial_wanted, [&](const QString& path, bool replay) {
    wanted = path;
    with_replay = replay;
  });
  auto* chart = progress->findChildren<TrialChart*>().first();
  click_at(chart, chart->position(0));
  EXPECT_EQ(trials->currentRow(), 13);
  press(trials, Qt::Key_Return);
  EXPECT_EQ(wanted, "") << "its files are nowhere";
  EXPECT_NE(seen<QLabel>(progress, "This trial's files are not on this computer"), nullptr);
  click_at(chart, chart->position(13));
  EXPECT_EQ(trials->currentRow(), 0);
  press(trials, Qt::Key_Return);
  EXPECT_EQ(wanted.toStdString(), log.string());
  EXPECT_FALSE(with_replay) << "an assessment's replay stays locked for the trainee";
  keep_picture(*window_, "records-5-another-figure.png");

  click(&page(), "Back");
  EXPECT_EQ(window_->page_name(), "home");
  EXPECT_TRUE(text_of("who_is_signed_in").contains("Kiwi (trainee)"));
  keep_picture(*window_, "records-6-start-signed-in.png");
}

TEST_F(WindowRecords, BackFromATrialOnesTabAndRowAreAsTheyWereLeft) {
  const fs::path log = box_ / "done" / "trial.vtrial";
  fs::create_directories(log.parent_path());
  std::ofstream(log) << "no log";
  {
    Records records(records_location());
    for (int day = 1; day <= 6; ++day) {
      RecordRow one = row(0, day, true);
      one.trial_path = log.string();
      records.add(one);
    }
  }
  open();
  click(window_.get(), "Records ...");
  settle();
  show_tab("Progress");
  auto* tabs = page().findChild<QTabWidget*>();
  auto* trials = page().findChild<ProgressTab*>()->findChild<QTableWidget*>();
  ASSERT_TRUE(wait_for([&] { return trials->rowCount() == 6; }, 20000));
  trials->setFocus();
  trials->setCurrentCell(3, 0);
  bool failed = false;
  QObject::connect(window_.get(), &MainWindow::replay_failed, [&] { failed = true; });
  press(trials, Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return failed && window_->page_name() == "records"; }, 20000)) << "its log is none";
  settle();
  EXPECT_EQ(tabs->tabText(tabs->currentIndex()), "Progress");
  EXPECT_EQ(trials->currentRow(), 3);
  EXPECT_TRUE(text_of("records_trouble").contains("trial")) << text_of("records_trouble").toStdString();
  // Whoever comes anew and is not signed in is asked to, as before.
  click(&page(), "Back");
  click(window_.get(), "Records ...");
  EXPECT_EQ(tabs->tabText(tabs->currentIndex()), "Sign in");
}

TEST_F(WindowRecords, WrongPinsMakeOneWaitAndTheWaitIsCountedDown) {
  {
    Records records(records_location());
    People(records).register_trainee("Kiwi", "1234");
    People(records).register_trainee("Emu", "1234");
  }
  open();
  click(window_.get(), "Records ...");
  auto* field = page().findChild<AccountTab*>()->findChild<QLineEdit*>();
  for (int i = 0; i < 3; ++i) {
    sign_in("Kiwi (trainee)", "0000");
    settle();
  }
  ASSERT_TRUE(wait_for([&] { return text_of("sign_in_message").contains("wait 5 s"); }, 5000))
      << text_of("sign_in_message").toStdString();
  EXPECT_FALSE(field->isEnabled());
  keep_picture(*window_, "records-7-wait.png");
  ASSERT_TRUE(wait_for([&] { return text_of("sign_in_message").contains("wait 4 s"); }, 3000));
  // Another is not made to wait for it.
  auto* names = page().findChild<AccountTab*>()->findChild<QComboBox*>();
  names->setCurrentIndex(names->findText("Emu (trainee)"));
  EXPECT_TRUE(field->isEnabled());
  sign_in("Emu (trainee)", "1234");
  ASSERT_TRUE(wait_for([&] { return desk().who().has_value(); }, 10000));
  EXPECT_EQ(desk().person().name, "Emu");
}

TEST_F(WindowRecords, AnInstructorFiltersTheCohortOpensACurveAndLooksAfterPeople) {
  {
    Records records(records_location());
    People people(records);
    people.create_first_instructor("Boss", "4321");
    const long long kiwi = people.register_trainee("Kiwi", "1234"), emu = people.register_trainee("Emu", "1234");
    for (int day = 1; day <= 9; ++day) records.add(row(kiwi, day, true));
    for (int day = 1; day <= 4; ++day) records.add(row(emu, day, false));
    records.add(row(emu, 5, true, "touch"));
    records.add(row(0, 6, true));
  }
  open();
  click(window_.get(), "Records ...");
  sign_in("Boss (instructor)", "4321");
  ASSERT_TRUE(wait_for([&] { return desk().instructor(); }, 20000));
  auto* cohort = page().findChild<CohortTab*>();
  auto* table = cohort->findChild<QTableView*>();
  ASSERT_TRUE(wait_for([&] { return table->model()->rowCount() == 3; }, 20000)) << "nobody's trials are no trainee's";
  EXPECT_TRUE(cohort->isVisible());
  keep_picture(*window_, "records-8-cohort.png");
  const auto cell = [&](int r, int c) { return table->model()->index(r, c).data().toString(); };
  EXPECT_EQ(cell(0, CohortModel::kTrainee), "Emu");
  type(cohort->findChild<QLineEdit*>(), "kiw");
  ASSERT_EQ(table->model()->rowCount(), 1);
  EXPECT_EQ(cell(0, CohortModel::kCusum), "competent (trial 8)");
  table->setCurrentIndex(table->model()->index(0, 0));
  press(table, Qt::Key_Return);
  auto* progress = page().findChild<ProgressTab*>();
  auto* trials = progress->findChild<QTableWidget*>();
  ASSERT_TRUE(wait_for([&] { return progress->isVisible() && trials->rowCount() == 9; }, 20000));
  EXPECT_EQ(progress->findChildren<QComboBox*>().first()->isVisible(), true);
  keep_picture(*window_, "records-9-drill-down.png");

  show_tab("People");
  auto* people = page().findChild<PeopleTab*>();
  auto* list = people->findChildren<QTableWidget*>().first();
  ASSERT_TRUE(wait_for([&] { return list->rowCount() == 3; }, 20000));
  const auto choose = [&](const QString& name) {
    for (int r = 0; r < list->rowCount(); ++r)
      if (list->item(r, 0)->text() == name) click_at(list->viewport(), list->visualItemRect(list->item(r, 0)).center());
  };
  click(people, "Add ...");
  fill({"Heron", "9999", "9999"});
  ASSERT_TRUE(wait_for([&] { return list->rowCount() == 4; }, 20000));
  choose("Heron");
  click(people, "Rename ...");
  QWidget* dialog = nullptr;
  ASSERT_TRUE(wait_for([&] { return (dialog = QApplication::activeModalWidget()) != nullptr; }, 5000));
  auto* name = dialog->findChild<QLineEdit*>();
  EXPECT_EQ(name->text(), "Heron");
  name->clear();
  type(name, "Kiwi");
  press(name, Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return dialog->findChild<QLabel*>("dialog_message")->text().contains("taken"); }, 10000))
      << "refused in the dialog, to be tried again";
  name->clear();
  type(name, "Stork");
  press(name, Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return list->item(list->rowCount() - 1, 0)->text() == "Stork"; }, 10000));
  choose("Stork");
  click(people, "New PIN ...");
  fill({"7777", "7777"});
  ASSERT_TRUE(wait_for([&] { return text_of("people_message").contains("new PIN"); }, 10000));
  choose("Emu");
  people->export_chosen(QString::fromStdString(box_.folder().string()));
  ASSERT_TRUE(wait_for([&] { return text_of("people_message").contains("vallecula-export-"); }, 10000));
  settle();
  choose("Emu");
  click(people, "Delete ...");
  QWidget* warning = nullptr;
  ASSERT_TRUE(wait_for([&] { return (warning = QApplication::activeModalWidget()) != nullptr; }, 5000));
  EXPECT_TRUE(static_cast<QMessageBox*>(warning)->text().contains("Nobody can bring it back"));
  keep_picture(*warning, "records-10-warning.png");
  click_at(warning->findChild<QPushButton*>("delete_for_good"), {5, 5});
  ASSERT_TRUE(wait_for([&] { return list->rowCount() == 3; }, 10000));
  EXPECT_TRUE(text_of("people_message").contains("5 trials")) << text_of("people_message").toStdString();
  auto* audit = people->findChildren<QTableWidget*>().last();
  EXPECT_EQ(audit->item(0, 2)->text(), "person deleted");
  EXPECT_TRUE(audit->item(0, 3)->text().contains("deleted")) << "a number: the name is gone";
  keep_picture(*window_, "records-11-people.png");
}

TEST_F(WindowRecords, ATraineeChangesThePinTakesTheDataAlongAndIsDeleted) {
  {
    Records records(records_location());
    const long long kiwi = People(records).register_trainee("Kiwi", "1234");
    records.add(row(kiwi, 1, true));
  }
  open();
  click(window_.get(), "Records ...");
  sign_in("Kiwi (trainee)", "1234");
  ASSERT_TRUE(wait_for([&] { return desk().who().has_value(); }, 20000));
  show_tab("My account");
  click(&page(), "Change PIN");
  fill({"0000", "5678", "5678"});
  QWidget* dialog = QApplication::activeModalWidget();
  ASSERT_TRUE(wait_for([&] { return dialog->findChild<QLabel*>("dialog_message")->text().contains("wrong"); }, 10000))
      << dialog->findChild<QLabel*>("dialog_message")->text().toStdString();
  for (QLineEdit* edit : dialog->findChildren<QLineEdit*>()) edit->clear();
  fill({"1234", "5678", "5678"});
  ASSERT_TRUE(wait_for([&] { return text_of("account_message").contains("changed"); }, 10000));
  page().findChild<AccountTab*>()->export_own(QString::fromStdString(box_.folder().string()));
  ASSERT_TRUE(wait_for([&] { return text_of("account_message").contains("vallecula-export-"); }, 10000));
  int exports = 0;
  for (const auto& entry : fs::directory_iterator(box_.folder())) {
    if (entry.path().filename().string().rfind("vallecula-export-", 0) != 0) continue;
    ++exports;
    EXPECT_TRUE(fs::exists(entry.path() / "records.json"));
  }
  EXPECT_EQ(exports, 1);
  click(&page(), "Delete me");
  QWidget* warning = nullptr;
  ASSERT_TRUE(wait_for([&] { return (warning = QApplication::activeModalWidget()) != nullptr; }, 5000));
  press(warning, Qt::Key_Escape);
  QApplication::processEvents();
  EXPECT_TRUE(desk().who().has_value()) << "Escape keeps";
  click(&page(), "Delete me");
  ASSERT_TRUE(wait_for([&] { return (warning = QApplication::activeModalWidget()) != nullptr; }, 5000));
  click_at(warning->findChild<QPushButton*>("delete_for_good"), {5, 5});
  ASSERT_TRUE(wait_for([&] { return !desk().who().has_value(); }, 10000));
  Records records(records_location());
  EXPECT_TRUE(People(records).list().empty());
}

TEST_F(WindowRecords, AnswersComeInOrderToThoseWhoStillWaitForThem) {
  RecordsDesk desk;
  std::vector<int> answers;
  QObject stays;
  auto goes = std::make_unique<QObject>();
  const auto ask = [&](QObject* receiver, int number) {
    desk.ask<int>(
        receiver, [number](Records&) { return number; }, [&answers](int answer) { answers.push_back(answer); });
  };
  for (int number = 1; number <= 3; ++number) ask(number == 2 ? goes.get() : &stays, number);
  goes.reset();
  ask(&stays, 4);
  ASSERT_TRUE(wait_for([&] { return answers.size() == 3; }, 10000));
  EXPECT_EQ(answers, (std::vector<int>{1, 3, 4}));
}

/// Another program writes to the file and does not let go.
TEST_F(WindowRecords, ALockedDatabaseIsOneMessageNothingTypedIsLostAndTheWindowNeverWaits) {
  open();
  click(window_.get(), "Records ...");
  settle();
  click(&page(), "Register as a trainee");
  QWidget* dialog = QApplication::activeModalWidget();
  ASSERT_NE(dialog, nullptr);
  {
    QSqlDatabase db = QSqlDatabase::addDatabase("QSQLITE", "holder");
    db.setDatabaseName(QString::fromStdString(records_location().file.string()));
    ASSERT_TRUE(db.open());
    QSqlQuery(db).exec("BEGIN EXCLUSIVE");
    int longest_ms = 0;
    QElapsedTimer since;
    QTimer beat;
    QObject::connect(&beat, &QTimer::timeout,
                     [&] { longest_ms = std::max(longest_ms, static_cast<int>(since.restart())); });
    fill({"Kiwi", "1234", "1234"});
    since.start();
    beat.start(5);
    ASSERT_TRUE(wait_for(
        [&] { return dialog->findChild<QLabel*>("dialog_message")->text().contains("close that program"); }, 20000));
    beat.stop();
    EXPECT_LT(longest_ms, 1000) << "a window that waited would show the records' patience, 3 s";
    keep_picture(*dialog, "records-12-locked.png");
    QSqlQuery(db).exec("ROLLBACK");
    db.close();
  }
  QSqlDatabase::removeDatabase("holder");
  press(dialog->findChildren<QLineEdit*>().last(), Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return desk().who().has_value(); }, 20000));
  EXPECT_EQ(desk().person().name, "Kiwi");
}

TEST_F(WindowRecords, AServerThatIsAwayAndASchemaOfTheFutureAreOneMessageEachWithATryAgain) {
  const fs::path file = box_.home() / "records.sqlite";
  { Records records(file); }
  setenv("VALLECULA_RECORDS", "postgresql://anna:secret@127.0.0.1:1/lab", 1);
  open();
  click(window_.get(), "Records ...");
  EXPECT_TRUE(wait_for([&] { return text_of("records_trouble").contains("check that the server runs"); }, 20000));
  EXPECT_FALSE(text_of("records_trouble").contains("secret"));
  keep_picture(*window_, "records-13-away.png");
  settle();
  unsetenv("VALLECULA_RECORDS");
  const auto set_schema = [&](const QString& version) {
    {
      QSqlDatabase db = QSqlDatabase::addDatabase("QSQLITE", "beside");
      db.setDatabaseName(QString::fromStdString(file.string()));
      ASSERT_TRUE(db.open());
      QSqlQuery(db).exec("UPDATE schema_version SET version = " + version);
      db.close();
    }
    QSqlDatabase::removeDatabase("beside");
  };
  set_schema("99");
  click(&page(), "Try again");
  EXPECT_TRUE(wait_for([&] { return text_of("records_trouble").contains("schema 99"); }, 20000))
      << text_of("records_trouble").toStdString();
  settle();
  set_schema(QString::number(curricula::record_migrations().size()));
  click(&page(), "Try again");
  EXPECT_TRUE(wait_for([&] { return !window_->findChild<QLabel*>("records_trouble")->isVisible(); }, 20000));
  EXPECT_TRUE(text_of("sign_in_message").contains("Nobody is registered"));
}

}  // namespace
}  // namespace vallecula::gui::window_test
