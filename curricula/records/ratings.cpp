#include "curricula/records/ratings.h"

#include "curricula/records/audit.h"
#include "curricula/records/connection.h"
#include "curricula/records/permissions.h"

namespace vallecula::curricula {
namespace {

constexpr std::size_t kLongestItem = 60;

void check(const Rating& rating) {
  if (rating.by != "self" && rating.by != "instructor")
    throw RecordsError("a rating is by 'self' or by 'instructor', not by '" + rating.by + "'");
  if (rating.item.empty() || rating.item.size() > kLongestItem)
    throw RecordsError("a rating is of 'global' or of a checklist item, named in 1 to 60 characters");
  const bool good = rating.item == kGlobalRating ? rating.value >= kLowestGlobal && rating.value <= kHighestGlobal
                                                 : rating.value == 0.0 || rating.value == 1.0;
  if (!good)
    throw RecordsError("the rating of '" + rating.item + "' is " + std::to_string(rating.value) +
                       "; allowed: " + (rating.item == kGlobalRating ? "1 to 5" : "0 (not done) or 1 (done)"));
}

/// The trial and whose it is.
struct Rated {
  long long id = 0, trainee_id = 0;
};

/// Within a transaction, the trial's row held.
void add_self(Connection& connection, const Who& who, long long trial_id, const Rating& rating) {
  QSqlQuery known = connection.run("SELECT value FROM ratings WHERE trial_id = ? AND rater = 'self' AND item = ?",
                                   {bound_id(trial_id), bound(rating.item)}, Connection::kCannotBeRead);
  if (known.next()) {
    if (known.value(0).toDouble() == rating.value) return;  // the answer to the first try was lost
    throw RecordsError("the own rating of this trial has been given already, before its score was seen; it stays");
  }
  connection.run(
      "INSERT INTO ratings (trial_id, rater, author_id, item, value, at_utc) VALUES (?, 'self', ?, ?, ?, ?)",
      {bound_id(trial_id), bound_id(who ? who->id() : 0), bound(rating.item), rating.value, connection.now_utc()});
}

void add_instructors(Connection& connection, const SignedIn& who, const Rated& trial, const Rating& rating) {
  const QVariantList whose{bound_id(trial.id), bound_id(who.id()), bound(rating.item)};
  connection.run("DELETE FROM ratings WHERE trial_id = ? AND rater = 'instructor' AND author_id = ? AND item = ?",
                 whose);
  connection.run(
      "INSERT INTO ratings (trial_id, author_id, item, rater, value, at_utc) VALUES (?, ?, ?, 'instructor', ?, ?)",
      whose + QVariantList{rating.value, connection.now_utc()});
  add_to_audit(connection, who.id(), "trial rated", trial.trainee_id);
}

Rated trial_by(Connection& connection, const char* column, const QVariant& value, const QString& held) {
  QSqlQuery query = connection.run(QString("SELECT id, trainee_id FROM trials WHERE %1 = ?").arg(column) + held,
                                   {value}, Connection::kCannotBeRead);
  if (!query.next()) throw RecordsError("there is no such trial in the records; it may have been deleted");
  return {query.value(0).toLongLong(), query.value(1).toLongLong()};
}

void add_rating(Connection& connection, const Who& who, const char* column, const QVariant& value,
                const Rating& rating) {
  check(rating);
  connection.write([&] {
    // Held, so that two at once do not both find that there is no own rating yet.
    const Rated trial = trial_by(connection, column, value, connection.for_update());
    if (rating.by == "self") {
      if (trial.trainee_id != 0 && (!who || who->id() != trial.trainee_id))
        throw NotAllowed("only the trainee concerned may give the own rating; sign in");
      add_self(connection, who, trial.id, rating);
    } else {
      if (!who) throw NotAllowed("only an instructor may rate somebody's trial; an instructor must sign in");
      require_instructor(connection, *who);
      add_instructors(connection, *who, trial, rating);
    }
  });
}

}  // namespace

void Ratings::add(const Who& who, long long trial_id, const Rating& rating) {
  add_rating(records_.connection(), who, "id", bound_id(trial_id), rating);
}

void Ratings::add(const Who& who, const std::string& trial_uid, const Rating& rating) {
  add_rating(records_.connection(), who, "uid", bound(trial_uid), rating);
}

std::vector<Rating> Ratings::of_trial(const Who& who, long long trial_id) const {
  Connection& connection = records_.connection();
  std::vector<Rating> ratings;
  connection.read([&] {
    ratings.clear();
    require_own_or_instructor(connection, who, trial_by(connection, "id", bound_id(trial_id), {}).trainee_id);
    QSqlQuery query =
        connection.run("SELECT rater, item, value, at_utc, author_id FROM ratings WHERE trial_id = ? ORDER BY id",
                       {bound_id(trial_id)}, Connection::kCannotBeRead);
    while (query.next())
      ratings.push_back({query.value(0).toString().toStdString(), query.value(1).toString().toStdString(),
                         query.value(2).toDouble(), query.value(3).toString().toStdString(),
                         query.value(4).toLongLong()});
  });
  return ratings;
}

}  // namespace vallecula::curricula
