#include <algorithm>
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

/// Of what lies at the path, the files of the trial that is to be deleted: another's may be there by now.
std::vector<fs::path> files_of(Connection& connection, const Pending& one) {
  const auto other = [&](const char* table, const char* column) {
    bool found = false;
    connection.read([&] {
      found = connection
                  .run(QString("SELECT 1 FROM %1 WHERE %2 = ? AND (station = ? OR station = '')").arg(table, column),
                       {bound(one.log.string()), bound(connection.location().station)}, Connection::kCannotBeRead)
                  .next();
    });
    return found;
  };
  std::error_code error;
  const bool there = fs::exists(one.log, error);
  if (there && !one.sha256.empty() && log_sha256(one.log) != one.sha256) return {};
  std::vector<fs::path> files = files_of_trial(one.log);
  const fs::path part = one.log.string() + ".part";
  if (other("open_trials", "log_path")) {  // a later trial, which removed the rest when it began
    if (!there) return {};
    files.erase(std::remove(files.begin(), files.end(), part), files.end());
  }
  // Of an older record, or a trial that was cut off, the hash is not known; a record of the same path has the rest.
  if (there && one.sha256.empty() && other("trials", "trial_path"))
    files.erase(std::remove_if(files.begin(), files.end(), [&](const fs::path& file) { return file != part; }),
                files.end());
  return files;
}

/// What was deleted still stands in the write-ahead log until it is emptied; false: another program reads it.
bool empty_write_ahead_log(Connection& connection) {
  constexpr int kTries = 2;  // each waits as long as the connection does for a lock
  for (int i = 0; i < kTries; ++i) {
    QSqlQuery query = connection.run("PRAGMA wal_checkpoint(TRUNCATE)");
    if (query.next() && query.value(0).toInt() == 0) return true;
  }
  return false;
}

}  // namespace

Deletion delete_pending_files(Records& records) {
  Connection& connection = records.connection();
  Deletion deletion;
  std::vector<fs::path> folders;
  for (const Pending& one : pending_files(connection)) {
    std::error_code error;
    const fs::path folder = one.log.parent_path();
    if (!folder.empty() && !fs::is_directory(folder, error)) {
      deletion.left.push_back(
          "the folder of a trial is not there; connect the disk that it is on, then start again (or make the folder "
          "again, empty, if it was deleted)");
      continue;
    }
    if (is_being_written(one.log)) {
      deletion.left.push_back(one.log.string() + ": the trial is still under way");
      continue;
    }
    for (const fs::path& file : files_of(connection, one)) {
      if (fs::remove(file, error)) ++deletion.files;
      if (error) break;
    }
    if (error) {
      deletion.left.push_back(one.log.string() + ": " + error.message() + "; check the folder's permission");
      continue;
    }
    connection.write([&] { connection.run("DELETE FROM files_to_delete WHERE id = ?", {bound_id(one.id)}); });
    folders.push_back(folder);
  }
  for (const fs::path& folder : folders) {
    std::error_code not_empty;
    fs::remove(folder, not_empty);
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
  const bool emptied = connection.dialect() != Dialect::sqlite || empty_write_ahead_log(connection);
  Deletion files = delete_pending_files(records);
  deletion.files = files.files;
  deletion.left = std::move(files.left);
  if (!emptied)
    deletion.left.push_back(
        "what was deleted still stands in the records' write-ahead log, which another program reads; close the programs "
        "that use the records: the last one removes it");
  return deletion;
}

}  // namespace vallecula::curricula
