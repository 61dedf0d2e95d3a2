#include "curricula/records/progress.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "curricula/records/connection.h"
#include "curricula/records/permissions.h"
#include "curricula/records/trial_rows.h"

namespace vallecula::curricula {
namespace {

constexpr int kAttemptsOfAProcedure = 2;  // PMC8290971
constexpr int kInARow = 3;

/// Whose rows; NULL needs its own word in SQL.
QString of_trainee(long long trainee_id, QVariantList& values) {
  if (trainee_id == 0) return "trainee_id IS NULL";
  values << bound_id(trainee_id);
  return "trainee_id = ?";
}

/// Rows in the order they were recorded, one summary a curve.
std::vector<CurveSummary> summaries(const std::vector<RecordRow>& rows) {
  using Key = std::tuple<long long, std::string, std::string, std::string>;
  std::map<Key, std::pair<CurveSummary, std::vector<bool>>> curves;
  for (const RecordRow& row : rows) {
    auto& [curve, successes] = curves[{row.trainee_id, row.curriculum_id, row.scenario_id, row.device_kind}];
    curve.key = {row.trainee_id, row.curriculum_id, row.scenario_id, row.device_kind};
    if (curve.first_utc.empty() || row.finished_utc < curve.first_utc) curve.first_utc = row.finished_utc;
    curve.last_utc = std::max(curve.last_utc, row.finished_utc);
    if (!row.score.counts()) {
      ++(row.score.complete ? curve.set_aside : curve.interrupted);
      continue;
    }
    const bool success = procedure_succeeded(row);
    ++curve.trials;
    curve.passed += success ? 1 : 0;
    curve.passed_in_a_row = success ? curve.passed_in_a_row + 1 : 0;
    successes.push_back(success);
  }
  std::vector<CurveSummary> all;
  for (auto& [key, one] : curves) {
    one.first.cusum = cusum({}, one.second);
    one.first.to_three_in_a_row = trials_to_consecutive(one.second, kInARow);
    all.push_back(std::move(one.first));
  }
  return all;
}

/// Their rows as `rest` picks and orders them ("... ORDER BY ..."), with its values; asked for by `who`.
std::vector<RecordRow> rows_of(Records& records, const Who& who, long long trainee_id, const QString& rest,
                               const QVariantList& values = {}, WithFigures with = WithFigures::no) {
  Connection& connection = records.connection();
  std::vector<RecordRow> rows;
  connection.read([&] {
    require_own_or_instructor(connection, who, trainee_id);
    QVariantList all;
    const QString whose = of_trainee(trainee_id, all);
    rows = trial_rows(connection, whose + rest, all + values, with);
  });
  return rows;
}

}  // namespace

bool procedure_succeeded(const RecordRow& row) {
  return row.score.counts() && row.score.passed && row.attempts <= kAttemptsOfAProcedure;
}

std::vector<CurveSummary> Progress::curves(const Who& who, long long trainee_id) const {
  return summaries(rows_of(records_, who, trainee_id, " ORDER BY id"));
}

std::vector<RecordRow> Progress::curve(const Who& who, const CurveKey& key) const {
  return rows_of(records_, who, key.trainee_id,
                 " AND curriculum_id = ? AND scenario_id = ? AND device_kind = ? ORDER BY id",
                 {bound(key.curriculum_id), bound(key.scenario_id), bound(key.device_kind)}, WithFigures::yes);
}

std::vector<RecordRow> Progress::trials(const Who& who, long long trainee_id, int count) const {
  return rows_of(records_, who, trainee_id, " ORDER BY finished_utc DESC, id DESC LIMIT ?", {count > 0 ? count : 0},
                 WithFigures::yes);
}

std::map<std::string, std::vector<PastResult>> Progress::results(const Who& who, long long trainee_id) const {
  const std::vector<RecordRow> rows = rows_of(records_, who, trainee_id, " AND complete <> 0 AND set_aside = '' ORDER BY id");
  std::map<std::string, std::vector<PastResult>> results;
  for (const RecordRow& row : rows)
    results[row.curriculum_id].push_back(
        {row.scenario_id, row.device_kind, row.mode, row.score.passed, std::max(1, row.attempts)});
  return results;
}

std::vector<Day> Progress::calendar(const Who& who, long long trainee_id) const {
  const std::vector<RecordRow> rows = rows_of(records_, who, trainee_id, " ORDER BY finished_utc, id");
  std::vector<Day> days;
  for (const RecordRow& row : rows) {
    const std::string date = row.finished_utc.substr(0, 10);
    if (days.empty() || days.back().date != date) days.push_back({date, 0, 0});
    ++days.back().trials;
    days.back().passed += procedure_succeeded(row) ? 1 : 0;
  }
  return days;
}

std::vector<CurveSummary> Progress::cohort(const SignedIn& instructor, const CohortFilter& filter) const {
  Connection& connection = records_.connection();
  std::vector<RecordRow> rows;
  std::map<long long, std::string> names;
  connection.read([&] {
    require_instructor(connection, instructor);
    // Educators try their own courses; they are nobody's cohort.
    QString where = "trainee_id IN (SELECT id FROM people WHERE role = 'trainee')";
    QVariantList values;
    const auto also = [&](const char* condition, const std::string& value) {
      if (value.empty()) return;
      where += QString(" AND ") + condition;
      values << bound(value);
    };
    also("curriculum_id = ?", filter.curriculum_id);
    also("scenario_id = ?", filter.scenario_id);
    also("device_kind = ?", filter.device_kind);
    also("finished_utc >= ?", filter.since_utc);
    also("finished_utc < ?", filter.until_utc);
    rows = trial_rows(connection, where + " ORDER BY id", values);
    names.clear();
    QSqlQuery query = connection.run("SELECT id, name FROM people", {}, Connection::kCannotBeRead);
    while (query.next()) names[query.value(0).toLongLong()] = query.value(1).toString().toStdString();
  });
  std::vector<CurveSummary> all = summaries(rows);
  for (CurveSummary& curve : all) curve.trainee_name = names[curve.key.trainee_id];
  std::stable_sort(all.begin(), all.end(),
                   [](const CurveSummary& a, const CurveSummary& b) { return a.trainee_name < b.trainee_name; });
  return all;
}

}  // namespace vallecula::curricula
