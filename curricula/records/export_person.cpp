#include <fcntl.h>
#include <unistd.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSqlField>
#include <QSqlRecord>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "curricula/records/audit.h"
#include "curricula/records/connection.h"
#include "curricula/records/permissions.h"
#include "curricula/records/personal_data.h"
#include "curricula/records/recovery.h"
#include "curricula/records/trial_files.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;

constexpr int kExportSchema = 1;

/// Every column by its name, so that a new one is not forgotten here.
QJsonArray rows(Connection& connection, const QString& sql, const QVariantList& values) {
  QJsonArray all;
  QSqlQuery query = connection.run(sql, values, Connection::kCannotBeRead);
  while (query.next()) {
    const QSqlRecord record = query.record();
    QJsonObject row;
    for (int i = 0; i < record.count(); ++i) {
      const QVariant value = record.value(i);
      const QString name = record.fieldName(i);
      if (name == "reasons")
        row[name] = QJsonDocument::fromJson(value.toByteArray()).array();
      else
        row[name] = value.isNull() ? QJsonValue() : QJsonValue::fromVariant(value);
    }
    all.append(row);
  }
  return all;
}

/// A folder of its own beside the target, gone again with what was put into it unless it is kept.
class Aside {
 public:
  explicit Aside(const fs::path& target) : target_(target) {
    std::error_code error;
    if (fs::exists(fs::symlink_status(target, error)))
      throw RecordsError(target.string() + ": exists already; choose a new folder for the export");
    if (!target.parent_path().empty()) fs::create_directories(target.parent_path(), error);
    std::string fresh = (target.parent_path() / ".vallecula-export-XXXXXX").string();
    if (error || ::mkdtemp(fresh.data()) == nullptr)
      throw RecordsError(target.string() + ": cannot be made (" + (error ? error.message() : std::strerror(errno)) +
                         "); choose a folder you may write to");
    path_ = fresh;
  }
  ~Aside() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(path_, ignored);
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

  const fs::path& path() const { return path_; }
  void keep() {
    std::error_code error;
    fs::rename(path_, target_, error);
    if (error)
      throw RecordsError(target_.string() + ": cannot be put in place (" + error.message() +
                         "); choose another folder");
    kept_ = true;
  }

 private:
  fs::path target_, path_;
  bool kept_ = false;
};

void write_synced(const fs::path& file, const QByteArray& bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  qint64 done = 0;
  while (descriptor >= 0 && done < bytes.size()) {
    const ssize_t wrote = ::write(descriptor, bytes.constData() + done, static_cast<std::size_t>(bytes.size() - done));
    if (wrote < 0) break;
    done += wrote;
  }
  const bool good = descriptor >= 0 && done == bytes.size() && ::fsync(descriptor) == 0;
  const std::string cause = std::strerror(errno);
  if (descriptor >= 0) ::close(descriptor);
  if (!good) throw RecordsError(file.string() + ": cannot be written (" + cause + "); free some space on the disk");
}

/// Copies what a trial left; says in its row what there was.
void add_files(QJsonObject& trial, const std::string& station, const fs::path& folder) {
  const fs::path log = trial["trial_path"].toString().toStdString();
  const std::string at = trial["station"].toString().toStdString(),
                    sha256 = trial["log_sha256"].toString().toStdString();
  std::error_code error;
  QJsonArray copied;
  if (!at.empty() && at != station) {
    trial["files_missing"] = "they are on another station; export there as well";
  } else if (!fs::exists(log, error)) {
    trial["files_missing"] = "the log is not there any more";
  } else if (!sha256.empty() && log_sha256(log) != sha256) {
    trial["files_missing"] = "a later trial in the same folder has replaced the log";
  } else {
    const fs::path into = fs::path("trials") / std::to_string(trial["id"].toVariant().toLongLong());
    fs::create_directories(folder / into, error);
    for (const fs::path& file : files_of_trial(log)) {
      if (!error) fs::copy_file(file, folder / into / file.filename(), error);
      if (error)
        throw RecordsError(file.string() + ": cannot be copied into the export (" + error.message() +
                           "); free some space, or check its permission");
      copied.append(QString::fromStdString((into / file.filename()).string()));
    }
  }
  trial["files"] = copied;
}

}  // namespace

void export_person(Records& records, const SignedIn& who, long long person_id, const fs::path& folder) {
  Connection& connection = records.connection();
  const QVariantList person{bound_id(person_id)}, twice{bound_id(person_id), bound_id(person_id)};
  QJsonObject all;
  connection.write([&] {  // one view of everything, and the audit's line with it
    require_own_or_instructor(connection, who, person_id);
    const QJsonArray people = rows(connection, "SELECT id, role, name, created_utc FROM people WHERE id = ?", person);
    if (people.isEmpty()) throw RecordsError("there is no such person; look at the list again");
    all = QJsonObject{
        {"schema", kExportSchema},
        {"exported_utc", connection.now_utc()},
        {"person", people[0]},
        {"trials", rows(connection, "SELECT * FROM trials WHERE trainee_id = ? ORDER BY id", person)},
        {"trials_under_way", rows(connection, "SELECT * FROM open_trials WHERE trainee_id = ?", person)},
        {"notes",
         rows(connection,
              "SELECT * FROM notes WHERE author_id = ? OR trial_id IN (SELECT id FROM trials WHERE trainee_id = ?) "
              "ORDER BY id",
              twice)},
        {"figures",
         rows(connection,
              "SELECT * FROM figures WHERE trial_id IN (SELECT id FROM trials WHERE trainee_id = ?) "
              "ORDER BY trial_id, name",
              person)},
        {"ratings",
         rows(connection,
              "SELECT * FROM ratings WHERE author_id = ? OR trial_id IN (SELECT id FROM trials WHERE trainee_id = ?) "
              "ORDER BY id",
              twice)},
        {"deliveries",
         rows(connection,
              "SELECT * FROM deliveries WHERE trial_id IN (SELECT id FROM trials WHERE trainee_id = ?) "
              "ORDER BY trial_id",
              person)},
        {"audit", rows(connection, "SELECT * FROM audit WHERE actor_id = ? OR subject_id = ? ORDER BY id", twice)}};
    add_to_audit(connection, who.id(), "data exported", person_id);
  });
  Aside aside(folder);
  QJsonArray trials;
  for (const QJsonValue& row : all["trials"].toArray()) {
    QJsonObject trial = row.toObject();
    add_files(trial, connection.location().station, aside.path());
    trials.append(trial);
  }
  all["trials"] = trials;
  write_synced(aside.path() / "records.json", QJsonDocument(all).toJson());
  aside.keep();
}

}  // namespace vallecula::curricula
