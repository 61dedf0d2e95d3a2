#include "curricula/records/permissions.h"

#include "curricula/records/connection.h"

namespace vallecula::curricula {

bool is_instructor(Connection& connection, const SignedIn& who) {
  QSqlQuery query =
      connection.run("SELECT role FROM people WHERE id = ?", {bound_id(who.id())}, Connection::kCannotBeRead);
  if (!query.next()) throw NotAllowed("whoever was signed in has been deleted; sign in again");
  return query.value(0).toString() == "instructor";
}

void require_instructor(Connection& connection, const SignedIn& who) {
  if (!is_instructor(connection, who)) throw NotAllowed("only an instructor may do this; an instructor must sign in");
}

void require_own_or_instructor(Connection& connection, const Who& who, long long person_id) {
  if (person_id == 0) return;
  if (who && is_instructor(connection, *who)) return;
  if (!who || who->id() != person_id)
    throw NotAllowed("only the trainee concerned or an instructor may do this; one of them must sign in");
}

}  // namespace vallecula::curricula
