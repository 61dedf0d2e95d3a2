#include "curricula/records/records.h"

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>
#include <thread>

#include "tests/curricula/temporary_folder.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;
using testing::error_of;

/// The test's own way into the file, beside the code under test.
class Database {
 public:
  explicit Database(const fs::path& file) {
    db_ = QSqlDatabase::addDatabase("QSQLITE", "test");
    db_.setDatabaseName(QString::fromStdString(file.string()));
    EXPECT_TRUE(db_.open());
  }
  ~Database() {
    db_ = QSqlDatabase();
    QSqlDatabase::removeDatabase("test");
  }
  QVariant ask(const char* sql) {
    QSqlQuery query(db_);
    EXPECT_TRUE(query.exec(sql)) << sql << ": " << query.lastError().text().toStdString();
    return query.next() ? query.value(0) : QVariant();
  }

 private:
  QSqlDatabase db_;
};

class RecordsFile : public testing::TemporaryFolder {
 protected:
  fs::path file() const { return folder_ / "deep" / "er" / "records.sqlite"; }
};

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

TEST_F(RecordsFile, WorksWithoutAnApplicationAndOutlivesTheProgram) {
  ASSERT_EQ(QCoreApplication::instance(), nullptr);
  RecordRow second = sample("2024-05-02T10:00:00Z");
  second.score.time_to_trachea_visible_s = -1.0;
  second.score.passed = second.score.complete = false;
  second.score.reasons.clear();
  second.curriculum_id.clear();
  long long first_id = 0;
  {
    Records records(file());
    first_id = records.add(sample("2024-05-03T10:00:00Z"));
    EXPECT_EQ(records.add(second), first_id + 1);
  }
  const Records records(file());
  const auto rows = records.newest(10);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].id, first_id);  // finished later
  expect_same(rows[0], sample("2024-05-03T10:00:00Z"));
  expect_same(rows[1], second);
  EXPECT_EQ(records.newest(1).size(), 1u);
  EXPECT_TRUE(records.newest(0).empty());
  EXPECT_TRUE(records.newest(-3).empty());
}

TEST_F(RecordsFile, UsesAWriteAheadLogAndTellsItsSchema) {
  { Records records(file()); }
  Database db(file());
  EXPECT_EQ(db.ask("PRAGMA journal_mode").toString(), "wal");
  EXPECT_EQ(db.ask("SELECT COUNT(*) FROM schema_version").toInt(), 1);
  EXPECT_EQ(db.ask("SELECT version FROM schema_version").toInt(), 3);
}

TEST_F(RecordsFile, AnOlderFileIsBroughtForwardWithItsRows) {
  fs::create_directories(file().parent_path());
  {
    Database db(file());  // as schema 1 wrote it
    db.ask("CREATE TABLE schema_version (version INTEGER NOT NULL)");
    db.ask("INSERT INTO schema_version VALUES (1)");
    db.ask(
        "CREATE TABLE trials (id INTEGER PRIMARY KEY AUTOINCREMENT, finished_utc TEXT NOT NULL, curriculum_id TEXT NOT "
        "NULL, "
        "scenario_id TEXT NOT NULL, device_kind TEXT NOT NULL, trial_path TEXT NOT NULL, complete INTEGER NOT NULL, "
        "passed INTEGER NOT NULL, reasons TEXT NOT NULL, peak_tongue_force_n REAL NOT NULL, "
        "time_of_peak_tongue_force_s REAL "
        "NOT NULL, time_to_trachea_visible_s REAL, glottis_visible_max_percent REAL NOT NULL, peak_gum_force_n REAL "
        "NOT NULL, "
        "time_of_peak_gum_force_s REAL NOT NULL, attempt_time_s REAL NOT NULL, attempt_start_s REAL NOT NULL, "
        "time_over_force_limit_s REAL NOT NULL, time_over_target_s REAL NOT NULL, loop_rate_hz REAL NOT NULL, "
        "deadline_misses INTEGER NOT NULL, ticks INTEGER NOT NULL)");
    db.ask(
        "INSERT INTO trials VALUES (7, '2023-01-01T00:00:00Z', 'c', 's', 'mouse', 'p', 1, 0, '[\"why\"]', 1, 2, NULL, "
        "3, 4, 5, "
        "6, 7, 8, 9, 10, 11, 12)");
  }
  {
    Records records(file());
    const auto rows = records.newest(5);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].id, 7);
    EXPECT_EQ(rows[0].score.reasons, std::vector<std::string>{"why"});
    EXPECT_EQ(rows[0].score.time_to_trachea_visible_s, -1.0);
    EXPECT_EQ(rows[0].score.ticks, 12);
    EXPECT_FALSE(rows[0].score.intubation) << "it was laryngoscopy alone";
    RecordRow tube = sample("2024-01-01T00:00:00Z");
    tube.score.intubation.emplace().outcome = Outcome::mainstem;
    tube.score.intubation->lowest_spo2_percent = 61.0;
    EXPECT_EQ(records.add(tube), 8);
    ASSERT_TRUE(records.newest(1)[0].score.intubation);
    EXPECT_EQ(records.newest(1)[0].score.intubation->outcome, Outcome::mainstem);
    EXPECT_EQ(records.newest(1)[0].score.intubation->lowest_spo2_percent, 61.0);
    tube.finished_utc = "2024-01-02T00:00:00Z";
    tube.score.intubation->lowest_spo2_percent.reset();
    records.add(tube);
    EXPECT_FALSE(records.newest(1)[0].score.intubation->lowest_spo2_percent);
  }
  Database db(file());
  EXPECT_EQ(db.ask("SELECT version FROM schema_version").toInt(), 3);
  EXPECT_EQ(db.ask("SELECT outcome FROM trials WHERE id = 8").toString(), "mainstem");
  EXPECT_TRUE(db.ask("SELECT outcome FROM trials WHERE id = 7").isNull());
  EXPECT_EQ(db.ask("SELECT COUNT(*) FROM sqlite_master WHERE type = 'index' AND name = 'trials_by_time'").toInt(), 1);
}

