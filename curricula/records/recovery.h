// Trials that were cut off - a killed program, a power cut - are found and kept.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "curricula/records/records.h"

namespace vallecula::curricula {

struct RecoveredTrial {
  std::filesystem::path log;
  long long record_id = 0;  ///< 0: it has none, see problem
  double recorded_s = 0.0;  ///< trial time up to the last whole block
  bool complete = false;    ///< the log had its end, only the record was missing
  std::string problem;      ///< why it could not be recovered, with the mend; empty: it was
};

/// To be called when a program starts. Of each trial that was begun on this station and whose writer is gone: the log
/// is made whole up to its last whole block (close_cut_log), scored, and gets its record, as interrupted unless it had
/// its end; one without a single tick is forgotten, one whose folder is not there waits, and is reported. Trials under way in other programs are left alone. May be cut off
/// and done again, and done by two programs at once. A log that is damaged or not readable is reported each time, and
/// kept. Throws RecordsError when the records cannot be used.
std::vector<RecoveredTrial> recover_trials(Records& records);

/// Of the file, lower-case hexadecimal; empty when it cannot be read.
std::string log_sha256(const std::filesystem::path& file);

}  // namespace vallecula::curricula
