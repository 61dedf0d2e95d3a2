#include "curricula/records/notes.h"

#include <QTextCodec>
#include <optional>

#include "curricula/records/audit.h"
#include "curricula/records/note_rows.h"
#include "curricula/records/permissions.h"

namespace vallecula::curricula {
namespace {

constexpr std::size_t kLongestNote = 10'000;
constexpr double kLongestTrialS = 24.0 * 3600.0;

/// Whose trial it is; 0: nobody's.
long long trainee_of(Connection& connection, long long trial_id) {
  QSqlQuery query =
      connection.run("SELECT trainee_id FROM trials WHERE id = ?", {bound_id(trial_id)}, Connection::kCannotBeRead);
  if (!query.next()) throw RecordsError("there is no trial " + std::to_string(trial_id) + " in the records");
  return query.value(0).toLongLong();
}

}  // namespace

std::vector<Note> note_rows(Connection& connection, const QString& where, const QVariantList& values) {
  std::vector<Note> notes;
  connection.read([&] {
    notes.clear();
    QSqlQuery query =
        connection.run("SELECT id, trial_id, author_id, at_s, text, written_utc FROM notes WHERE " + where, values,
                       Connection::kCannotBeRead);
    while (query.next()) {
      notes.push_back({query.value(0).toLongLong(), query.value(1).toLongLong(), query.value(2).toLongLong(),
                       query.value(3).toDouble(), query.value(4).toString().toStdString(),
                       query.value(5).toString().toStdString()});
    }
  });
  return notes;
}

long long Notes::add(const Who& who, long long trial_id, double at_s, const std::string& text) {
  if (!(at_s >= 0.0 && at_s <= kLongestTrialS))
    throw RecordsError("a note stands at a second of the trial, 0 or later; choose another");
  QTextCodec::ConverterState state;
  const QString kept = QTextCodec::codecForName("UTF-8")->toUnicode(text.data(), static_cast<int>(text.size()), &state);
  if (text.empty() || text.size() > kLongestNote || state.invalidChars + state.remainingChars > 0 ||
      kept.contains(QChar(0)))
    throw RecordsError("a note has 1 to 10000 bytes of UTF-8 text; shorten or correct it");
  long long id = 0;
  std::optional<qlonglong> newest;  ///< before this one, when it was first tried
  Connection& connection = records_.connection();
  connection.write([&] {
    if (newest) {  // done again: it is there where the answer alone was lost
      QSqlQuery own = connection.run(
          "SELECT id FROM notes WHERE id > ? AND trial_id = ? AND COALESCE(author_id, 0) = ? AND at_s = ? AND text = ?",
          {*newest, bound_id(trial_id), static_cast<qlonglong>(who ? who->id() : 0), at_s, kept},
          Connection::kCannotBeRead);
      if (own.next()) {
        id = own.value(0).toLongLong();
        return;
      }
    } else {
      QSqlQuery last = connection.run("SELECT COALESCE(MAX(id), 0) FROM notes", {}, Connection::kCannotBeRead);
      last.next();
      newest = last.value(0).toLongLong();
    }
    require_own_or_instructor(connection, who, trainee_of(connection, trial_id));
    QSqlQuery query = connection.run(
        "INSERT INTO notes (trial_id, author_id, at_s, text, written_utc) VALUES (?, ?, ?, ?, ?) RETURNING id",
        {bound_id(trial_id), bound_id(who ? who->id() : 0), at_s, kept, connection.now_utc()});
    query.next();
    id = query.value(0).toLongLong();
  });
  return id;
}

std::vector<Note> Notes::of_trial(const Who& who, long long trial_id) const {
  Connection& connection = records_.connection();
  std::vector<Note> notes;
  connection.read([&] {
    require_own_or_instructor(connection, who, trainee_of(connection, trial_id));
    notes = note_rows(connection, "trial_id = ? ORDER BY at_s, id", {bound_id(trial_id)});
  });
  return notes;
}

long long Notes::trial_of_log(const std::string& sha256) const {
  if (sha256.empty()) return 0;  // as in rows older than the column
  long long id = 0;
  records_.connection().read([&] {
    QSqlQuery query = records_.connection().run("SELECT id FROM trials WHERE log_sha256 = ? ORDER BY id DESC LIMIT 1",
                                                {bound(sha256)}, Connection::kCannotBeRead);
    id = query.next() ? query.value(0).toLongLong() : 0;
  });
  return id;
}

void Notes::remove(const Who& who, long long note_id) {
  Connection& connection = records_.connection();
  connection.write([&] {
    const std::vector<Note> found = note_rows(connection, "id = ?", {bound_id(note_id)});
    if (found.empty()) throw RecordsError("there is no such note any more");
    const long long author = found[0].author_id;
    // A note whose author is not known is as much the trial's owner's as the trial is.
    require_own_or_instructor(connection, who, author != 0 ? author : trainee_of(connection, found[0].trial_id));
    connection.run("DELETE FROM notes WHERE id = ?", {bound_id(note_id)});
    add_to_audit(connection, who ? who->id() : 0, "note removed", trainee_of(connection, found[0].trial_id));
  });
}

}  // namespace vallecula::curricula
