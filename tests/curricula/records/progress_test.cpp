#include "curricula/records/progress.h"

#include "curricula/records/notes.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

/// Two trainees, two device kinds, an instructor.
struct Class {
  explicit Class(const RecordsLocation& location) : records(location), people(records) {
    boss = people.create_first_instructor("Boss", "4321");
    kiwi_id = people.register_trainee("Kiwi", "1234");
    emu_id = people.register_trainee("Emu", "1234");
    kiwi = people.sign_in(kiwi_id, "1234");
    emu = people.sign_in(emu_id, "1234");
  }
  long long add(long long trainee, const std::string& when, bool passed, const std::string& kind = "mouse",
                bool complete = true) {
    RecordRow row = sample(when);
    row.trainee_id = trainee;
    row.device_kind = kind;
    row.score.passed = passed;
    row.score.complete = complete;
    return records.add(row);
  }
  Records records;
  People people;
  long long kiwi_id = 0, emu_id = 0;
  Who boss, kiwi, emu;
};

TEST_P(AnyRecords, WhatWasSetAsideIsInNoFigureAndSaysWhyAfterwards) {
  Class c(location());
  c.add(c.kiwi_id, "2024-05-01T10:00:00Z", true);
  RecordRow row = sample("2024-05-02T10:00:00Z");
  row.trainee_id = c.kiwi_id;
  row.device_kind = "mouse";
  row.score.passed = true;
  row.score.complete = true;
  row.score.set_aside = {"The instructor changed it", "Begun elsewhere"};
  c.records.add(row);
  const Progress progress(c.records);
  const auto curves = progress.curves(c.kiwi, c.kiwi_id);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].trials, 1);
  EXPECT_EQ(curves[0].set_aside, 1);
  EXPECT_EQ(curves[0].interrupted, 0);
  EXPECT_EQ(curves[0].passed, 1);
  std::size_t counted = 0;
  for (const auto& [curriculum, results] : progress.results(c.kiwi, c.kiwi_id)) counted += results.size();
  EXPECT_EQ(counted, 1u);
  const auto trials = progress.trials(c.kiwi, c.kiwi_id, 5);
  ASSERT_EQ(trials.size(), 2u);
  EXPECT_EQ(trials[0].score.set_aside, row.score.set_aside);
  EXPECT_FALSE(procedure_succeeded(trials[0]));
  EXPECT_TRUE(procedure_succeeded(trials[1]));
}

TEST_P(AnyRecords, ACurveIsOfOneTraineeScenarioAndDeviceKind) {
  Class c(location());
  for (int i = 0; i < 4; ++i) c.add(c.kiwi_id, "2024-05-0" + std::to_string(i + 1) + "T10:00:00Z", i != 1);
  c.add(c.kiwi_id, "2024-05-05T10:00:00Z", true, "touch");
  c.add(c.kiwi_id, "2024-05-05T11:00:00Z", false, "mouse", false);  // interrupted
  c.add(c.emu_id, "2024-05-05T10:00:00Z", false);
  c.add(0, "2024-05-06T10:00:00Z", true);
  const Progress progress(c.records);

  const auto curves = progress.curves(c.kiwi, c.kiwi_id);
  ASSERT_EQ(curves.size(), 2u);
  const CurveSummary &mouse = curves[0], &touch = curves[1];
  EXPECT_EQ(mouse.key.device_kind, "mouse");
  EXPECT_EQ(mouse.trials, 4);
  EXPECT_EQ(mouse.interrupted, 1);
  EXPECT_EQ(mouse.passed, 3);
  EXPECT_EQ(mouse.passed_in_a_row, 2);
  EXPECT_EQ(mouse.to_three_in_a_row, -1);
  EXPECT_EQ(mouse.first_utc, "2024-05-01T10:00:00Z");
  EXPECT_EQ(mouse.last_utc, "2024-05-05T11:00:00Z");
  ASSERT_EQ(mouse.cusum.size(), 4u);
  EXPECT_NEAR(mouse.cusum[3].sum, 1.0 - 4 * 0.2933049, 1e-5);
  EXPECT_EQ(touch.key.device_kind, "touch");
  EXPECT_EQ(touch.trials, 1) << "never pooled";

  const auto curve = progress.curve(c.kiwi, mouse.key);
  ASSERT_EQ(curve.size(), 5u);
  EXPECT_FALSE(curve[1].score.passed);
  EXPECT_FALSE(curve[4].score.complete);
  EXPECT_EQ(progress.trials(c.kiwi, c.kiwi_id, 2).size(), 2u);
  EXPECT_EQ(progress.trials(c.kiwi, c.kiwi_id, 2)[0].finished_utc, "2024-05-05T11:00:00Z");
  const auto days = progress.calendar(c.kiwi, c.kiwi_id);
  ASSERT_EQ(days.size(), 5u);
  EXPECT_EQ(days[4].date, "2024-05-05");
  EXPECT_EQ(days[4].trials, 2);
  EXPECT_EQ(days[4].passed, 1);
  // What belongs to nobody anybody sees, and it is in nobody else's curves.
  EXPECT_EQ(progress.curves(std::nullopt, 0).at(0).trials, 1);
  EXPECT_EQ(c.records.newest(10).size(), 1u);
}

