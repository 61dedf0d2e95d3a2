#include "curricula/records/audit.h"

namespace vallecula::curricula {

void add_to_audit(Connection& connection, long long actor_id, const char* action, long long subject_id) {
  connection.run("INSERT INTO audit (at_utc, actor_id, action, subject_id) VALUES (?, ?, ?, ?)",
                 {connection.now_utc(), bound_id(actor_id), QString(action), bound_id(subject_id)},
                 "the audit trail cannot be written");
}

}  // namespace vallecula::curricula
