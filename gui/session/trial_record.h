// A trial's way into the records: registered before its first tick, so that it is found again whatever happens.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "curricula/records/records.h"

namespace vallecula::gui {

/// Where the records are: $VALLECULA_RECORDS, else `records/location` in settings.ini, else records.sqlite in the
/// user's data folder. Throws std::runtime_error.
curricula::RecordsLocation records_location();

/// What became of a trial that was cut off, or of a deleted person's files: a sentence for a person.
struct Tidied {
  std::string sentence;
  std::filesystem::path log;  ///< of a trial that is kept; else empty
  std::string whole() const { return log.empty() ? sentence : sentence + ": " + log.string(); }
};

/// What a program does with the records when it starts: opens them (a database that cannot be used is named before
/// anything is practised), keeps trials that were cut off, with score and report (a QGuiApplication is needed for
/// those), deletes files of people deleted elsewhere. Throws std::runtime_error.
std::vector<Tidied> tidy_records();

/// One trial of this program. The calls may come from different threads, one at a time.
class TrialRecord {
 public:
  /// Its log has been created at trial.log_path; trial.uid and trial.started_utc are filled in here.
  void begin(curricula::OpenTrial trial);
  /// The log, closed, is at `log` now.
  void moved(const std::filesystem::path& log);
  /// The trial leaves nothing behind. Nothing is thrown: what is left open is cleared at the next start.
  void abandon() noexcept;
  /// Durable when it returns. `log` is the whole of `file`; `final_path`: where the file will be found. Returns the row's
  /// id in the records. Throws std::runtime_error.
  long long add(const curricula::TrialLog& log, const curricula::Scenario& scenario, const curricula::Score& score,
                const std::filesystem::path& file, const std::filesystem::path& final_path);

 private:
  curricula::OpenTrial trial_;
};

}  // namespace vallecula::gui