TEST_P(AnyRecords, WhatCountsTowardsMasteryIsOldestFirstAndWhole) {
  Records records(location());
  RecordRow row = sample("2024-05-03T10:00:00Z");
  row.mode = Mode::assessment;
  records.add(row);
  row.score.complete = false;
  records.add(row);
  row = sample("2024-05-02T10:00:00Z");  // the clock went back: recorded later all the same
  row.device_kind = "touch";
  row.score.passed = false;
  row.score.intubation.emplace().attempts.resize(3);
  records.add(row);
  row.curriculum_id = "another";
  records.add(row);
  const auto all = Progress(records).results(std::nullopt, 0);
  EXPECT_EQ(all.size(), 2u);
  const auto& results = all.at("first-steps");
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].mode, Mode::assessment);
  EXPECT_EQ(results[0].device_kind, "mouse");
  EXPECT_TRUE(results[0].passed);
  EXPECT_EQ(results[0].attempts, 1);
  EXPECT_EQ(results[1].device_kind, "touch");
  EXPECT_EQ(results[1].attempts, 3);
  EXPECT_FALSE(results[1].passed);
}

TEST_P(AnyRecords, AnIntubationSucceedsWithinTwoAttempts) {
  Records records(location());
  const auto with_attempts = [](std::size_t attempts) {
    RecordRow row = sample("2024-05-03T10:00:00Z");
    row.score.intubation.emplace().outcome = Outcome::good_depth;
    row.score.intubation->attempts.resize(attempts);
    if (attempts > 0) {
      row.score.intubation->attempts.back().passed_cords_s = 20.0;
      row.score.intubation->attempts.back().time_to_pass_s = 4.25;
    }
    row.score.intubation->lowest_heart_per_min = 88.0;
    return row;
  };
  for (std::size_t attempts : {1u, 2u, 3u}) records.add(with_attempts(attempts));
  const auto curve = Progress(records).curve(std::nullopt, {0, "first-steps", "term", "mouse"});
  ASSERT_EQ(curve.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const RecordRow& row = curve[static_cast<std::size_t>(i)];
    EXPECT_EQ(row.attempts, i + 1);
    EXPECT_EQ(row.time_to_pass_s, 4.25);
    EXPECT_EQ(row.score.intubation->lowest_heart_per_min, 88.0);
    EXPECT_FALSE(row.score.intubation->lowest_spo2_percent);
    EXPECT_EQ(procedure_succeeded(row), i < 2) << i;
  }
}

TEST_P(AnyRecords, AClockThatGoesBackDoesNotReorderACurve) {
  Class c(location());
  c.add(c.kiwi_id, "2024-05-03T10:00:00Z", false);
  c.add(c.kiwi_id, "2023-01-01T00:00:00Z", true);
  const auto curve = Progress(c.records).curve(c.kiwi, {c.kiwi_id, "first-steps", "term", "mouse"});
  ASSERT_EQ(curve.size(), 2u) << "and nothing is lost";
  EXPECT_FALSE(curve[0].score.passed);
  EXPECT_TRUE(curve[1].score.passed);
}

