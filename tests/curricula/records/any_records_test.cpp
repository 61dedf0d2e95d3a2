#include "tests/curricula/records/any_records.h"

#include <QCoreApplication>
#include <thread>
#include <vector>

#include "curricula/score/figures.h"

namespace vallecula::curricula::testing {
namespace {

TEST_P(AnyRecords, GivesBackToTheLastBitWhatWasAdded) {
  ASSERT_EQ(QCoreApplication::instance(), nullptr);
  RecordRow second = sample("2024-05-02T10:00:00Z");
  second.score.time_to_trachea_visible_s = -1.0;
  second.score.passed = second.score.complete = false;
  second.score.reasons.clear();
  second.curriculum_id.clear();
  second.trial_path = "back\\slash 'quoted' \"twice\" ? :name %s ;";
  second.score.peak_tongue_force_n = 0.1 + 0.2;
  second.score.loop_rate_hz = 4.9406564584124654e-324;
  second.score.attempt_time_s = 1.7976931348623157e308;
  long long first_id = 0;
  {
    Records records(location());
    first_id = records.add(sample("2024-05-03T10:00:00Z"));
    EXPECT_EQ(records.add(second), first_id + 1);
  }
  const Records records(location());
  const auto rows = records.newest(10);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].id, first_id);  // finished later
  expect_same(rows[0], sample("2024-05-03T10:00:00Z"));
  expect_same(rows[1], second);
  EXPECT_EQ(records.newest(1).size(), 1u);
  EXPECT_TRUE(records.newest(0).empty());
  EXPECT_TRUE(records.newest(-3).empty());
}

TEST_P(AnyRecords, ANewerSchemaIsRefusedAndLeftAlone) {
  { Records records(location()); }
  ask("UPDATE schema_version SET version = 99");
  const std::string error = error_of<RecordsError>([&] { Records records(location()); });
  EXPECT_NE(error.find("schema 99"), std::string::npos) << error;
  EXPECT_NE(error.find(location().shown()), std::string::npos) << error;
  EXPECT_EQ(ask("SELECT version FROM schema_version"), "99");
}

TEST_P(AnyRecords, AFailedMigrationChangesNothing) {
  ask("CREATE TABLE trials (something TEXT)");  // somebody else's table stands in the way
  EXPECT_NE(error_of<RecordsError>([&] { Records records(location()); }), "");
  ask("ALTER TABLE trials RENAME TO theirs");
  EXPECT_NE(ask("SELECT COUNT(*) FROM schema_version").find("ERROR"), std::string::npos);
  EXPECT_EQ(error_of<RecordsError>([&] { Records records(location()); }), "");
}

TEST_P(AnyRecords, StationsThatBeginTogetherMakeTheSchemaOnce) {
  std::vector<std::thread> stations;
  for (int i = 0; i < 4; ++i) {
    stations.emplace_back([this] {
      Records records(location());
      for (int k = 0; k < 10; ++k) records.add(sample("2024-05-03T10:00:00Z"));
    });
  }
  for (std::thread& station : stations) station.join();
  EXPECT_EQ(Records(location()).newest(100).size(), 40u);
  EXPECT_EQ(ask("SELECT COUNT(*) FROM schema_version"), "1");
}

TEST_P(AnyRecords, ATrialUnderWayIsKnownUntilItHasItsRow) {
  Records records(at_station("a")), elsewhere(at_station("b"));
  const OpenTrial trial{"", "2024-05-03T09:59:00Z", "first-steps", "term", "mouse", "/trials/here.vtrial", 0, "first"};
  const std::string uid = records.begin(trial), other = records.begin(trial);
  EXPECT_NE(uid, other);
  ASSERT_EQ(records.open_trials().size(), 2u);
  EXPECT_TRUE(elsewhere.open_trials().empty());
  const auto open = records.open_trials();
  EXPECT_EQ(open[0].log_path, "/trials/here.vtrial");
  EXPECT_EQ(open[0].scenario_id, "term");
  EXPECT_EQ(open[0].module_id, "first");
  EXPECT_EQ(open[0].started_utc, trial.started_utc);

  RecordRow row = sample("2024-05-03T10:00:00Z");
  row.uid = uid;
  row.started_utc = trial.started_utc;
  row.log_sha256 = "abc";
  const long long id = records.add(row);
  EXPECT_EQ(records.add(row), id) << "the answer to the first try was lost: no second row";
  records.abandon(other);
  EXPECT_TRUE(records.open_trials().empty());
  const auto rows = records.newest(5);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].uid, uid);
  EXPECT_EQ(rows[0].station, "a");
  EXPECT_EQ(rows[0].started_utc, trial.started_utc);
  EXPECT_EQ(rows[0].log_sha256, "abc");

  row.uid = other;  // given up: whoever still adds it is told
  EXPECT_NE(error_of<RecordsError>([&] { records.add(row); }).find("not among those begun"), std::string::npos);
}

TEST_P(AnyRecords, ModeSeedModuleDurationAndFiguresAreKeptWithTheTrial) {
  Records records(location());
  RecordRow row = sample("2024-05-03T10:00:00Z");
  row.module_id = "the-view";
  row.mode = Mode::assessment;
  row.attempt_seed = 4294967295u;
  row.duration_s = 31.25;
  row.score.time_to_trachea_visible_s = -1.0;
  row.figures["not a figure"] = 1.0;
  records.add(row);
  records.add(sample("2024-05-02T10:00:00Z"));
  const auto rows = records.newest(2);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].module_id, "the-view");
  EXPECT_EQ(rows[0].mode, Mode::assessment);
  EXPECT_EQ(rows[0].attempt_seed, 4294967295u);
  EXPECT_EQ(rows[0].duration_s, 31.25);
  std::map<std::string, double> expected;
  for (const Figure& figure : figures())
    if (const auto value = figure.value(row.score)) expected[figure.name] = *value;
  EXPECT_EQ(rows[0].figures, expected);
  EXPECT_EQ(rows[0].figures.at("peak_tongue_force_n"), 5.1234567890123456);
  EXPECT_EQ(rows[0].figures.count("time_to_trachea_visible_s"), 0u) << "it was never in sight";
  EXPECT_EQ(rows[1].figures.at("time_to_trachea_visible_s"), 7.25) << "each trial its own";
  EXPECT_EQ(rows[1].mode, Mode::practice);
  EXPECT_EQ(rows[1].attempt_seed, 0u);
  EXPECT_FALSE(rows[1].duration_s);
}

TEST_P(AnyRecords, ATimeThatIsNoneIsRefused) {
  Records records(location());
  for (const char* bad : {"", "yesterday", "2024-13-01T00:00:00Z"})
    EXPECT_NE(error_of<RecordsError>([&] { records.add(sample(bad)); }).find("ISO 8601"), std::string::npos);
  EXPECT_TRUE(records.newest(5).empty());
}

}  // namespace
}  // namespace vallecula::curricula::testing
