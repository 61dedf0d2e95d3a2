// Ratings in the records' pages, and what is handed on from them.
#include <QCalendarWidget>
#include <QListWidget>
#include <QMenu>
#include <QRadioButton>
#include <QTableView>
#include <QTableWidget>
#include <QTextCharFormat>
#include <ctime>
#include <fstream>

#include "curricula/records/ratings.h"
#include "curricula/trial_log.h"
#include "gui/pages/self_rating_page.h"
#include "gui/records_pages/cohort_tab.h"
#include "gui/records_pages/hand_on.h"
#include "gui/records_pages/progress_tab.h"
#include "gui/records_pages/rating_dialog.h"
#include "gui/records_pages/tables.h"
#include "gui/records_pages/trial_log_here.h"
#include "gui/session/files.h"
#include "tests/curricula/export/small_lrs.h"
#include "tests/gui/records_pages/window_records.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;
using curricula::Rating;
using curricula::Ratings;

class WindowRating : public WindowRecords {
 protected:
  void SetUp() override {
    Records records(records_location());
    People people(records);
    people.create_first_instructor("Boss", "4321");
    kiwi_ = people.register_trainee("Kiwi", "1234");
    emu_ = people.register_trainee("Emu", "1234");
  }
  /// A whole log of a moment in which nothing was done, of the shipped course's first scenario.
  fs::path write_log() {
    const curricula::Curriculum course = curricula::load_curriculum(default_curriculum());
    curricula::LogHeader header;
    header.scenario_id = course.scenarios[0].id;
    header.scenario_yaml = course.scenarios[0].yaml;
    header.device_kind = "mouse";
    for (const char* gum : {"gum_upper_midline", "gum_lower_midline"}) header.landmarks_m[gum] = {0.0, -0.02, 0.0};
    const fs::path log = box_ / "done" / "trial.vtrial";
    fs::create_directories(log.parent_path());
    curricula::TrialLogWriter writer(log, header);
    for (int n = 0; n < 20; ++n) {
      curricula::LogTick tick;
      tick.tick = n;
      tick.time_s = 1e-3 * n;
      writer.append(tick);
    }
    curricula::LogFooter footer;
    footer.complete = true;
    writer.close(footer);
    return log;
  }
  void open_as(const QString& name, const QString& pin) {
    open();
    click(window_.get(), "Records ...");
    sign_in(name, pin);
    ASSERT_TRUE(wait_for([&] { return desk().who().has_value(); }, 20000));
    settle();
  }
  ProgressTab* progress() { return page().findChild<ProgressTab*>(); }
  QTableWidget* trials() { return progress()->findChild<QTableWidget*>(); }
  std::vector<Rating> ratings(long long trial) {
    Records records(records_location());
    People people(records);
    for (const auto& person : people.list())
      if (person.name == "Boss") return Ratings(records).of_trial(people.sign_in(person.id, "4321"), trial);
    return {};
  }
  template <class Dialog>
  static Dialog* dialog() {
    Dialog* found = nullptr;
    EXPECT_TRUE(wait_for(
        [&] {
          QWidget* top = QApplication::activeModalWidget();
          found = top == nullptr ? nullptr : qobject_cast<Dialog*>(top);
          if (found == nullptr && top != nullptr) found = top->findChild<Dialog*>();
          return found != nullptr;
        },
        10000));
    return found;
  }

  long long kiwi_ = 0, emu_ = 0;
};

