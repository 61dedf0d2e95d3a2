#include "gui/records_pages/keep_ratings.h"

namespace vallecula::gui {

void keep_ratings(RecordsDesk& desk, QObject* receiver, long long trial, std::vector<curricula::Rating> ratings,
                  std::function<void()> done, std::function<void(const QString&)> failed) {
  desk.ask<bool>(
      receiver,
      [who = desk.who(), trial, ratings = std::move(ratings)](curricula::Records& records) {
        for (const curricula::Rating& rating : ratings) curricula::Ratings(records).add(who, trial, rating);
        return true;
      },
      [done = std::move(done)](bool) { done(); }, std::move(failed));
}

}  // namespace vallecula::gui
