#include "curricula/records/records.h"

#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include "curricula/records/migrations.h"
#include "tests/curricula/records/any_records.h"
#include "tests/curricula/temporary_folder.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;
using testing::error_of;
using testing::sample;

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

TEST_F(RecordsFile, UsesAWriteAheadLogAndTellsItsSchema) {
  { Records records(file()); }
  Database db(file());
  EXPECT_EQ(db.ask("PRAGMA journal_mode").toString(), "wal");
  EXPECT_EQ(db.ask("SELECT COUNT(*) FROM schema_version").toInt(), 1);
  EXPECT_EQ(db.ask("SELECT version FROM schema_version").toInt(), static_cast<int>(record_migrations().size()));
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
  EXPECT_EQ(db.ask("SELECT version FROM schema_version").toInt(), static_cast<int>(record_migrations().size()));
  EXPECT_EQ(db.ask("SELECT outcome FROM trials WHERE id = 8").toString(), "mainstem");
  EXPECT_TRUE(db.ask("SELECT outcome FROM trials WHERE id = 7").isNull());
  EXPECT_EQ(db.ask("SELECT COUNT(*) FROM sqlite_master WHERE type = 'index' AND name = 'trials_by_time'").toInt(), 1);
}

TEST_F(RecordsFile, WhatIsNoDatabaseIsNamed) {
  const fs::path text = write("notes.txt", std::string(5000, 'x'));
  const std::string error = error_of<RecordsError>([&] { Records records(text); });
  EXPECT_NE(error.find("notes.txt"), std::string::npos) << error;
  EXPECT_EQ(read(text), std::string(5000, 'x'));
  EXPECT_NE(error_of<RecordsError>([&] { Records records(text / "below.sqlite"); }).find("folder"), std::string::npos);
  EXPECT_NE(error_of<RecordsError>([&] { Records records(folder_); }), "");
}

}  // namespace
}  // namespace vallecula::curricula
