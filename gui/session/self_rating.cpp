#include "gui/session/self_rating.h"

#include "curricula/records/ratings.h"

namespace vallecula::gui {

void keep_self_rating(curricula::Records& records, const curricula::Who& who, long long record_id,
                      const SelfRating& rating) {
  curricula::Ratings ratings(records);
  const auto add = [&](const char* item, double value) { ratings.add(who, record_id, {"self", item, value}); };
  add(curricula::kGlobalRating, rating.global);
  if (rating.tube_in_trachea) add(kTubeInTrachea, *rating.tube_in_trachea ? 1.0 : 0.0);
  if (rating.sure) add(kSureOfPlace, *rating.sure ? 1.0 : 0.0);
}

}  // namespace vallecula::gui
