#include "tests/curricula/records/any_records.h"

#include <unistd.h>

#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

namespace vallecula::curricula::testing {

namespace fs = std::filesystem;

INSTANTIATE_TEST_SUITE_P(Sqlite, AnyRecords, ::testing::Values(Kept::sqlite), [](const auto&) { return "File"; });
INSTANTIATE_TEST_SUITE_P(Postgres, AnyRecords, ::testing::Values(Kept::postgres), [](const auto&) { return "Server"; });

void AnyRecords::SetUp() {
  if (on_server()) {
    const std::string reason = PostgresServer::why_not();
    if (!reason.empty()) GTEST_SKIP() << reason;
  }
  std::string name = ::testing::TempDir() + "vallecula-records-XXXXXX";
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  folder_ = name;
  setting_ = on_server() ? PostgresServer::instance().new_database() : (folder_ / "records.sqlite").string();
  location_ = std::make_unique<RecordsLocation>(RecordsLocation::parse(setting_));
}

void AnyRecords::TearDown() {
  if (!folder_.empty()) fs::remove_all(folder_);
}

RecordsLocation AnyRecords::at_station(const std::string& station) const {
  RecordsLocation there = location();
  there.station = station;
  return there;
}

std::string AnyRecords::ask(const std::string& sql) const {
  if (on_server()) {
    const std::string answer = PostgresServer::instance().ask(setting_, sql);
    return answer.substr(0, answer.find('\n'));
  }
  std::string answer;
  {
    QSqlDatabase db = QSqlDatabase::addDatabase("QSQLITE", "beside");
    db.setDatabaseName(QString::fromStdString(setting_));
    EXPECT_TRUE(db.open());
    QSqlQuery query(db);
    if (!query.exec(QString::fromStdString(sql)))
      answer = "ERROR: " + query.lastError().text().toStdString();
    else if (query.next())
      answer = query.value(0).toString().toStdString();
  }
  QSqlDatabase::removeDatabase("beside");
  return answer;
}

RecordRow sample(const std::string& when) {
  RecordRow row;
  row.finished_utc = when;
  row.curriculum_id = "first-steps";
  row.scenario_id = "term";
  row.device_kind = "mouse";
  row.trial_path = "/trials/übung's.vtrial";
  row.score.complete = true;
  row.score.passed = true;
  row.score.reasons = {"Peak \"5.1\" N; it's allowed", "Größe"};
  row.score.peak_tongue_force_n = 5.1234567890123456;
  row.score.time_of_peak_tongue_force_s = 1.5;
  row.score.time_to_trachea_visible_s = 7.25;
  row.score.glottis_visible_max_percent = 81.5;
  row.score.peak_gum_force_n = 0.25;
  row.score.time_of_peak_gum_force_s = 2.5;
  row.score.attempt_time_s = 17.125;
  row.score.attempt_start_s = 0.75;
  row.score.time_over_force_limit_s = 0.1;
  row.score.time_over_target_s = 0.2;
  row.score.loop_rate_hz = 999.9;
  row.score.deadline_misses = 12;
  row.score.ticks = 5000000000LL;
  return row;
}

void expect_same(const RecordRow& a, const RecordRow& b) {
  EXPECT_EQ(a.finished_utc, b.finished_utc);
  EXPECT_EQ(a.curriculum_id, b.curriculum_id);
  EXPECT_EQ(a.scenario_id, b.scenario_id);
  EXPECT_EQ(a.device_kind, b.device_kind);
  EXPECT_EQ(a.trial_path, b.trial_path);
  EXPECT_EQ(a.score.complete, b.score.complete);
  EXPECT_EQ(a.score.passed, b.score.passed);
  EXPECT_EQ(a.score.reasons, b.score.reasons);
  EXPECT_EQ(a.score.peak_tongue_force_n, b.score.peak_tongue_force_n);
  EXPECT_EQ(a.score.time_of_peak_tongue_force_s, b.score.time_of_peak_tongue_force_s);
  EXPECT_EQ(a.score.time_to_trachea_visible_s, b.score.time_to_trachea_visible_s);
  EXPECT_EQ(a.score.glottis_visible_max_percent, b.score.glottis_visible_max_percent);
  EXPECT_EQ(a.score.peak_gum_force_n, b.score.peak_gum_force_n);
  EXPECT_EQ(a.score.time_of_peak_gum_force_s, b.score.time_of_peak_gum_force_s);
  EXPECT_EQ(a.score.attempt_time_s, b.score.attempt_time_s);
  EXPECT_EQ(a.score.attempt_start_s, b.score.attempt_start_s);
  EXPECT_EQ(a.score.time_over_force_limit_s, b.score.time_over_force_limit_s);
  EXPECT_EQ(a.score.time_over_target_s, b.score.time_over_target_s);
  EXPECT_EQ(a.score.loop_rate_hz, b.score.loop_rate_hz);
  EXPECT_EQ(a.score.deadline_misses, b.score.deadline_misses);
  EXPECT_EQ(a.score.ticks, b.score.ticks);
}

}  // namespace vallecula::curricula::testing
