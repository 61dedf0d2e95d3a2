#include "curricula/records/recovery.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QFile>
#include <algorithm>
#include <exception>

#include "curricula/scenario.h"
#include "curricula/trial_log.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;

/// When it ended, by its own clock from its start on: the file's time is that of the recovery.
std::string end_of(const std::string& started_utc, double recorded_s) {
  return QDateTime::fromString(QString::fromStdString(started_utc), Qt::ISODate)
      .addMSecs(static_cast<qint64>(1e3 * recorded_s))
      .toUTC()
      .toString(Qt::ISODate)
      .toStdString();
}

RecoveredTrial not_recovered(const OpenTrial& trial, const std::string& problem) {
  RecoveredTrial lost;
  lost.log = trial.log_path;
  lost.problem = problem;
  return lost;
}

/// False: its trainee was deleted while it was being recovered.
bool still_open(const Records& records, const OpenTrial& trial) {
  const std::vector<OpenTrial> open = records.open_trials();
  return std::any_of(open.begin(), open.end(), [&](const OpenTrial& one) { return one.uid == trial.uid; });
}

RecoveredTrial recover(Records& records, const OpenTrial& trial) {
  RecoveredTrial recovered;
  recovered.log = trial.log_path;
  const TrialLog log = read_trial_log(trial.log_path);
  if (!log.ticks.empty()) recovered.recorded_s = log.ticks.back().time_s;
  recovered.complete = log.footer.complete;
  const Scenario scenario = parse_scenario(log.header.scenario_yaml, trial.log_path.string());
  RecordRow row = row_of(trial, log, scenario, score_trial(log, scenario));
  row.finished_utc = end_of(trial.started_utc, recovered.recorded_s);
  row.trial_path = trial.log_path.string();
  row.log_sha256 = log_sha256(trial.log_path);
  recovered.record_id = records.add(row);
  return recovered;
}

}  // namespace

std::string log_sha256(const fs::path& file) {
  QFile in(QString::fromStdString(file.string()));
  QCryptographicHash hash(QCryptographicHash::Sha256);
  if (!in.open(QIODevice::ReadOnly) || !hash.addData(&in)) return {};
  return hash.result().toHex().toStdString();
}

std::vector<RecoveredTrial> recover_trials(Records& records) {
  std::vector<RecoveredTrial> found;
  for (const OpenTrial& trial : records.open_trials()) {
    try {
      switch (close_cut_log(trial.log_path)) {
        case CutLog::being_written:
          break;
        case CutLog::nothing:
          records.abandon(trial.uid);
          break;
        case CutLog::no_folder:
          found.push_back(not_recovered(trial,
                                        "its folder is not there; connect the disk that it is on, then start again (or "
                                        "make the folder again, empty, if it was deleted)"));
          break;
        case CutLog::whole:
        case CutLog::kept:
          found.push_back(recover(records, trial));
          break;
      }
    } catch (const RecordsError&) {
      if (still_open(records, trial)) throw;
    } catch (const std::exception& error) {
      found.push_back(not_recovered(trial, error.what()));
    }
  }
  return found;
}

}  // namespace vallecula::curricula