TEST_P(AnyRecords, ACohortIsTheInstructors) {
  Class c(location());
  c.add(c.kiwi_id, "2024-05-01T10:00:00Z", true);
  c.add(c.emu_id, "2024-05-02T10:00:00Z", false);
  c.add(c.emu_id, "2024-05-03T10:00:00Z", true, "touch");
  c.add(0, "2024-05-03T10:00:00Z", true);
  c.add(c.boss->id(), "2024-05-03T10:00:00Z", true);  // who teaches is no trainee
  const Progress progress(c.records);
  const auto all = progress.cohort(*c.boss, {});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].trainee_name, "Emu");
  EXPECT_EQ(all[2].trainee_name, "Kiwi");
  CohortFilter filter;
  filter.device_kind = "touch";
  EXPECT_EQ(progress.cohort(*c.boss, filter).size(), 1u);
  filter = {};
  filter.since_utc = "2024-05-02T00:00:00Z";
  filter.until_utc = "2024-05-03T10:00:00Z";
  ASSERT_EQ(progress.cohort(*c.boss, filter).size(), 1u);
  EXPECT_EQ(progress.cohort(*c.boss, filter)[0].key.device_kind, "mouse");
  filter = {};
  filter.scenario_id = "none";
  EXPECT_TRUE(progress.cohort(*c.boss, filter).empty());

  EXPECT_NE(error_of<NotAllowed>([&] { progress.cohort(*c.kiwi, {}); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { progress.curves(c.kiwi, c.emu_id); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { progress.curve(std::nullopt, {c.emu_id, "a", "b", "c"}); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { progress.trials(c.emu, c.kiwi_id, 5); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { progress.calendar(std::nullopt, c.kiwi_id); }), "");
  EXPECT_EQ(progress.curves(c.boss, c.emu_id).size(), 2u);
}

TEST_P(AnyRecords, ANoteStandsAtASecondOfATrial) {
  Class c(location());
  const long long trial = c.add(c.kiwi_id, "2024-05-01T10:00:00Z", true),
                  nobodys = c.add(0, "2024-05-01T10:00:00Z", true);
  Notes notes(c.records);
  const long long late = notes.add(c.boss, trial, 12.5, "Größer heben; don't \\ lever");
  const long long early = notes.add(c.kiwi, trial, 3.25, "late sweep\nsecond line");
  const auto found = notes.of_trial(c.kiwi, trial);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].id, early);
  EXPECT_EQ(found[0].at_s, 3.25);
  EXPECT_EQ(found[0].text, "late sweep\nsecond line");
  EXPECT_EQ(found[1].text, "Größer heben; don't \\ lever");
  EXPECT_EQ(found[1].author_id, c.boss->id());

  EXPECT_NE(error_of<NotAllowed>([&] { notes.add(c.emu, trial, 1.0, "mine?"); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { notes.of_trial(c.emu, trial); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { notes.of_trial(std::nullopt, trial); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { notes.remove(c.kiwi, late); }), "")
      << "an instructor's note is the instructor's";
  notes.remove(c.kiwi, early);
  notes.remove(c.boss, late);
  EXPECT_TRUE(notes.of_trial(c.boss, trial).empty());
  EXPECT_NE(error_of<RecordsError>([&] { notes.remove(c.boss, late); }), "");

  EXPECT_EQ(notes.of_trial(std::nullopt, nobodys).size(), 0u);
  notes.remove(std::nullopt, notes.add(std::nullopt, nobodys, 0.0, "to myself"));

  for (const std::string& text :
       {std::string(), std::string(10'001, 'x'), std::string("\xc3("), std::string("a\0b", 3)})
    EXPECT_NE(error_of<RecordsError>([&] { notes.add(c.boss, trial, 1.0, text); }).find("UTF-8"), std::string::npos);
  for (const double at : {-0.001, 1e9, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_NE(error_of<RecordsError>([&] { notes.add(c.boss, trial, at, "x"); }).find("second"), std::string::npos);
  EXPECT_NE(error_of<RecordsError>([&] { notes.add(c.boss, 999, 1.0, "x"); }).find("no trial 999"), std::string::npos);
  EXPECT_TRUE(notes.of_trial(c.boss, trial).empty());
}

TEST_P(AnyRecords, ANotesTrialIsFoundByItsLog) {
  Class c(location());
  c.add(c.kiwi_id, "2024-05-01T10:00:00Z", true);  // whose log's hash is not known
  RecordRow row;
  row.finished_utc = "2024-05-02T10:00:00Z";
  row.curriculum_id = row.scenario_id = row.device_kind = "x";
  row.trial_path = "/somewhere/trial.vtrial";
  row.log_sha256 = "abc";
  const long long trial = c.records.add(row);
  const Notes notes(c.records);
  EXPECT_EQ(notes.trial_of_log("abc"), trial);
  EXPECT_EQ(notes.trial_of_log("abd"), 0);
  EXPECT_EQ(notes.trial_of_log(""), 0);
}

}  // namespace
}  // namespace vallecula::curricula::testing
