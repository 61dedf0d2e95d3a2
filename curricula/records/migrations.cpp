#include "curricula/records/migrations.h"

#include <string>

namespace vallecula::curricula {
namespace {

constexpr long long kMigrationLock = 0x76616c6c6563;  ///< a number of our own among a server's advisory locks
constexpr const char* kNotMigrated = "cannot be brought to the newest schema";

long long single_number(Connection& connection, const char* sql) {
  QSqlQuery query = connection.run(sql, {}, Connection::kCannotBeRead);
  query.next();
  return query.value(0).toLongLong();
}

}  // namespace

const std::vector<std::vector<Statement>>& record_migrations() {
  static const std::vector<std::vector<Statement>> steps = {
      {"CREATE TABLE trials ("
       "id INTEGER PRIMARY KEY AUTOINCREMENT, "
       "finished_utc TEXT NOT NULL, "
       "curriculum_id TEXT NOT NULL, "
       "scenario_id TEXT NOT NULL, "
       "device_kind TEXT NOT NULL, "
       "trial_path TEXT NOT NULL, "
       "complete INTEGER NOT NULL, "
       "passed INTEGER NOT NULL, "
       "reasons TEXT NOT NULL, "  // JSON array
       "peak_tongue_force_n REAL NOT NULL, "
       "time_of_peak_tongue_force_s REAL NOT NULL, "
       "time_to_trachea_visible_s REAL, "  // NULL: never in sight
       "glottis_visible_max_percent REAL NOT NULL, "
       "peak_gum_force_n REAL NOT NULL, "
       "time_of_peak_gum_force_s REAL NOT NULL, "
       "attempt_time_s REAL NOT NULL, "
       "attempt_start_s REAL NOT NULL, "
       "time_over_force_limit_s REAL NOT NULL, "
       "time_over_target_s REAL NOT NULL, "
       "loop_rate_hz REAL NOT NULL, "
       "deadline_misses INTEGER NOT NULL, "
       "ticks INTEGER NOT NULL)"},
      {"CREATE INDEX trials_by_time ON trials (finished_utc)"},
      {"ALTER TABLE trials ADD COLUMN outcome TEXT",  // NULL: a trial without an intubation
       "ALTER TABLE trials ADD COLUMN lowest_spo2_percent REAL"},
      // People, whose trial it was, trials under way, notes, what is to be deleted, and the audit trail.
      {"CREATE TABLE people ("
       "id INTEGER PRIMARY KEY AUTOINCREMENT, "  // never given twice: the audit trail goes on naming it
       "role TEXT NOT NULL CHECK (role IN ('trainee', 'instructor')), "
       "name TEXT NOT NULL UNIQUE, "
       "pin_hash TEXT NOT NULL, "
       "created_utc TEXT NOT NULL, "
       "wrong_pins INTEGER NOT NULL DEFAULT 0, "
       "wait_ms INTEGER NOT NULL DEFAULT 0, "  // from wait_from_ms, ms since 1970
       "wait_from_ms INTEGER NOT NULL DEFAULT 0)",
       "ALTER TABLE trials ADD COLUMN trainee_id INTEGER REFERENCES people (id)",  // NULL: nobody's
       "ALTER TABLE trials ADD COLUMN uid TEXT",                                   // NULL: before schema 4
       "ALTER TABLE trials ADD COLUMN started_utc TEXT NOT NULL DEFAULT ''",
       "ALTER TABLE trials ADD COLUMN station TEXT NOT NULL DEFAULT ''",
       "ALTER TABLE trials ADD COLUMN log_sha256 TEXT NOT NULL DEFAULT ''",
       "ALTER TABLE trials ADD COLUMN attempts INTEGER",
       "ALTER TABLE trials ADD COLUMN time_to_pass_s REAL",
       "ALTER TABLE trials ADD COLUMN lowest_heart_per_min REAL",
       "ALTER TABLE trials ADD COLUMN module_id TEXT NOT NULL DEFAULT ''",
       "ALTER TABLE trials ADD COLUMN mode TEXT NOT NULL DEFAULT 'practice'",
       "ALTER TABLE trials ADD COLUMN attempt_seed INTEGER NOT NULL DEFAULT 0",
       "ALTER TABLE trials ADD COLUMN duration_s REAL",  // NULL: before schema 4
       "ALTER TABLE trials ADD COLUMN points REAL",
       "CREATE UNIQUE INDEX trials_by_uid ON trials (uid)",
       "CREATE INDEX trials_by_trainee ON trials (trainee_id, scenario_id, device_kind)",
       "CREATE TABLE open_trials ("
       "uid TEXT PRIMARY KEY, "
       "started_utc TEXT NOT NULL, "
       "curriculum_id TEXT NOT NULL, "
       "scenario_id TEXT NOT NULL, "
       "device_kind TEXT NOT NULL, "
       "log_path TEXT NOT NULL, "
       "station TEXT NOT NULL, "
       "trainee_id INTEGER REFERENCES people (id), "
       "module_id TEXT NOT NULL)",
       // By the names of score/figures.h; a figure that a trial has none of has no row.
       "CREATE TABLE figures ("
       "trial_id INTEGER NOT NULL REFERENCES trials (id), "
       "name TEXT NOT NULL, "
       "value REAL NOT NULL, "
       "PRIMARY KEY (trial_id, name))",
       // What older rows have of them, so that a learning curve begins where the learning began.
       "INSERT INTO figures (trial_id, name, value) SELECT id, 'passed', passed FROM trials",
       "INSERT INTO figures (trial_id, name, value) SELECT id, 'attempt_time_s', attempt_time_s FROM trials "
       "WHERE attempt_time_s > 0",
       "INSERT INTO figures (trial_id, name, value) SELECT id, 'time_to_trachea_visible_s', time_to_trachea_visible_s "
       "FROM trials WHERE time_to_trachea_visible_s IS NOT NULL",
       "INSERT INTO figures (trial_id, name, value) SELECT id, 'glottis_visible_max_percent', "
       "glottis_visible_max_percent FROM trials",
       "INSERT INTO figures (trial_id, name, value) SELECT id, 'peak_tongue_force_n', peak_tongue_force_n FROM trials",
       "INSERT INTO figures (trial_id, name, value) SELECT id, 'peak_gum_force_n', peak_gum_force_n FROM trials",
       "INSERT INTO figures (trial_id, name, value) SELECT id, 'time_over_target_s', time_over_target_s FROM trials",
       "INSERT INTO figures (trial_id, name, value) SELECT id, 'time_over_force_limit_s', time_over_force_limit_s "
       "FROM trials",
       "INSERT INTO figures (trial_id, name, value) SELECT id, 'lowest_spo2_percent', lowest_spo2_percent FROM trials "
       "WHERE lowest_spo2_percent IS NOT NULL",
       "CREATE TABLE ratings ("
       "id INTEGER PRIMARY KEY AUTOINCREMENT, "
       "trial_id INTEGER NOT NULL REFERENCES trials (id), "
       "rater TEXT NOT NULL CHECK (rater IN ('self', 'instructor')), "
       "author_id INTEGER REFERENCES people (id), "  // NULL: nobody was signed in, or the author was deleted
       "item TEXT NOT NULL, "
       "value REAL NOT NULL, "
       "at_utc TEXT NOT NULL)",
       "CREATE INDEX ratings_by_trial ON ratings (trial_id)",
       "CREATE TABLE notes ("
       "id INTEGER PRIMARY KEY AUTOINCREMENT, "
       "trial_id INTEGER NOT NULL REFERENCES trials (id), "
       "author_id INTEGER REFERENCES people (id), "  // NULL: nobody was signed in, or the author was deleted
       "at_s REAL NOT NULL, "
       "text TEXT NOT NULL, "
       "written_utc TEXT NOT NULL)",
       "CREATE INDEX notes_by_trial ON notes (trial_id)",
       // Trials whose statements a learning record store has, or refused for a reason; one without a row is to be sent.
       "CREATE TABLE deliveries ("
       "trial_id INTEGER PRIMARY KEY REFERENCES trials (id), "
       "refused TEXT NOT NULL, "  // why; empty: it has them
       "at_utc TEXT NOT NULL)",
       "CREATE TABLE about (name TEXT PRIMARY KEY, value TEXT NOT NULL)",  // of these records: 'uid'
       "CREATE TABLE files_to_delete ("
       "id INTEGER PRIMARY KEY AUTOINCREMENT, "
       "station TEXT NOT NULL, "
       "log_path TEXT NOT NULL, "
       "log_sha256 TEXT NOT NULL)",
       "CREATE TABLE audit ("
       "id INTEGER PRIMARY KEY AUTOINCREMENT, "
       "at_utc TEXT NOT NULL, "
       "actor_id INTEGER, "  // no reference: it outlives the person
       "action TEXT NOT NULL, "
       "subject_id INTEGER)",
       {"CREATE TRIGGER audit_is_not_edited BEFORE UPDATE ON audit "
        "BEGIN SELECT RAISE(ABORT, 'the audit trail is append only'); END",
        "CREATE FUNCTION audit_is_append_only() RETURNS trigger LANGUAGE plpgsql AS "
        "$$ BEGIN RAISE EXCEPTION 'the audit trail is append only'; END $$"},
       {"CREATE TRIGGER audit_is_not_deleted BEFORE DELETE ON audit "
        "BEGIN SELECT RAISE(ABORT, 'the audit trail is append only'); END",
        "CREATE TRIGGER audit_is_not_changed BEFORE UPDATE OR DELETE OR TRUNCATE ON audit "
        "FOR EACH STATEMENT EXECUTE FUNCTION audit_is_append_only()"}},
      // Why a trial counts neither way, a line each; empty: it counts.
      {"ALTER TABLE trials ADD COLUMN set_aside TEXT NOT NULL DEFAULT ''"},
  };
  return steps;
}

QString in_dialect(const Statement& statement, Dialect dialect) {
  if (dialect == Dialect::sqlite) return statement.sqlite;
  if (statement.postgres != nullptr) return statement.postgres;
  QString sql(statement.sqlite);
  sql.replace("INTEGER PRIMARY KEY AUTOINCREMENT", "BIGINT GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY");
  sql.replace(" INTEGER", " BIGINT");  // SQLite's has 64 bits
  sql.replace(" REAL", " DOUBLE PRECISION");
  return sql;
}

void migrate(Connection& connection) {
  const auto& steps = record_migrations();
  const auto newest = static_cast<long long>(steps.size());
  connection.write([&] {
    if (connection.dialect() == Dialect::postgres)
      connection.run(QString("SELECT pg_advisory_xact_lock(%1)").arg(kMigrationLock), {}, kNotMigrated);
    connection.run(
        in_dialect("CREATE TABLE IF NOT EXISTS schema_version (version INTEGER NOT NULL)", connection.dialect()));
    if (single_number(connection, "SELECT COUNT(*) FROM schema_version") == 0)
      connection.run("INSERT INTO schema_version (version) VALUES (0)");
    const long long found = single_number(connection, "SELECT version FROM schema_version");
    if (found < 0 || found > newest) {
      throw RecordsError("records " + connection.location().shown() + ": has schema " + std::to_string(found) +
                         ", this version knows up to " + std::to_string(newest) +
                         "; use the newer Vallecula that wrote it, or another " +
                         (connection.location().server() ? "database" : "file"));
    }
    for (long long version = found; version < newest; ++version) {
      for (const Statement& statement : steps[static_cast<std::size_t>(version)])
        connection.run(in_dialect(statement, connection.dialect()), {}, kNotMigrated);
    }
    if (found != newest) connection.run(QString("UPDATE schema_version SET version = %1").arg(newest));
  });
}

}  // namespace vallecula::curricula
