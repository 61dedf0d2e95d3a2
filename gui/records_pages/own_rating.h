// Assessments whose figures wait for the trainee's own rating, which is worth something only before they are seen.
#pragma once

#include <set>
#include <vector>

#include "curricula/records/people.h"

namespace vallecula::gui {

/// The ids of those among `rows` that `who` has to rate first: own assessments, done by hand, without an own rating.
/// Not for the window's thread. Throws RecordsError.
std::set<long long> to_rate_first(curricula::Records& records, const curricula::Who& who,
                                  const std::vector<curricula::RecordRow>& rows);

/// Takes them out of `rows`, in their order.
std::vector<curricula::RecordRow> take_out(std::vector<curricula::RecordRow>& rows, const std::set<long long>& ids);

}  // namespace vallecula::gui
