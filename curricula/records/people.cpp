#include "curricula/records/people.h"

#include <QTextCodec>
#include <cmath>

#include "curricula/records/audit.h"
#include "curricula/records/connection.h"
#include "curricula/records/permissions.h"
#include "curricula/records/pin.h"

namespace vallecula::curricula {
namespace {

constexpr int kLongestName = 100;

/// As it is kept: without spaces around it. Not in a message: messages name nobody.
QString checked_name(const std::string& name) {
  QTextCodec::ConverterState state;
  const QString text =
      QTextCodec::codecForName("UTF-8")->toUnicode(name.data(), static_cast<int>(name.size()), &state).trimmed();
  bool good = state.invalidChars == 0 && state.remainingChars == 0 && !text.isEmpty() && text.size() <= kLongestName;
  for (const QChar c : text) good = good && c.category() != QChar::Other_Control;
  if (!good) throw RecordsError("a name or pseudonym has 1 to 100 characters on one line; choose another");
  return text;
}

std::string seconds(double s) { return std::to_string(static_cast<long long>(std::ceil(s))) + " s"; }

constexpr const char* kNoSuchPerson = "there is no such person; look at the list again";

void set_pin(Connection& connection, long long id, const std::string& hash) {
  if (connection
          .run("UPDATE people SET pin_hash = ?, wrong_pins = 0, wait_ms = 0 WHERE id = ?", {bound(hash), bound_id(id)})
          .numRowsAffected() == 0)
    throw RecordsError(kNoSuchPerson);
}

}  // namespace

bool People::has_instructor() const {
  bool any = false;
  Connection& connection = records_.connection();
  connection.read([&] {
    any =
        connection.run("SELECT id FROM people WHERE role = 'instructor' LIMIT 1", {}, Connection::kCannotBeRead).next();
  });
  return any;
}

/// Within a transaction.
long long People::create(Role role, const std::string& name, const std::string& hash, long long actor,
                         const char* action) {
  Connection& connection = records_.connection();
  connection.lock_table("people");
  const QString kept = checked_name(name);
  QSqlQuery taken =
      connection.run("SELECT id, pin_hash FROM people WHERE name = ?", {kept}, Connection::kCannotBeRead);
  if (taken.next()) {
    // Salted anew for each call: it is this one's, done again because the answer alone was lost.
    if (taken.value(1).toString().toStdString() == hash) return taken.value(0).toLongLong();
    throw RecordsError("this name is taken; choose another, or a pseudonym");
  }
  QSqlQuery query = connection.run(
      "INSERT INTO people (role, name, pin_hash, created_utc) VALUES (?, ?, ?, ?) RETURNING id",
      {QString(role == Role::instructor ? "instructor" : "trainee"), kept, bound(hash), connection.now_utc()});
  query.next();
  const long long id = query.value(0).toLongLong();
  add_to_audit(connection, actor == 0 ? id : actor, action, id);
  return id;
}

SignedIn People::create_first_instructor(const std::string& name, const std::string& pin) {
  const std::string hash = hash_pin(pin);
  long long id = 0;
  records_.connection().write([&] {
    records_.connection().lock_table("people");
    const bool own =  // made by this call, whose answer was lost
        records_.connection()
            .run("SELECT id FROM people WHERE pin_hash = ?", {bound(hash)}, Connection::kCannotBeRead)
            .next();
    if (has_instructor() && !own)
      throw NotAllowed("there is an instructor already; an instructor must sign in to create another");
    id = create(Role::instructor, name, hash, 0, "first instructor created");
  });
  return SignedIn(id);
}

long long People::create_instructor(const SignedIn& instructor, const std::string& name, const std::string& pin) {
  const std::string hash = hash_pin(pin);
  long long id = 0;
  records_.connection().write([&] {
    require_instructor(records_.connection(), instructor);
    id = create(Role::instructor, name, hash, instructor.id(), "instructor created");
  });
  return id;
}

long long People::register_trainee(const std::string& name, const std::string& pin) {
  const std::string hash = hash_pin(pin);
  long long id = 0;
  records_.connection().write([&] { id = create(Role::trainee, name, hash, 0, "trainee registered"); });
  return id;
}

std::vector<Person> People::list() const {
  std::vector<Person> people;
  Connection& connection = records_.connection();
  connection.read([&] {
    people.clear();
    QSqlQuery query = connection.run("SELECT id, role, name, created_utc FROM people ORDER BY name, id", {},
                                     Connection::kCannotBeRead);
    while (query.next()) {
      people.push_back({query.value(0).toLongLong(),
                        query.value(1).toString() == "instructor" ? Role::instructor : Role::trainee,
                        query.value(2).toString().toStdString(), query.value(3).toString().toStdString()});
    }
  });
  return people;
}

SignedIn People::sign_in(long long id, const std::string& pin) {
  Connection& connection = records_.connection();
  std::string hash;
  double waits_s = 0.0, next_wait_s = 0.0;
  connection.write([&] {
    QSqlQuery query = connection.run(
        "SELECT pin_hash, wrong_pins, wait_ms, wait_from_ms FROM people WHERE id = ?" + connection.for_update(),
        {bound_id(id)}, Connection::kCannotBeRead);
    if (!query.next()) throw RecordsError(kNoSuchPerson);
    hash = query.value(0).toString().toStdString();
    int wrong = query.value(1).toInt();
    PinWait wait{query.value(2).toLongLong(), query.value(3).toLongLong()};
    query.finish();
    const long long now = connection.now_ms();
    waits_s = 1e-3 * static_cast<double>(remaining_ms(wait, now));
    if (waits_s == 0.0) {
      ++wrong;
      wait = {wait_after_ms(wrong), now};
      next_wait_s = 1e-3 * static_cast<double>(wait.wait_ms);
    }
    connection.run("UPDATE people SET wrong_pins = ?, wait_ms = ?, wait_from_ms = ? WHERE id = ?",
                   {wrong, static_cast<qlonglong>(wait.wait_ms), static_cast<qlonglong>(wait.from_ms), bound_id(id)});
  });
  if (waits_s > 0.0)
    throw PinRefused("too many wrong PINs; wait " + seconds(waits_s) + ", or ask an instructor for a new PIN", waits_s);
  const bool right = pin_matches(hash, pin);
  connection.write([&] {
    // Only for the hash that was looked at: a PIN reset meanwhile ends the old one.
    if (right && connection
                         .run("UPDATE people SET wrong_pins = 0, wait_ms = 0 WHERE id = ? AND pin_hash = ?",
                              {bound_id(id), bound(hash)})
                         .numRowsAffected() == 0)
      throw PinRefused("the PIN was changed just now; give the new one", 0.0);
    add_to_audit(connection, right ? id : 0,
                 right               ? "signed in"
                 : next_wait_s > 0.0 ? "wrong PIN, must wait"
                                     : "wrong PIN",
                 id);
  });
  if (!right)
    throw PinRefused(next_wait_s > 0.0 ? "the PIN is wrong; the next try is in " + seconds(next_wait_s)
                                       : std::string("the PIN is wrong; try again"),
                     next_wait_s);
  return SignedIn(id);
}

void People::change_pin(const SignedIn& who, const std::string& old_pin, const std::string& new_pin) {
  const std::string hash = hash_pin(new_pin);
  sign_in(who.id(), old_pin);
  Connection& connection = records_.connection();
  connection.write([&] {
    set_pin(connection, who.id(), hash);
    add_to_audit(connection, who.id(), "PIN changed", who.id());
  });
}

void People::reset_pin(const SignedIn& instructor, long long id, const std::string& new_pin) {
  const std::string hash = hash_pin(new_pin);
  Connection& connection = records_.connection();
  connection.write([&] {
    require_instructor(connection, instructor);
    set_pin(connection, id, hash);
    add_to_audit(connection, instructor.id(), "PIN reset", id);
  });
}

void People::rename(const SignedIn& who, long long id, const std::string& name) {
  const QString kept = checked_name(name);
  Connection& connection = records_.connection();
  connection.write([&] {
    require_own_or_instructor(connection, who, id);
    connection.lock_table("people");
    if (connection
            .run("SELECT id FROM people WHERE name = ? AND id <> ?", {kept, bound_id(id)}, Connection::kCannotBeRead)
            .next())
      throw RecordsError("this name is taken; choose another, or a pseudonym");
    if (connection.run("UPDATE people SET name = ? WHERE id = ?", {kept, bound_id(id)}).numRowsAffected() == 0)
      throw RecordsError(kNoSuchPerson);
    add_to_audit(connection, who.id(), "renamed", id);
  });
}

std::vector<AuditEntry> People::audit(const SignedIn& instructor, int count) const {
  std::vector<AuditEntry> entries;
  Connection& connection = records_.connection();
  connection.read([&] {
    entries.clear();
    require_instructor(connection, instructor);
    QSqlQuery query =
        connection.run("SELECT id, at_utc, actor_id, action, subject_id FROM audit ORDER BY id DESC LIMIT ?",
                       {count > 0 ? count : 0}, Connection::kCannotBeRead);
    while (query.next()) {
      entries.push_back({query.value(0).toLongLong(), query.value(1).toString().toStdString(),
                         query.value(2).toLongLong(), query.value(3).toString().toStdString(),
                         query.value(4).toLongLong()});
    }
  });
  return entries;
}

}  // namespace vallecula::curricula
