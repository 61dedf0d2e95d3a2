// Notes on a replay, each at a second of the trial.
#pragma once

#include <string>
#include <vector>

#include "curricula/records/people.h"

namespace vallecula::curricula {

struct Note {
  long long id = 0;
  long long trial_id = 0;
  long long author_id = 0;  ///< 0: nobody was signed in, or the author has been deleted
  double at_s = 0.0;        ///< trial time
  std::string text;
  std::string written_utc;
};

/// Uses the connection of `records`, which must outlive it. A trainee reads and writes on their own trials, instructors
/// on all, anybody on those that belong to nobody. Every call throws RecordsError, NotAllowed where it is not one's
/// own.
class Notes {
 public:
  explicit Notes(Records& records) : records_(records) {}
  /// text: 1 to 10,000 bytes of UTF-8; at_s: not negative, within 24 h.
  long long add(const Who& who, long long trial_id, double at_s, const std::string& text);
  std::vector<Note> of_trial(const Who& who, long long trial_id) const;  ///< by time in the trial
  /// The newest record of the trial whose log has this hash (log_sha256()); 0: it is in no record, and has no notes.
  long long trial_of_log(const std::string& sha256) const;
  void remove(const Who& who, long long note_id);                        ///< one's own note; an instructor any

 private:
  Records& records_;
};

}  // namespace vallecula::curricula
