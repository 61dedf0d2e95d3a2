// The table of one trial's ticks for other programs.
#pragma once

#include <string>

#include "curricula/trial_log.h"

namespace vallecula::curricula {

/// RFC 4180, a header line first, one row a servo tick; columns of an intubation only where the log has one, and a
/// quantity that is not sampled in a tick is empty. The log knows no trainee.
std::string ticks_csv(const TrialLog& log);
/// Its columns as a Markdown table.
std::string tick_column_table();

}  // namespace vallecula::curricula
