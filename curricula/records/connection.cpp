#include "curricula/records/connection.h"

#include <QDateTime>
#include <QSqlError>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "curricula/qt_text.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;

enum class Trouble { other, locked, conflict, lost, full, input_output, damaged, forbidden };

/// May be gone when it is tried again.
class Passing : public RecordsError {
 public:
  Passing(const std::string& message, Trouble which) : RecordsError(message), trouble(which) {}
  Trouble trouble;
};

/// https://www.sqlite.org/rescode.html
Trouble trouble_in_sqlite(const QSqlError& error) {
  switch (error.nativeErrorCode().toInt() & 0xff) {
    case 5:
    case 6:
      return Trouble::locked;
    case 13:
      return Trouble::full;
    case 10:
      return Trouble::input_output;
    case 11:
    case 26:
      return Trouble::damaged;
    case 3:
    case 8:
    case 14:
    case 23:
      return Trouble::forbidden;
    default:
      return Trouble::other;
  }
}

/// PostgreSQL 15, appendix A. An error without a code is the client's own: there is no connection.
Trouble trouble_in_postgres(const QSqlError& error) {
  const QString code = error.nativeErrorCode();
  if (code.isEmpty() || code.startsWith("08") || code == "57P01" || code == "57P02" || code == "57P03" ||
      code == "53300")
    return Trouble::lost;
  if (code == "40001" || code == "40P01") return Trouble::conflict;
  if (code == "55P03") return Trouble::locked;
  if (code == "53100") return Trouble::full;
  if (code == "58030") return Trouble::input_output;
  if (code.startsWith("XX")) return Trouble::damaged;
  if (code.startsWith("28") || code == "42501" || code == "25006" || code == "3D000") return Trouble::forbidden;
  return Trouble::other;
}

const char* mend(Trouble trouble, Dialect dialect) {
  const bool server = dialect == Dialect::postgres;
  switch (trouble) {
    case Trouble::locked:
      return server ? "another program holds a lock on it; try again when it is done"
                    : "another program is writing to it and does not let go; close that program, then try again";
    case Trouble::conflict:
      return "other stations were writing at the same time; try again";
    case Trouble::lost:
      return "check that the server runs and that its address in VALLECULA_RECORDS or the settings is right";
    case Trouble::full:
      return "its disk is full: free some space, then try again; what was recorded before is kept";
    case Trouble::input_output:
      return "its disk does not take it: check for a full disk, a size limit or a fault; what was recorded before is "
             "kept";
    case Trouble::damaged:
      return server
                 ? "the database is damaged: see the server's log and restore a copy"
                 : "it is damaged or not Vallecula's: put a copy in its place, or move it away and a new one is begun";
    case Trouble::forbidden:
      return server ? "check user, password, the database's name and its permissions"
                    : "check that the file and its folder may be written to";
    case Trouble::other:
      break;
  }
  return server ? "check that the database is Vallecula's, and the server's log"
                : "check that the file is Vallecula's, that its folder may be written to, and the disk";
}

/// Qt passes options on as one text; a value is quoted as libpq reads it.
QString quoted(const std::string& value) {
  QString out = text(value);
  out.replace('\\', "\\\\").replace('\'', "\\'");
  return "'" + out + "'";
}

}  // namespace

QVariant bound(const std::string& s) { return s.empty() ? QVariant(QString("")) : QVariant(text(s)); }
QVariant bound(const std::optional<double>& number) { return number ? QVariant(*number) : QVariant(QVariant::Double); }
QVariant bound_id(long long id) {
  return id == 0 ? QVariant(QVariant::LongLong) : QVariant(static_cast<qlonglong>(id));
}

Connection::Connection(const RecordsLocation& location) : location_(location) {
  static std::atomic<unsigned> count{0};
  name_ = text("vallecula-records-" + std::to_string(count++));
  const bool server = location_.server();
  const QString driver = server ? "QPSQL" : "QSQLITE";
  if (!QSqlDatabase::isDriverAvailable(driver)) {
    throw RecordsError(std::string("records: Qt's ") + (server ? "PostgreSQL" : "SQLite") +
                       " driver is missing; install the package " + (server ? "libqt5sql5-psql" : "libqt5sql5-sqlite"));
  }
  if (!location_.file.parent_path().empty()) {
    std::error_code error;
    fs::create_directories(location_.file.parent_path(), error);
    if (error) {
      throw RecordsError("records " + location_.shown() + ": its folder cannot be made (" + error.message() +
                         "); check the permission");
    }
  }
  try {
    QSqlDatabase db = QSqlDatabase::addDatabase(driver, name_);
    if (server) {
      db.setHostName(text(location_.host));
      db.setPort(location_.port);
      db.setDatabaseName(text(location_.database));
      db.setUserName(text(location_.user));
      db.setPassword(text(location_.password));
      QStringList options{"application_name=vallecula"};
      if (location_.options.count("connect_timeout") == 0) options << "connect_timeout=5";
      for (const auto& [key, value] : location_.options) options << text(key) + "=" + quoted(value);
      db.setConnectOptions(options.join(';'));
    } else {
      db.setDatabaseName(text(location_.file.string()));
      db.setConnectOptions(QString("QSQLITE_BUSY_TIMEOUT=%1").arg(static_cast<int>(500.0 * location_.patience_s)));
    }
    db = QSqlDatabase();
    repeat([this] { open(); });
  } catch (...) {
    QSqlDatabase::removeDatabase(name_);
    throw;
  }
}

