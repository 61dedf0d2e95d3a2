// The records' schema, step by step (private to the library).
#pragma once

#include <vector>

namespace vallecula::curricula {

/// Step i brings schema version i to i + 1: SQL statements run in one transaction. A step that has been in use is never
/// edited; a change is a new step at the end.
inline const std::vector<std::vector<const char*>>& record_migrations() {
  static const std::vector<std::vector<const char*>> steps = {
      {"CREATE TABLE trials ("
       "id INTEGER PRIMARY KEY AUTOINCREMENT, "
       "finished_utc TEXT NOT NULL, "
       "curriculum_id TEXT NOT NULL, "
       "scenario_id TEXT NOT NULL, "
       "device_kind TEXT NOT NULL, "
       "trial_path TEXT NOT NULL, "
       "complete INTEGER NOT NULL, "
       "passed INTEGER NOT NULL, "
       "reasons TEXT NOT NULL, "  // JSON array
       "peak_tongue_force_n REAL NOT NULL, "
       "time_of_peak_tongue_force_s REAL NOT NULL, "
       "time_to_trachea_visible_s REAL, "  // NULL: never in sight
       "glottis_visible_max_percent REAL NOT NULL, "
       "peak_gum_force_n REAL NOT NULL, "
       "time_of_peak_gum_force_s REAL NOT NULL, "
       "attempt_time_s REAL NOT NULL, "
       "attempt_start_s REAL NOT NULL, "
       "time_over_force_limit_s REAL NOT NULL, "
       "time_over_target_s REAL NOT NULL, "
       "loop_rate_hz REAL NOT NULL, "
       "deadline_misses INTEGER NOT NULL, "
       "ticks INTEGER NOT NULL)"},
      {"CREATE INDEX trials_by_time ON trials (finished_utc)"},
      {"ALTER TABLE trials ADD COLUMN outcome TEXT",  // NULL: a trial without an intubation
       "ALTER TABLE trials ADD COLUMN lowest_spo2_percent REAL"},
  };
  return steps;
}

}  // namespace vallecula::curricula
