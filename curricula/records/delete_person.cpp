#include <system_error>

#include "curricula/records/audit.h"
#include "curricula/records/connection.h"
#include "curricula/records/permissions.h"
#include "curricula/records/personal_data.h"
#include "curricula/records/recovery.h"
#include "curricula/records/trial_files.h"
#include "curricula/trial_log.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;

/// Within a transaction.
void must_not_be_the_last_instructor(Connection& connection, long long person_id) {
  connection.lock_table("people");
  const auto count = [&](const char* condition, const QVariantList& values) {
    QSqlQuery query =
        connection.run(QString("SELECT COUNT(*) FROM people WHERE ") + condition, values, Connection::kCannotBeRead);
    query.next();
    return query.value(0).toInt();
  };
  if (count("id = ? AND role = 'instructor'", {bound_id(person_id)}) == 1 &&
      count("id <> ? AND role = 'instructor'", {bound_id(person_id)}) == 0 &&
      count("id <> ?", {bound_id(person_id)}) > 0)
    throw NotAllowed(
        "the last instructor cannot be deleted while there are other people; create another instructor first");
}

struct Pending {
  long long id = 0;
  fs::path log;
  std::string sha256;
};

std::vector<Pending> pending_files(Connection& connection) {
  std::vector<Pending> pending;
  connection.read([&] {
    pending.clear();
    QSqlQuery query = connection.run(
        "SELECT id, log_path, log_sha256 FROM files_to_delete WHERE station = ? OR station = '' ORDER BY id",
        {bound(connection.location().station)}, Connection::kCannotBeRead);
    while (query.next())
      pending.push_back({query.value(0).toLongLong(), query.value(1).toString().toStdString(),
                         query.value(2).toString().toStdString()});
  });
  return pending;
}

/// True when what lies at the path is no longer the trial that is to be deleted.
bool replaced(Connection& connection, const Pending& one) {
  std::error_code error;
  if (!one.sha256.empty()) return fs::exists(one.log, error) && log_sha256(one.log) != one.sha256;
  // Of an older record, or a trial that was cut off, the hash is not known: the path alone must do.
  bool others = false;
  connection.read([&] {
    others = connection
                 .run("SELECT id FROM trials WHERE trial_path = ? AND (station = ? OR station = '')",
                      {bound(one.log.string()), bound(connection.location().station)}, Connection::kCannotBeRead)
                 .next();
  });
  return others;
}

}  // namespace

Deletion delete_pending_files(Records& records) {
  Connection& connection = records.connection();
  Deletion deletion;
  for (const Pending& one : pending_files(connection)) {
    std::error_code error;
    if (!replaced(connection, one)) {
      try {
        if (close_cut_log(one.log) == CutLog::being_written) {
          deletion.left.push_back(one.log.string() + ": the trial is still under way");
          continue;
        }
      } catch (const TrialLogError&) {
        // Damaged, and to be deleted all the same.
      }
      for (const fs::path& file : files_of_trial(one.log)) {
        if (fs::remove(file, error)) ++deletion.files;
        if (error) break;
      }
      if (error) {
        deletion.left.push_back(one.log.string() + ": " + error.message() + "; check the folder's permission");
        continue;
      }
      fs::remove(one.log.parent_path(), error);  // where nothing else is in it
    }
    connection.write([&] { connection.run("DELETE FROM files_to_delete WHERE id = ?", {bound_id(one.id)}); });
  }
  return deletion;
}

Deletion delete_person(Records& records, const SignedIn& who, long long person_id) {
  Connection& connection = records.connection();
  Deletion deletion;
  connection.write([&] {
    require_own_or_instructor(connection, who, person_id);
    must_not_be_the_last_instructor(connection, person_id);
    const QVariantList person{bound_id(person_id)};
    // First in a list of its own, in the same transaction: a program cut off below has lost no file from sight.
    connection.run(
        "INSERT INTO files_to_delete (station, log_path, log_sha256) "
        "SELECT station, trial_path, log_sha256 FROM trials WHERE trainee_id = ?",
        person);
    connection.run(
        "INSERT INTO files_to_delete (station, log_path, log_sha256) "
        "SELECT station, log_path, '' FROM open_trials WHERE trainee_id = ?",
        person);
    deletion.notes =
        connection.run("DELETE FROM notes WHERE trial_id IN (SELECT id FROM trials WHERE trainee_id = ?)", person)
            .numRowsAffected();
    deletion.notes +=
        connection
            .run("DELETE FROM notes WHERE author_id IN (SELECT id FROM people WHERE id = ? AND role = 'trainee')",
                 person)
            .numRowsAffected();
    // What an instructor wrote on somebody's trial is that trainee's to keep.
    connection.run("UPDATE notes SET author_id = NULL WHERE author_id = ?", person);
    connection.run("DELETE FROM ratings WHERE trial_id IN (SELECT id FROM trials WHERE trainee_id = ?)", person);
    connection.run("UPDATE ratings SET author_id = NULL WHERE author_id = ?", person);
    connection.run("DELETE FROM deliveries WHERE trial_id IN (SELECT id FROM trials WHERE trainee_id = ?)", person);
    connection.run("DELETE FROM figures WHERE trial_id IN (SELECT id FROM trials WHERE trainee_id = ?)", person);
    deletion.trials = connection.run("DELETE FROM trials WHERE trainee_id = ?", person).numRowsAffected();
    connection.run("DELETE FROM open_trials WHERE trainee_id = ?", person);
    if (connection.run("DELETE FROM people WHERE id = ?", person).numRowsAffected() == 0)
      throw RecordsError("there is no such person; look at the list again");
    add_to_audit(connection, who.id(), "person deleted", person_id);
  });
  // What was deleted still stands in the write-ahead log until it is emptied.
  if (connection.dialect() == Dialect::sqlite) connection.run("PRAGMA wal_checkpoint(TRUNCATE)");
  Deletion files = delete_pending_files(records);
  deletion.files = files.files;
  deletion.left = std::move(files.left);
  return deletion;
}

}  // namespace vallecula::curricula
