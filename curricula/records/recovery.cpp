#include "curricula/records/recovery.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QFile>
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
        case CutLog::whole:
        case CutLog::kept:
          found.push_back(recover(records, trial));
          break;
      }
    } catch (const RecordsError&) {
      throw;
    } catch (const std::exception& error) {
      RecoveredTrial lost;
      lost.log = trial.log_path;
      lost.problem = error.what();
      found.push_back(lost);
    }
  }
  return found;
}

}  // namespace vallecula::curricula