TEST_F(WindowRating, AnInstructorRatesATrialAndItsTraineeReadsIt) {
  long long trial = 0;
  {
    Records records(records_location());
    records.add(row(kiwi_, 1, false));
    RecordRow last = row(kiwi_, 2, true);
    last.trial_path = write_log().string();
    last.log_sha256 = sha256_of_file(last.trial_path);
    trial = records.add(last);
  }
  open_as("Boss (instructor)", "4321");
  auto* table = page().findChild<CohortTab*>()->findChild<QTableView*>();
  ASSERT_TRUE(wait_for([&] { return table->model()->rowCount() == 1; }, 20000));
  table->setCurrentIndex(table->model()->index(0, 0));
  click(page().findChild<CohortTab*>(), "Open");
  ASSERT_TRUE(wait_for([&] { return progress()->isVisible() && trials()->rowCount() == 2; }, 20000));
  trials()->setCurrentCell(0, 0);
  ASSERT_TRUE(wait_for([&] { return text_of("ratings").startsWith("Nobody"); }, 10000));
  click(progress(), "Rate ...");
  auto* form = dialog<RatingDialog>();
  ASSERT_NE(form, nullptr);
  QApplication::processEvents();
  keep_picture(*form, "rating-1-dialog.png");
  click(form, "Keep the rating");
  EXPECT_NE(seen<QLabel>(form, "Nothing is judged yet"), nullptr);
  seen<QRadioButton>(form, "4  alone, with flaws")->click();
  QRadioButton* no = nullptr;
  for (auto* button : form->findChildren<QRadioButton*>())
    if (button->accessibleName() == "Handle in the left hand: No") no = button;
  ASSERT_NE(no, nullptr) << "the log leaves it to the instructor";
  no->click();
  click(form, "Keep the rating");
  ASSERT_TRUE(
      wait_for([&] { return text_of("ratings").contains("You as the instructor: 4 of 5, alone, with flaws"); }, 10000))
      << text_of("ratings").toStdString();
  EXPECT_TRUE(text_of("ratings").contains("Handle in left hand: no"));
  keep_picture(*window_, "rating-2-rated.png");
  window_->resize(1024, 700);
  QApplication::processEvents();
  EXPECT_EQ(window_->size(), QSize(1024, 700)) << "as small as any page";
  keep_picture(*window_, "rating-8-small.png");
  const auto kept = ratings(trial);
  ASSERT_EQ(kept.size(), 2u) << "what was not judged is not kept";
  EXPECT_EQ(kept[0].value, 4.0);

  // The other trial's log is nowhere: all in all only.
  trials()->setCurrentCell(1, 0);
  click(progress(), "Rate ...");
  form = dialog<RatingDialog>();
  ASSERT_NE(form, nullptr);
  EXPECT_NE(seen<QLabel>(form, "Without the checklist: This trial's files are not on this computer"), nullptr);
  EXPECT_EQ(form->findChildren<QRadioButton*>().size(), 5);
  press(form, Qt::Key_Escape);

  show_tab("My account");
  click(&page(), "Sign out");
  settle();
  sign_in("Kiwi (trainee)", "1234");
  ASSERT_TRUE(wait_for([&] { return progress()->isVisible() && trials()->rowCount() == 2; }, 20000));
  trials()->setCurrentCell(0, 0);
  EXPECT_TRUE(wait_for([&] { return text_of("ratings").contains("An instructor: 4 of 5"); }, 10000));
  for (auto* button : progress()->findChildren<QPushButton*>())
    EXPECT_FALSE(button->isVisible() && button->text().contains("Ra&te")) << "instructors only";
}

TEST_F(WindowRating, ALogThatIsAnotherTrialsIsReadForNoOther) {
  RecordRow one = row(kiwi_, 1, true);
  one.trial_path = write_log().string();
  one.log_sha256 = sha256_of_file(one.trial_path);
  EXPECT_EQ(read_log_here(one).ticks.size(), 20u);
  one.log_sha256[0] = one.log_sha256[0] == '0' ? '1' : '0';
  try {
    read_log_here(one);
    ADD_FAILURE() << "the bytes are not this trial's";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("another trial's"), std::string::npos) << error.what();
  }
}

TEST_F(WindowRating, AnAssessmentShowsNothingUntilItsTraineeHasRatedIt) {
  long long trial = 0;
  {
    Records records(records_location());
    records.add(row(kiwi_, 1, true));
    RecordRow assessed = row(kiwi_, 2, true);
    assessed.mode = curricula::Mode::assessment;
    trial = records.add(assessed);
  }
  open_as("Kiwi (trainee)", "1234");
  ASSERT_TRUE(wait_for([&] { return trials()->rowCount() == 2; }, 20000));
  EXPECT_EQ(trials()->item(0, 3)->text(), "rate it first");
  for (const int column : {4, 5, 6}) EXPECT_EQ(trials()->item(0, column)->text(), "-");
  EXPECT_EQ(trials()->item(1, 3)->text(), "passed");
  auto* curves = progress()->findChild<QListWidget*>();
  EXPECT_TRUE(curves->item(0)->text().contains("1 of 1 passed · 1 to rate")) << curves->item(0)->text().toStdString();
  EXPECT_TRUE(text_of("mastery").contains("1 in a row")) << "nor from the sums";
  trials()->setCurrentCell(0, 0);
  keep_picture(*window_, "rating-3-first.png");
  auto* hand_on = progress()->findChild<HandOn*>();
  hand_on->write_table(QString::fromStdString((box_ / "own.csv").string()));
  ASSERT_TRUE(wait_for([&] { return text_of("trials_message").contains("Written: own.csv, 1 trial."); }, 10000))
      << text_of("trials_message").toStdString();
  click(progress(), "Rate it first");
  auto* questions = dialog<SelfRatingPage>();
  ASSERT_NE(questions, nullptr);
  QApplication::processEvents();
  keep_picture(*questions->window(), "rating-4-own.png");
  press(questions, Qt::Key_3);
  press(questions, Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return trials()->item(0, 3)->text() == "passed"; }, 10000));
  EXPECT_TRUE(curves->item(0)->text().contains("2 of 2 passed"));
  trials()->setCurrentCell(0, 0);
  EXPECT_TRUE(wait_for([&] { return text_of("ratings").contains("own rating: 3 of 5"); }, 10000));
  ASSERT_EQ(ratings(trial).size(), 1u);
  EXPECT_EQ(ratings(trial)[0].by, "self");
}

