// The records' schema, step by step (private to the library).
#pragma once

#include <QString>
#include <vector>

#include "curricula/records/connection.h"

namespace vallecula::curricula {

/// One statement in SQLite's words. Types and keys are put into PostgreSQL's by in_dialect(); what is said quite
/// otherwise there has its own text.
struct Statement {
  Statement(const char* in_sqlite, const char* in_postgres = nullptr)  // NOLINT: a text is a statement
      : sqlite(in_sqlite), postgres(in_postgres) {}
  const char* sqlite;
  const char* postgres;  ///< null: translated
};

/// Step i brings schema version i to i + 1: SQL statements run in one transaction. A step that has been in use is never
/// edited; a change is a new step at the end.
const std::vector<std::vector<Statement>>& record_migrations();

QString in_dialect(const Statement& statement, Dialect dialect);

/// Brings the database to the newest schema. Everything in one transaction that shuts other writers out: two programs
/// that start together do not both migrate, and a failure leaves the database as it was. Throws RecordsError, also for
/// a schema of the future.
void migrate(Connection& connection);

}  // namespace vallecula::curricula
