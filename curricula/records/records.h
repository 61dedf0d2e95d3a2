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
  std::string finished_utc;      ///< ISO 8601
  std::string curriculum_id, scenario_id, device_kind, trial_path;
  Score score;
};

class Records {
 public:
  explicit Records(const std::filesystem::path& database);  ///< creates and migrates; throws RecordsError
  ~Records();
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;
  long long add(const RecordRow& row);
  std::vector<RecordRow> newest(int count) const;

 private:
  std::string connection_;
};

}  // namespace vallecula::curricula