TEST_F(RecordsFile, ANewerFileIsRefusedAndLeftAlone) {
  { Records records(file()); }
  {
    Database db(file());
    db.ask("UPDATE schema_version SET version = 99");
  }
  const std::string error = error_of<RecordsError>([&] { Records records(file()); });
  EXPECT_NE(error.find("schema 99"), std::string::npos) << error;
  EXPECT_NE(error.find(file().string()), std::string::npos) << error;
  Database db(file());
  EXPECT_EQ(db.ask("SELECT version FROM schema_version").toInt(), 99);
}

TEST_F(RecordsFile, AFailedMigrationChangesNothing) {
  fs::create_directories(file().parent_path());
  {
    Database db(file());  // somebody else's table stands in the way
    db.ask("CREATE TABLE trials (something TEXT)");
  }
  EXPECT_NE(error_of<RecordsError>([&] { Records records(file()); }), "");
  Database db(file());
  EXPECT_EQ(db.ask("SELECT COUNT(*) FROM sqlite_master WHERE name = 'schema_version'").toInt(), 0);
}

TEST_F(RecordsFile, WhatIsNoDatabaseIsNamed) {
  const fs::path text = write("notes.txt", std::string(5000, 'x'));
  const std::string error = error_of<RecordsError>([&] { Records records(text); });
  EXPECT_NE(error.find("notes.txt"), std::string::npos) << error;
  EXPECT_EQ(read(text), std::string(5000, 'x'));
  EXPECT_NE(error_of<RecordsError>([&] { Records records(text / "below.sqlite"); }).find("folder"), std::string::npos);
  EXPECT_NE(error_of<RecordsError>([&] { Records records(folder_); }), "");
}

TEST_F(RecordsFile, ATimeThatIsNoneIsRefused) {
  Records records(file());
  for (const char* bad : {"", "yesterday", "2024-13-01T00:00:00Z"}) {
    EXPECT_NE(error_of<RecordsError>([&] { records.add(sample(bad)); }).find("ISO 8601"), std::string::npos);
  }
  EXPECT_TRUE(records.newest(5).empty());
}

TEST_F(RecordsFile, SeveralWritersAtOnceLoseNothing) {
  { Records records(file()); }
  std::vector<std::thread> writers;
  for (int i = 0; i < 4; ++i) {
    writers.emplace_back([this] {
      Records records(file());
      for (int k = 0; k < 10; ++k) records.add(sample("2024-05-03T10:00:00Z"));
    });
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(Records(file()).newest(100).size(), 40u);
}

}  // namespace
}  // namespace vallecula::curricula
