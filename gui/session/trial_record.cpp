#include "gui/session/trial_record.h"

#include <QDateTime>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "curricula/records/personal_data.h"
#include "curricula/records/recovery.h"
#include "gui/session/trial_results.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

/// What a whole trial has beside its log. A trial before a reset has none of it, nor has the log that was kept so.
void write_missing_results(const fs::path& file) {
  std::error_code error;
  if (file.filename() != "trial.vtrial" || fs::exists(file.parent_path() / "report.html", error)) return;
  const curricula::TrialLog log = curricula::read_trial_log(file);
  const curricula::Scenario scenario = curricula::parse_scenario(log.header.scenario_yaml, file.string());
  write_results(file.parent_path(), log, scenario, curricula::score_trial(log, scenario));
}

std::string now_utc() { return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString(); }

}  // namespace

curricula::RecordsLocation records_location() {
  const char* variable = std::getenv("VALLECULA_RECORDS");
  std::string setting = variable != nullptr ? variable : "";
  if (setting.empty()) setting = user_settings()->value("records/location").toString().toStdString();
  curricula::RecordsLocation location =
      setting.empty() ? curricula::RecordsLocation(records_database()) : curricula::RecordsLocation::parse(setting);
  location.station = curricula::station_id(user_data_folder());
  return location;
}

std::vector<Tidied> tidy_records() {
  std::vector<Tidied> told;
  curricula::Records records(records_location());
  for (const curricula::RecoveredTrial& trial : curricula::recover_trials(records)) {
    if (!trial.problem.empty())
      told.push_back({"a trial that was cut off could not be kept: " + trial.problem, {}});
    else if (trial.complete)
      told.push_back({"a finished trial that was cut off from its record has it now", trial.log});
    else
      told.push_back({"a trial that was cut off is kept as interrupted, up to second " +
                          std::to_string(static_cast<long long>(std::floor(trial.recorded_s))),
                      trial.log});
    if (!trial.problem.empty()) continue;
    try {
      write_missing_results(trial.log);
    } catch (const std::exception& error) {
      told.push_back({"a trial that was cut off is kept, but has no report: " + std::string(error.what()), {}});
    }
  }
  for (const std::string& left : curricula::delete_pending_files(records).left)
    told.push_back({"a deleted person's files are still there: " + left, {}});
  return told;
}

void TrialRecord::begin(curricula::OpenTrial trial) {
  trial.started_utc = now_utc();
  trial.uid = curricula::Records(records_location()).begin(trial);
  trial_ = std::move(trial);
}

void TrialRecord::moved(const fs::path& log) { curricula::Records(records_location()).moved(trial_.uid, log); }

void TrialRecord::abandon() noexcept {
  if (trial_.uid.empty()) return;
  try {
    curricula::Records(records_location()).abandon(trial_.uid);
  } catch (const std::exception&) {
    // As told at the declaration.
  }
  trial_.uid.clear();
}

long long TrialRecord::add(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                           const curricula::Score& score, const fs::path& file, const fs::path& final_path) {
  curricula::RecordRow row = curricula::row_of(trial_, log, scenario, score);
  row.finished_utc = now_utc();
  row.trial_path = final_path;
  row.log_sha256 = curricula::log_sha256(file);
  try {
    const long long id = curricula::Records(records_location()).add(row);
    trial_.uid.clear();
    return id;
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string(error.what()) + " (the trial's results are whole, in " +
                             file.parent_path().string() + ")");
  }
}

}  // namespace vallecula::gui
