// The audit trail: append only (the database itself refuses changes), ids, never names (private to the library).
#pragma once

#include "curricula/records/connection.h"

namespace vallecula::curricula {

/// Within the transaction that does what it tells of. actor 0: nobody was signed in.
void add_to_audit(Connection& connection, long long actor_id, const char* action, long long subject_id);

}  // namespace vallecula::curricula
