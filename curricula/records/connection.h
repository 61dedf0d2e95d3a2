// One connection to the records, over QtSql, for both kinds of database (private to the library).
#pragma once

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QVariant>
#include <functional>
#include <optional>
#include <string>

#include "curricula/records/location.h"

namespace vallecula::curricula {

enum class Dialect { sqlite, postgres };

/// A text as the database keeps it: an empty one is empty, not NULL.
QVariant bound(const std::string& text);
QVariant bound(const std::optional<double>& number);
QVariant bound_id(long long id);  ///< 0, nobody, is NULL

class Connection {
 public:
  explicit Connection(const RecordsLocation& location);  ///< opens; throws RecordsError
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const RecordsLocation& location() const { return location_; }
  Dialect dialect() const { return location_.server() ? Dialect::postgres : Dialect::sqlite; }

  /// Runs one statement with its values. `what` completes "records NAME: ... (the database's reason); the mend".
  QSqlQuery run(const QString& sql, const QVariantList& values = {}, const char* what = "cannot be written");

  /// All of `work` or nothing; durable when it returns. No other writer comes in between in SQLite; in PostgreSQL rows
  /// read with for_update() and tables locked with lock_table() are held. Where the connection was lost or another
  /// writer got in the way, it is done again, for up to the location's patience_s: it must come to the same when its
  /// first run was committed and the answer was lost.
  void write(const std::function<void()>& work);
  /// Reads once more when the connection was lost; within write(), as part of it.
  void read(const std::function<void()>& work);
  QString for_update() const { return dialect() == Dialect::postgres ? QStringLiteral(" FOR UPDATE") : QString(); }
  void lock_table(const char* table);

  long long now_ms();  ///< since 1970, by one clock for all stations: the server's
  QString now_utc();   ///< ISO 8601, whole seconds

  static constexpr const char* kCannotBeRead = "cannot be read";

 private:
  void open();
  QSqlDatabase database() const;
  void repeat(const std::function<void()>& once);
  [[noreturn]] void fail(const char* what, const class QSqlError& error) const;

  RecordsLocation location_;
  QString name_;
  bool in_write_ = false;
  bool was_open_ = false;  ///< a server that never answered is an error at once, not something to wait for
};

}  // namespace vallecula::curricula