TEST_F(WindowRating, WhatIsShownIsHandedOnAsATableAndOnPaper) {
  {
    Records records(records_location());
    for (int day = 1; day <= 3; ++day) records.add(row(kiwi_, day, true));
    records.add(row(emu_, 4, true));
    RecordRow last = row(emu_, 5, true);
    last.trial_path = write_log().string();
    last.log_sha256 = sha256_of_file(last.trial_path);
    records.add(last);
  }
  open_as("Boss (instructor)", "4321");
  auto* cohort = page().findChild<CohortTab*>();
  auto* table = cohort->findChild<QTableView*>();
  ASSERT_TRUE(wait_for([&] { return table->model()->rowCount() == 2; }, 20000));
  type(cohort->findChild<QLineEdit*>(), "emu");
  auto* hand_on = cohort->findChild<HandOn*>();
  const auto told = [](QWidget* within, const QString& text) {
    return wait_for(
        [&] {
          for (auto* label : within->findChildren<QLabel*>())
            if (label->text().contains(text)) return true;
          return false;
        },
        20000);
  };
  const auto path = [this](const char* name) { return QString::fromStdString((box_ / name).string()); };
  hand_on->write_table(path("cohort.csv"));
  ASSERT_TRUE(told(cohort, "Written: cohort.csv, 2 trials."));
  EXPECT_EQ(read_file(box_ / "cohort.csv").find("Emu"), std::string::npos) << "names only where asked for";
  emit hand_on->menu()->aboutToShow();
  keep_picture(*hand_on->menu(), "rating-5-menu.png");
  hand_on->menu()->actions().last()->setChecked(true);
  hand_on->write_table(path("names.csv"));
  ASSERT_TRUE(told(cohort, "Written: names.csv, 2 trials."));
  EXPECT_NE(read_file(box_ / "names.csv").find("Emu"), std::string::npos);
  keep_picture(*window_, "rating-6-cohort.png");
  hand_on->write_table(path("no-folder/cohort.csv"));
  ASSERT_TRUE(told(cohort, "Not handed on."));

  table->setCurrentIndex(table->model()->index(0, 0));
  press(table, Qt::Key_Return);
  ASSERT_TRUE(wait_for([&] { return progress()->isVisible() && trials()->rowCount() == 2; }, 20000));
  trials()->setCurrentCell(0, 0);
  hand_on = progress()->findChild<HandOn*>();
  hand_on->write_trainee_report(path("trainee.pdf"));
  ASSERT_TRUE(told(progress(), "Written: trainee.pdf, 2 trials."));
  hand_on->write_trial_report(path("trial.pdf"));
  ASSERT_TRUE(told(progress(), "Written: trial.pdf, 1 trial."));
  for (const char* name : {"trainee.pdf", "trial.pdf"}) EXPECT_EQ(read_file(box_ / name).substr(0, 5), "%PDF-");
}

TEST_F(WindowRating, WhatWaitsForTheStoreIsSaidAndSentByAButton) {
  curricula::testing::SmallLrs store;
  {
    Records records(records_location());
    records.add(row(kiwi_, 1, true));
  }
  open_as("Kiwi (trainee)", "1234");
  EXPECT_FALSE(window_->findChild<QLabel*>("statements_waiting")->isVisible()) << "no store is set";
  fs::create_directories(box_.home());
  std::ofstream(box_.home() / "settings.ini") << "[lrs]\naddress=" << store.address() << "\nkey=key\nsecret=s3cret\n";
  show_tab("My account");
  ASSERT_TRUE(wait_for([&] { return text_of("statements_waiting").contains("1 trial waits to be sent"); }, 10000))
      << text_of("statements_waiting").toStdString();
  keep_picture(*window_, "rating-7-statements.png");
  click(&page(), "Send now");
  ASSERT_TRUE(wait_for([&] { return text_of("statements") == "1 trial sent"; }, 20000))
      << text_of("statements").toStdString();
  ASSERT_TRUE(wait_for([&] { return text_of("statements_waiting").contains("nothing waits"); }, 10000));
  EXPECT_FALSE(store.kept().empty());
}

TEST_F(WindowRating, TimesAreThoseOfTheClockOnTheWall) {
  const char* before = std::getenv("TZ");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TZ", "XYZ-5:30", 1);  // 5 h 30 min before UTC's
  tzset();
  EXPECT_EQ(for_people("2026-05-03T20:00:00Z").toStdString(), "2026-05-04 01:30");
  {
    Records records(records_location());
    RecordRow late = row(kiwi_, 3, true);
    late.finished_utc = "2026-05-03T20:00:00Z";
    records.add(late);
  }
  open_as("Kiwi (trainee)", "1234");
  ASSERT_TRUE(wait_for([&] { return trials()->rowCount() == 1; }, 20000));
  EXPECT_EQ(trials()->item(0, 1)->text(), "2026-05-04 01:30");
  auto* calendar = progress()->findChild<QCalendarWidget*>();
  EXPECT_EQ(calendar->dateTextFormat(QDate(2026, 5, 4)).toolTip(), "1 trial, 1 passed");
  EXPECT_TRUE(calendar->dateTextFormat(QDate(2026, 5, 3)).toolTip().isEmpty());
  before == nullptr ? unsetenv("TZ") : setenv("TZ", kept.c_str(), 1);
  tzset();
}

}  // namespace
}  // namespace vallecula::gui::window_test
