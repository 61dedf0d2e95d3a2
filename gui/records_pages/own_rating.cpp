#include "gui/records_pages/own_rating.h"

#include <algorithm>

#include "curricula/records/ratings.h"

namespace vallecula::gui {

using curricula::RecordRow;

std::set<long long> to_rate_first(curricula::Records& records, const curricula::Who& who,
                                  const std::vector<RecordRow>& rows) {
  std::set<long long> ids;
  const curricula::Ratings ratings(records);
  for (const RecordRow& row : rows) {
    const bool by_hand = row.device_kind != "scripted" && row.device_kind != "recorded";
    if (!who || row.trainee_id != who->id() || !by_hand || !curricula::rules_of(row.mode).self_rating_before) continue;
    const auto given = ratings.of_trial(who, row.id);
    if (std::none_of(given.begin(), given.end(), [](const curricula::Rating& one) { return one.by == "self"; }))
      ids.insert(row.id);
  }
  return ids;
}

std::vector<RecordRow> take_out(std::vector<RecordRow>& rows, const std::set<long long>& ids) {
  const auto taken =
      std::stable_partition(rows.begin(), rows.end(), [&ids](const RecordRow& row) { return ids.count(row.id) == 0; });
  std::vector<RecordRow> out(std::make_move_iterator(taken), std::make_move_iterator(rows.end()));
  rows.erase(taken, rows.end());
  return out;
}

}  // namespace vallecula::gui
