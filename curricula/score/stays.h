// The blade's ways into the mouth and out of it (private to the library).
#pragma once

#include <cstddef>
#include <vector>

#include "curricula/trial_log.h"

namespace vallecula::curricula {

/// One: from the first tick with the blade's tip in the mouth to the last. Out for less than kOutForAnEntryS is no
/// other.
struct Stay {
  std::size_t first = 0, last = 0;  ///< indices into the log's ticks
  double first_s = 0.0, last_s = 0.0;
  long long paused_at_first = 0, paused_at_last = 0;  ///< paused ticks of the trial until then
};

/// In order; none where the log lacks usable landmarks.
std::vector<Stay> stays_in_mouth(const TrialLog& log);

/// Attempts as score.h defines them: with an intubation every stay is one, without it all of them together are.
std::vector<Stay> attempts_in(const TrialLog& log);

}  // namespace vallecula::curricula
