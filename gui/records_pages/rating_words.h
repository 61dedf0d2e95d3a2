// Ratings in words, as the records' pages show them.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "curricula/records/ratings.h"

namespace vallecula::gui {

QString words_of_item(const std::string& item);  ///< "Handle in left hand" of "handle_in_left_hand"

/// One line each rater: what trainees think themselves first. `reader`: the number of who reads it, whose own rating as
/// an instructor is "You". Empty: nothing was rated.
QString words_of(const std::vector<curricula::Rating>& ratings, long long reader);

}  // namespace vallecula::gui