Connection::~Connection() { QSqlDatabase::removeDatabase(name_); }

QSqlDatabase Connection::database() const { return QSqlDatabase::database(name_, false); }

void Connection::fail(const char* what, const QSqlError& error) const {
  const Trouble trouble = dialect() == Dialect::postgres ? trouble_in_postgres(error) : trouble_in_sqlite(error);
  QString reason = error.text().simplified();
  if (!location_.password.empty()) reason.replace(text(location_.password), "***");
  const std::string message =
      "records " + location_.shown() + ": " + what + " (" + reason.toStdString() + "); " + mend(trouble, dialect());
  if (trouble == Trouble::locked || trouble == Trouble::conflict || trouble == Trouble::lost)
    throw Passing(message, trouble);
  throw RecordsError(message);
}

void Connection::open() {
  QSqlDatabase db = database();
  if (db.isOpen()) db.close();
  constexpr const char* kWhat = "cannot be opened";
  if (!db.open()) {
    const QSqlError error = db.lastError();
    // Of a failed login the driver gives no code; only the text tells it from a server that is not there.
    const QString reason = error.text();
    if (location_.server() && (reason.contains("authentication failed") || reason.contains("does not exist") ||
                               reason.contains("no pg_hba.conf entry") || reason.contains("no password supplied")))
      fail(kWhat, QSqlError(error.driverText(), error.databaseText(), QSqlError::ConnectionError, "28000"));
    fail(kWhat, error);
  }
  was_open_ = true;
  if (location_.server()) {
    run("SET synchronous_commit = on", {}, kWhat);  // a server set to be fast loses the last trials in a power cut
    run("SET lock_timeout = '5s'", {}, kWhat);
    run("SET client_min_messages = warning", {}, kWhat);  // libpq prints notices to the terminal
  } else {
    run("PRAGMA journal_mode = WAL", {}, kWhat);
    run("PRAGMA synchronous = FULL", {}, kWhat);  // a commit is on the disk when it returns
    run("PRAGMA foreign_keys = ON", {}, kWhat);
    run("PRAGMA secure_delete = ON", {}, kWhat);  // a deleted name is not left in the file
  }
}

QSqlQuery Connection::run(const QString& sql, const QVariantList& values, const char* what) {
  QSqlQuery query(database());
  query.setForwardOnly(true);
  if (values.isEmpty()) {  // not prepared: PostgreSQL prepares no LOCK or CREATE
    if (!query.exec(sql)) fail(what, query.lastError());
    return query;
  }
  if (!query.prepare(sql)) fail(what, query.lastError());
  for (const QVariant& value : values) query.addBindValue(value);
  if (!query.exec()) fail(what, query.lastError());
  return query;
}

void Connection::repeat(const std::function<void()>& once) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(location_.patience_s);
  bool lost = false;
  for (auto pause = std::chrono::milliseconds(5);; pause = std::min(2 * pause, std::chrono::milliseconds(500))) {
    try {
      if (lost) open();
      lost = false;
      once();
      return;
    } catch (const Passing& passing) {
      lost = passing.trouble == Trouble::lost;
      if (Clock::now() >= until || (lost && !was_open_)) throw;
    }
    std::this_thread::sleep_for(pause);
  }
}

void Connection::write(const std::function<void()>& work) {
  repeat([&] {
    run(dialect() == Dialect::sqlite ? "BEGIN IMMEDIATE" : "BEGIN");
    in_write_ = true;
    try {
      work();
      in_write_ = false;
      run("COMMIT");
    } catch (...) {
      in_write_ = false;
      if (database().isOpen()) QSqlQuery(database()).exec("ROLLBACK");
      throw;
    }
  });
}

void Connection::read(const std::function<void()>& work) {
  if (in_write_)
    work();  // opened anew in between, the first half of the transaction would be lost
  else
    repeat(work);
}

void Connection::lock_table(const char* table) {
  if (dialect() == Dialect::postgres) run(QString("LOCK TABLE %1 IN EXCLUSIVE MODE").arg(table));
}

long long Connection::now_ms() {
  if (location_.clock_ms) return location_.clock_ms();
  if (dialect() == Dialect::sqlite) return QDateTime::currentMSecsSinceEpoch();
  QSqlQuery query = run("SELECT CAST(extract(epoch FROM clock_timestamp()) * 1000 AS BIGINT)", {}, kCannotBeRead);
  query.next();
  return query.value(0).toLongLong();
}

QString Connection::now_utc() { return QDateTime::fromMSecsSinceEpoch(now_ms(), Qt::UTC).toString(Qt::ISODate); }

}  // namespace vallecula::curricula
