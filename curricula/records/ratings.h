// How well a trial went by a person's judgement, beside what the log measures: the trainee's own, and instructors'.
#pragma once

#include <string>
#include <vector>

#include "curricula/records/people.h"

namespace vallecula::curricula {

constexpr char kGlobalRating[] = "global";
constexpr double kLowestGlobal = 1.0, kHighestGlobal = 5.0;

struct Rating {
  std::string by;  ///< "self" or "instructor"
  std::string
      item;  ///< kGlobalRating (kLowestGlobal to kHighestGlobal), else a checklist item's name: 0 not done, 1 done
  double value = 0.0;
  std::string at_utc{};     ///< given by add()
  long long author_id = 0;  ///< given by add(); 0: nobody was signed in, or the author has been deleted
};

/// Uses the connection of `records`, which must outlive it. Every call throws RecordsError, NotAllowed where it is not
/// one's own. A trial is named by its row's id or by its uid, and has its row already (a finished trial has it before
/// anything is shown of it).
class Ratings {
 public:
  explicit Ratings(Records& records) : records_(records) {}
  /// "self": by the trial's trainee, of a trial that belongs to nobody by anybody; once and for all, since it is worth
  /// something only as given before the score was seen. "instructor": instructors only; an instructor's newer value
  /// takes the older one's place, each instructor has their own.
  void add(const Who& who, long long trial_id, const Rating& rating);
  void add(const Who& who, const std::string& trial_uid, const Rating& rating);
  std::vector<Rating> of_trial(const Who& who, long long trial_id) const;  ///< in the order given

 private:
  Records& records_;
};

}  // namespace vallecula::curricula
