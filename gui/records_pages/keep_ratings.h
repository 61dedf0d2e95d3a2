// An instructor's ratings on their way into the records, wherever they were given.
#pragma once

#include <functional>
#include <vector>

#include "curricula/records/ratings.h"
#include "gui/records_pages/records_desk.h"

namespace vallecula::gui {

/// Of the trial of this row, by whoever is signed in at `desk`. `done` or `failed` with the message follow in the
/// window's thread, if `receiver` still lives.
void keep_ratings(RecordsDesk& desk, QObject* receiver, long long trial, std::vector<curricula::Rating> ratings,
                  std::function<void()> done, std::function<void(const QString&)> failed);

}  // namespace vallecula::gui
