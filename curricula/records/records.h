// The records of trials: SQLite in the user's data folder, or a PostgreSQL server that several stations share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "curricula/records/location.h"
#include "curricula/score/score.h"

namespace vallecula::curricula {

class Connection;

struct RecordRow {
  long long id = 0;
  std::string uid;           ///< as begin() gave it; empty for rows older than schema 4
  long long trainee_id = 0;  ///< 0: nobody's
  std::string started_utc;   ///< ISO 8601; empty: not known
  std::string finished_utc;  ///< ISO 8601
  std::string curriculum_id, scenario_id, device_kind, trial_path;
  std::string station;     ///< whose disk trial_path is on
  std::string log_sha256;  ///< of the file at trial_path; a later trial in the same folder has another
  std::string module_id;   ///< of the curriculum; empty: not known
  Mode mode = Mode::practice;
  std::uint32_t attempt_seed = 0;    ///< 0: everything as written
  std::optional<double> points;      ///< of 100, by the rubric's weights; nothing: not known, rows older than schema 4
  std::optional<double> duration_s;  ///< trial time; nothing: not known, rows older than schema 4
  Score score;
  /// By the names of score/figures.h, those the trial has; taken from the score when it is added.
  std::map<std::string, double> figures;
  // Of an intubation, taken from the score when it is added.
  int attempts = 0;                      ///< 0: not known, or no intubation
  std::optional<double> time_to_pass_s;  ///< in the decisive attempt
};

/// A trial under way.
struct OpenTrial {
  std::string uid;  ///< given by begin()
  std::string started_utc, curriculum_id, scenario_id, device_kind;
  std::filesystem::path log_path;  ///< NAME.vtrial, absolute; while it is written, NAME.vtrial.part
  long long trainee_id = 0;        ///< 0: nobody's
  std::string module_id{};         ///< of the curriculum
};

/// The row of a trial that was begun: everything but when it finished and what its log is like on the disk.
RecordRow row_of(const OpenTrial& trial, const TrialLog& log, const Scenario& scenario, const Score& score);

/// The connection belongs to the thread that made it. Works with and without a QCoreApplication. Several programs may
/// use one file, several stations one server at once; a writer waits for another (RecordsLocation::patience_s). What a
/// call has written is on the disk when it returns. Every call throws RecordsError with what, where and the mend.
class Records {
 public:
  explicit Records(const RecordsLocation& location);  ///< creates (folders too), migrates
  ~Records();
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;

  /// Registers a trial whose log has been created; returns its uid. From here on the trial is found again
  /// (recover_trials) whatever becomes of the program.
  std::string begin(const OpenTrial& trial);
  void moved(const std::string& uid, const std::filesystem::path& log);  ///< its log, closed, is there now
  /// The trial left nothing behind.
  void abandon(const std::string& uid);
  /// Trials of this station that were begun and have no row yet: under way in some program, or cut off.
  std::vector<OpenTrial> open_trials() const;

  /// Adds the row and takes its uid off the open trials, both or neither; returns the row's id. row.id, row.station
  /// and row.figures are not read. A uid that has its row already (another program recovered the trial, or the answer to the first try
  /// was lost) adds none. Without a uid it is a trial that was never begun here. Throws also for a time that is not ISO
  /// 8601, and when the trainee was deleted meanwhile.
  long long add(const RecordRow& row);
  /// The last `count` trials that belong to nobody, by finished_utc, newest first; those of a trainee are read by
  /// Progress. Of the score the figures of score.json's first part come back (everything up to `reasons`, and
  /// `complete`) and of an intubation outcome, lowest saturation and heart rate; `figures` has what the table of figures
  /// names, and the rest is in the trial's log.
  std::vector<RecordRow> newest(int count) const;

  Connection& connection() const { return *connection_; }  ///< for the library's other parts

 private:
  std::unique_ptr<Connection> connection_;
};

}  // namespace vallecula::curricula
