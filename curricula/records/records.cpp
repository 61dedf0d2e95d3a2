#include "curricula/records/records.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>
#include <atomic>

#include "curricula/records/migrations.h"

namespace vallecula::curricula {
namespace {

QString text(const std::string& s) { return QString::fromStdString(s); }

[[noreturn]] void fail(const QSqlDatabase& db, const std::string& what, const QSqlError& error,
                       const std::string& mend) {
  throw RecordsError("records " + db.databaseName().toStdString() + ": " + what + " (" +
                     error.text().trimmed().toStdString() + "); " + mend);
}

constexpr const char* kCheckFile =
    "check that the file is Vallecula's, that its folder may be written to, and the disk";

void run(QSqlQuery& query, const QSqlDatabase& db, const char* what) {
  if (!query.exec()) fail(db, what, query.lastError(), kCheckFile);
}

void run(const QSqlDatabase& db, const QString& sql, const char* what) {
  QSqlQuery query(db);
  if (!query.exec(sql)) fail(db, what, query.lastError(), kCheckFile);
}

int single_number(const QSqlDatabase& db, const QString& sql, const char* what) {
  QSqlQuery query(db);
  if (!query.exec(sql) || !query.next()) fail(db, what, query.lastError(), kCheckFile);
  return query.value(0).toInt();
}

/// Brings the file to the newest schema. Everything in one transaction that shuts other writers out: two programs that
/// start together do not both migrate, and a failure leaves the file as it was.
void migrate(const QSqlDatabase& db) {
  const auto& steps = record_migrations();
  const int newest = static_cast<int>(steps.size());
  run(db, "BEGIN IMMEDIATE", "cannot be locked for writing");
  try {
    run(db, "CREATE TABLE IF NOT EXISTS schema_version (version INTEGER NOT NULL)", "cannot be written");
    const bool fresh = single_number(db, "SELECT COUNT(*) FROM schema_version", "cannot be read") == 0;
    if (fresh) run(db, "INSERT INTO schema_version (version) VALUES (0)", "cannot be written");
    const int found = single_number(db, "SELECT version FROM schema_version", "cannot be read");
    if (found < 0 || found > newest) {
      throw RecordsError("records " + db.databaseName().toStdString() + ": has schema " + std::to_string(found) +
                         ", this version knows up to " + std::to_string(newest) +
                         "; use the newer Vallecula that wrote it, or another file");
    }
    for (int version = found; version < newest; ++version) {
      for (const char* sql : steps[static_cast<std::size_t>(version)])
        run(db, sql, "cannot be brought to the newest schema");
    }
    if (found != newest) {
      run(db, "UPDATE schema_version SET version = " + QString::number(newest), "cannot be written");
    }
    run(db, "COMMIT", "cannot be written");
  } catch (...) {
    QSqlQuery(db).exec("ROLLBACK");
    throw;
  }
}

QString reasons_to_json(const std::vector<std::string>& reasons) {
  QJsonArray list;
  for (const std::string& reason : reasons) list.append(text(reason));
  return QString::fromUtf8(QJsonDocument(list).toJson(QJsonDocument::Compact));
}

}  // namespace

Records::Records(const std::filesystem::path& database) {
  static std::atomic<unsigned> count{0};
  connection_ = "vallecula-records-" + std::to_string(count++);
  if (!QSqlDatabase::isDriverAvailable("QSQLITE")) {
    throw RecordsError("records: Qt's SQLite driver is missing; install the package libqt5sql5-sqlite");
  }
  if (!database.parent_path().empty()) {
    std::error_code error;
    std::filesystem::create_directories(database.parent_path(), error);
    if (error) {
      throw RecordsError("records " + database.string() + ": its folder cannot be made (" + error.message() +
                         "); check the permission");
    }
  }
  try {
    QSqlDatabase db = QSqlDatabase::addDatabase("QSQLITE", text(connection_));
    db.setDatabaseName(text(database.string()));
    db.setConnectOptions("QSQLITE_BUSY_TIMEOUT=5000");
    if (!db.open()) fail(db, "cannot be opened", db.lastError(), kCheckFile);
    run(db, "PRAGMA journal_mode = WAL", "cannot be opened");
    migrate(db);
  } catch (...) {
    QSqlDatabase::removeDatabase(text(connection_));
    throw;
  }
}

Records::~Records() { QSqlDatabase::removeDatabase(text(connection_)); }

long long Records::add(const RecordRow& row) {
  const QSqlDatabase db = QSqlDatabase::database(text(connection_));
  if (!QDateTime::fromString(text(row.finished_utc), Qt::ISODate).isValid()) {
    throw RecordsError("records: finished_utc '" + row.finished_utc + "' is not an ISO 8601 time");
  }
  const Score& s = row.score;
  QSqlQuery query(db);
  query.prepare(
      "INSERT INTO trials (finished_utc, curriculum_id, scenario_id, device_kind, trial_path, complete, passed, "
      "reasons, "
      "peak_tongue_force_n, time_of_peak_tongue_force_s, time_to_trachea_visible_s, glottis_visible_max_percent, "
      "peak_gum_force_n, time_of_peak_gum_force_s, attempt_time_s, attempt_start_s, time_over_force_limit_s, "
      "time_over_target_s, loop_rate_hz, deadline_misses, ticks, outcome, lowest_spo2_percent) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const std::string* field :
       {&row.finished_utc, &row.curriculum_id, &row.scenario_id, &row.device_kind, &row.trial_path}) {
    query.addBindValue(field->empty() ? QString("") : text(*field));  // a null QString would be stored as NULL
  }
  query.addBindValue(s.complete);
  query.addBindValue(s.passed);
  query.addBindValue(reasons_to_json(s.reasons));
  query.addBindValue(s.peak_tongue_force_n);
  query.addBindValue(s.time_of_peak_tongue_force_s);
  query.addBindValue(s.time_to_trachea_visible_s < 0.0 ? QVariant(QVariant::Double)
                                                       : QVariant(s.time_to_trachea_visible_s));
  query.addBindValue(s.glottis_visible_max_percent);
  query.addBindValue(s.peak_gum_force_n);
  query.addBindValue(s.time_of_peak_gum_force_s);
  query.addBindValue(s.attempt_time_s);
  query.addBindValue(s.attempt_start_s);
  query.addBindValue(s.time_over_force_limit_s);
  query.addBindValue(s.time_over_target_s);
  query.addBindValue(s.loop_rate_hz);
  query.addBindValue(static_cast<qlonglong>(s.deadline_misses));
  query.addBindValue(static_cast<qlonglong>(s.ticks));
  query.addBindValue(s.intubation ? QVariant(name_of(s.intubation->outcome)) : QVariant(QVariant::String));
  query.addBindValue(s.intubation && s.intubation->lowest_spo2_percent ? QVariant(*s.intubation->lowest_spo2_percent)
                                                                       : QVariant(QVariant::Double));
  run(query, db, "the trial could not be recorded");
  return query.lastInsertId().toLongLong();
}

std::vector<RecordRow> Records::newest(int count) const {
  const QSqlDatabase db = QSqlDatabase::database(text(connection_));
  QSqlQuery query(db);
  query.prepare("SELECT * FROM trials ORDER BY finished_utc DESC, id DESC LIMIT ?");
  query.addBindValue(count > 0 ? count : 0);
  run(query, db, "cannot be read");
  std::vector<RecordRow> rows;
  while (query.next()) {
    const auto word = [&](const char* column) { return query.value(column).toString().toStdString(); };
    const auto number = [&](const char* column) { return query.value(column).toDouble(); };
    const auto whole = [&](const char* column) { return query.value(column).toLongLong(); };
    RecordRow row;
    row.id = whole("id");
    row.finished_utc = word("finished_utc");
    row.curriculum_id = word("curriculum_id");
    row.scenario_id = word("scenario_id");
    row.device_kind = word("device_kind");
    row.trial_path = word("trial_path");
    Score& s = row.score;
    s.complete = whole("complete") != 0;
    s.passed = whole("passed") != 0;
    for (const QJsonValue& reason : QJsonDocument::fromJson(query.value("reasons").toByteArray()).array()) {
      s.reasons.push_back(reason.toString().toStdString());
    }
    s.peak_tongue_force_n = number("peak_tongue_force_n");
    s.time_of_peak_tongue_force_s = number("time_of_peak_tongue_force_s");
    const QVariant visible = query.value("time_to_trachea_visible_s");
    s.time_to_trachea_visible_s = visible.isNull() ? -1.0 : visible.toDouble();
    s.glottis_visible_max_percent = number("glottis_visible_max_percent");
    s.peak_gum_force_n = number("peak_gum_force_n");
    s.time_of_peak_gum_force_s = number("time_of_peak_gum_force_s");
    s.attempt_time_s = number("attempt_time_s");
    s.attempt_start_s = number("attempt_start_s");
    s.time_over_force_limit_s = number("time_over_force_limit_s");
    s.time_over_target_s = number("time_over_target_s");
    s.loop_rate_hz = number("loop_rate_hz");
    s.deadline_misses = whole("deadline_misses");
    s.ticks = whole("ticks");
    if (const auto outcome = outcome_named(word("outcome"))) {
      s.intubation.emplace().outcome = *outcome;
      const QVariant lowest = query.value("lowest_spo2_percent");
      if (!lowest.isNull()) s.intubation->lowest_spo2_percent = lowest.toDouble();
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace vallecula::curricula
