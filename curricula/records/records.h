// The records of finished trials: SQLite in the user's data folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "curricula/score/score.h"

namespace vallecula::curricula {

class RecordsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct RecordRow {
  long long id = 0;
  std::string finished_utc;  ///< ISO 8601
  std::string curriculum_id, scenario_id, device_kind, trial_path;
  Score score;
};

/// The connection belongs to the thread that made it. Works with and without a QCoreApplication. Several programs may
/// use one file at once (write-ahead log; a writer waits up to five seconds for another).
class Records {
 public:
  explicit Records(const std::filesystem::path& database);  ///< creates (folders too), migrates; throws RecordsError
  ~Records();
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;
  /// Returns the row's new id; row.id is not read. Throws RecordsError, also for a finished_utc that is no ISO 8601
  /// time.
  long long add(const RecordRow& row);
  /// The last `count` by finished_utc, newest first. Of the score the figures of score.json's first part come back
  /// (everything up to `reasons`, and `complete`) and of an intubation outcome and lowest saturation; the rest is in the
  /// trial's log.
  std::vector<RecordRow> newest(int count) const;

 private:
  std::string connection_;
};

}  // namespace vallecula::curricula
