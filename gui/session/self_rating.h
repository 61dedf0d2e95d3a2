// What trainees think of their own trial before they see its score.
#pragma once

#include <optional>

#include "curricula/records/people.h"

namespace vallecula::gui {

/// Items of the records' ratings beside the global one; 0 no, 1 yes.
constexpr char kTubeInTrachea[] = "tube_in_trachea", kSureOfPlace[] = "sure_of_place";

struct SelfRating {
  int global = 0;                         ///< 1 to 5
  std::optional<bool> tube_in_trachea{};  ///< of a trial with a tube
  std::optional<bool> sure{};             ///< of that
};

/// Adds it to the trial's record; durable when it returns. The same once more is no error: the first try's answer may
/// have been lost. Not for the window's thread. Throws RecordsError.
void keep_self_rating(curricula::Records& records, const curricula::Who& who, long long record_id,
                      const SelfRating& rating);

}  // namespace vallecula::gui
