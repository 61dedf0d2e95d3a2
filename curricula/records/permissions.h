// Who may do what, asked of the database within the transaction that does it (private to the library).
#pragma once

#include "curricula/records/people.h"

namespace vallecula::curricula {

bool is_instructor(Connection& connection, const SignedIn& who);  ///< NotAllowed when the person was deleted
void require_instructor(Connection& connection, const SignedIn& who);
/// The person themself, or an instructor; of what belongs to nobody (0), anybody.
void require_own_or_instructor(Connection& connection, const Who& who, long long person_id);

}  // namespace vallecula::curricula
