#include "curricula/records/records.h"

#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>
#include <fstream>

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

fs::path released(std::size_t schema) {
  return fs::path(VALLECULA_SOURCE_DIR) / "tests/curricula/records/released" /
         ("schema-" + std::to_string(schema) + ".sql");
}

/// The database's structure, as text: every table's columns, every index and trigger.
std::string structure(Database& db) {
  return db
      .ask(
          "SELECT group_concat(line, char(10)) FROM (SELECT m.type || ' ' || m.name || ' ' || "
          "coalesce(group_concat(c.name || ' ' || c.type || ' ' || c.\"notnull\" || ' ' || coalesce(c.dflt_value, '-') "
          "|| "
          "' ' || c.pk, ', '), '') || CASE m.type WHEN 'table' THEN '' ELSE coalesce(m.sql, '') END AS line "
          "FROM sqlite_master m LEFT JOIN pragma_table_info(m.name) c ON m.type = 'table' "
          "WHERE m.name NOT LIKE 'sqlite_%' GROUP BY m.name ORDER BY m.name)")
      .toString()
      .toStdString();
}

/// From a dump of each schema that was ever in use, made by that version and never edited.
TEST_F(RecordsFile, EveryReleasedSchemaIsBroughtForwardWithItsRows) {
  const std::size_t newest = record_migrations().size();
  { Records fresh(folder_ / "fresh.sqlite"); }
  std::string as_new;
  {
    Database db(folder_ / "fresh.sqlite");
    as_new = structure(db);
  }
  ASSERT_NE(as_new.find("table people id INTEGER"), std::string::npos) << as_new;
  for (std::size_t schema = 1; schema <= newest; ++schema) {
    SCOPED_TRACE("schema " + std::to_string(schema));
    ASSERT_TRUE(fs::exists(released(schema)))
        << "every schema has its dump here (curricula/README.md says how it is made)";
    const fs::path old = folder_ / ("schema-" + std::to_string(schema) + ".sqlite");
    {
      Database db(old);
      std::string statement;
      std::ifstream dump(released(schema));
      for (std::string line; std::getline(dump, line);) {
        if (line.rfind("--", 0) == 0) continue;
        statement += line + "\n";
        // A trigger holds statements of its own, each on the same line.
        if (line.empty() || line.back() != ';') continue;
        db.ask(statement.c_str());
        statement.clear();
      }
    }
    {
      Records records(old);
      const auto rows = records.newest(5);
      ASSERT_EQ(rows.size(), 2u);
      EXPECT_EQ(rows[0].id, 9);
      EXPECT_EQ(rows[0].device_kind, "touch");
      EXPECT_FALSE(rows[0].score.complete);
      EXPECT_EQ(rows[0].score.peak_tongue_force_n, 0.1);
      EXPECT_EQ(rows[0].score.time_to_trachea_visible_s, 3.5);
      EXPECT_EQ(rows[0].score.ticks, 5000000000LL);
      EXPECT_EQ(rows[0].score.intubation.has_value(), schema >= 3);
      if (schema >= 3) {
        EXPECT_EQ(rows[0].score.intubation->outcome, Outcome::mainstem);
        EXPECT_EQ(rows[0].score.intubation->lowest_spo2_percent, 61.0);
      }
      EXPECT_TRUE(rows[0].score.set_aside.empty());
      EXPECT_EQ(rows[1].score.set_aside, schema < 5 ? std::vector<std::string>{} : std::vector<std::string>{"why not"});
      EXPECT_EQ(rows[1].id, 7);
      EXPECT_EQ(rows[1].trainee_id, 0);
      EXPECT_EQ(rows[1].uid.empty(), schema < 4);
      EXPECT_EQ(rows[1].trial_path, "/a/b.vtrial");
      EXPECT_EQ(rows[1].mode, schema < 4 ? Mode::practice : Mode::assessment);
      EXPECT_EQ(rows[1].attempt_seed, schema < 4 ? 0u : 4294967295u);
      EXPECT_EQ(rows[1].duration_s, schema < 4 ? std::nullopt : std::optional(61.5));
      EXPECT_EQ(rows[1].points, schema < 4 ? std::nullopt : std::optional(62.5));
      EXPECT_EQ(rows[1].module_id, schema < 4 ? "" : "m");
      EXPECT_EQ(rows[1].figures.at("peak_tongue_force_n"), 1.5) << "also of what is older than the table";
      EXPECT_EQ(rows[0].figures.at("peak_tongue_force_n"), 0.1);
      EXPECT_EQ(rows[1].figures.count("time_to_trachea_visible_s"), 0u);
      EXPECT_EQ(rows[1].score.reasons, std::vector<std::string>{"why"});
      EXPECT_EQ(rows[1].score.time_to_trachea_visible_s, -1.0);
      EXPECT_FALSE(rows[1].score.intubation) << "it was laryngoscopy alone";
      EXPECT_EQ(records.add(sample("2024-01-01T00:00:00Z")), 10);
    }
    Database db(old);
    EXPECT_EQ(db.ask("SELECT version FROM schema_version").toInt(), static_cast<int>(newest));
    EXPECT_EQ(structure(db), as_new);
    EXPECT_EQ(db.ask("PRAGMA integrity_check").toString(), "ok");
    EXPECT_EQ(db.ask("SELECT COUNT(*) FROM people").toInt(), schema < 4 ? 0 : 1);
    EXPECT_EQ(db.ask("SELECT COUNT(*) FROM ratings").toInt(), schema < 4 ? 0 : 1);
  }
}

TEST_F(RecordsFile, KeepsOutcomeAndSaturationOfAnIntubation) {
  Records records(file());
  RecordRow tube = sample("2024-01-01T00:00:00Z");
  tube.score.intubation.emplace().outcome = Outcome::mainstem;
  tube.score.intubation->lowest_spo2_percent = 61.0;
  records.add(tube);
  ASSERT_TRUE(records.newest(1)[0].score.intubation);
  EXPECT_EQ(records.newest(1)[0].score.intubation->outcome, Outcome::mainstem);
  EXPECT_EQ(records.newest(1)[0].score.intubation->lowest_spo2_percent, 61.0);
  tube.finished_utc = "2024-01-02T00:00:00Z";
  tube.score.intubation->lowest_spo2_percent.reset();
  records.add(tube);
  EXPECT_FALSE(records.newest(1)[0].score.intubation->lowest_spo2_percent);
  Database db(file());
  EXPECT_EQ(db.ask("SELECT outcome FROM trials WHERE id = 1").toString(), "mainstem");
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
