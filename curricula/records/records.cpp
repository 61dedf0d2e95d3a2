#include "curricula/records/records.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QVariant>
#include <cmath>
#include <filesystem>

#include "curricula/qt_text.h"
#include "curricula/records/connection.h"
#include "curricula/records/migrations.h"
#include "curricula/records/random_id.h"
#include "curricula/records/trial_rows.h"
#include "curricula/score/figures.h"
#include "curricula/score/points.h"

namespace vallecula::curricula {
namespace {

QString reasons_to_json(const std::vector<std::string>& reasons) {
  QJsonArray list;
  for (const std::string& reason : reasons) list.append(text(reason));
  return QString::fromUtf8(QJsonDocument(list).toJson(QJsonDocument::Compact));
}

void must_be_a_time(const char* name, const std::string& value) {
  if (!QDateTime::fromString(text(value), Qt::ISODate).isValid())
    throw RecordsError(std::string("records: ") + name + " '" + value + "' is not an ISO 8601 time");
}

std::string lines(const std::vector<std::string>& sentences) {
  std::string all;
  for (const std::string& one : sentences) all += (all.empty() ? "" : "\n") + one;
  return all;
}

constexpr const char* kNotRecorded = "the trial could not be recorded";

long long insert_trial(Connection& connection, const RecordRow& row, const std::string& uid) {
  const Score& s = row.score;
  std::vector<std::pair<const char*, QVariant>> columns = {
      {"uid", bound(uid)},
      {"trainee_id", bound_id(row.trainee_id)},
      {"started_utc", bound(row.started_utc)},
      {"finished_utc", bound(row.finished_utc)},
      {"curriculum_id", bound(row.curriculum_id)},
      {"scenario_id", bound(row.scenario_id)},
      {"device_kind", bound(row.device_kind)},
      {"trial_path", bound(row.trial_path)},
      {"station", bound(connection.location().station)},
      {"log_sha256", bound(row.log_sha256)},
      {"module_id", bound(row.module_id)},
      {"mode", QString(name_of(row.mode))},
      {"attempt_seed", static_cast<qlonglong>(row.attempt_seed)},
      {"duration_s", bound(row.duration_s)},
      {"points", bound(row.points)},
      {"complete", static_cast<int>(s.complete)},  // PostgreSQL takes no truth value for a number
      {"passed", static_cast<int>(s.passed)},
      {"reasons", reasons_to_json(s.reasons)},
      {"set_aside", bound(lines(s.set_aside))},
      {"peak_tongue_force_n", s.peak_tongue_force_n},
      {"time_of_peak_tongue_force_s", s.time_of_peak_tongue_force_s},
      {"time_to_trachea_visible_s",
       bound(s.time_to_trachea_visible_s < 0.0 ? std::nullopt : std::optional(s.time_to_trachea_visible_s))},
      {"glottis_visible_max_percent", s.glottis_visible_max_percent},
      {"peak_gum_force_n", s.peak_gum_force_n},
      {"time_of_peak_gum_force_s", s.time_of_peak_gum_force_s},
      {"attempt_time_s", s.attempt_time_s},
      {"attempt_start_s", s.attempt_start_s},
      {"time_over_force_limit_s", s.time_over_force_limit_s},
      {"time_over_target_s", s.time_over_target_s},
      {"loop_rate_hz", s.loop_rate_hz},
      {"deadline_misses", static_cast<qlonglong>(s.deadline_misses)},
      {"ticks", static_cast<qlonglong>(s.ticks)},
  };
  if (s.intubation) {  // NULL: a trial without one
    const IntubationScore& tube = *s.intubation;
    const Attempt* decisive = tube.decisive();
    columns.emplace_back("outcome", QString(name_of(tube.outcome)));
    columns.emplace_back("lowest_spo2_percent", bound(tube.lowest_spo2_percent));
    columns.emplace_back("lowest_heart_per_min", bound(tube.lowest_heart_per_min));
    columns.emplace_back("attempts", static_cast<int>(tube.attempts.size()));
    columns.emplace_back("time_to_pass_s", bound(decisive != nullptr ? decisive->time_to_pass_s : std::nullopt));
  }
  QStringList names, marks;
  QVariantList values;
  for (const auto& [name, value] : columns) {
    names << name;
    marks << "?";
    values << value;
  }
  QSqlQuery query =
      connection.run("INSERT INTO trials (" + names.join(", ") + ") VALUES (" + marks.join(", ") + ") RETURNING id",
                     values, kNotRecorded);
  query.next();
  return query.value(0).toLongLong();
}

void insert_figures(Connection& connection, long long trial_id, const Score& score) {
  for (const Figure& figure : figures()) {
    const std::optional<double> value = figure.value(score);
    if (!value || !std::isfinite(*value)) continue;  // SQLite keeps a NaN as NULL
    connection.run("INSERT INTO figures (trial_id, name, value) VALUES (?, ?, ?)",
                   {bound_id(trial_id), QString(figure.name), *value}, kNotRecorded);
  }
}

}  // namespace

RecordRow row_of(const OpenTrial& trial, const TrialLog& log, const Scenario& scenario, const Score& score) {
  RecordRow row;
  row.uid = trial.uid;
  row.trainee_id = trial.trainee_id;
  row.started_utc = trial.started_utc;
  row.curriculum_id = trial.curriculum_id;
  row.scenario_id = trial.scenario_id;
  row.device_kind = trial.device_kind;
  row.module_id = trial.module_id;
  row.mode = scenario.attempt.mode;
  row.attempt_seed = scenario.attempt.seed;
  row.duration_s = static_cast<double>(log.ticks.size()) * log.header.servo_period_s;
  row.score = score;
  for (const MarkPoints& mark : points_of(score, scenario)) row.points = row.points.value_or(0.0) + mark.earned;
  return row;
}

Records::Records(const RecordsLocation& location) : connection_(std::make_unique<Connection>(location)) {
  migrate(*connection_);
}

Records::~Records() = default;

std::string Records::begin(const OpenTrial& trial) {
  must_be_a_time("started_utc", trial.started_utc);
  const std::string uid = random_id();
  connection_->write([&] {
    // The same uid twice: the first try was committed and its answer lost.
    connection_->run(
        "INSERT INTO open_trials (uid, started_utc, curriculum_id, scenario_id, device_kind, log_path, station, "
        "trainee_id, module_id) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (uid) DO NOTHING",
        {bound(uid), bound(trial.started_utc), bound(trial.curriculum_id), bound(trial.scenario_id),
         bound(trial.device_kind), bound(std::filesystem::absolute(trial.log_path).string()),
         bound(connection_->location().station), bound_id(trial.trainee_id), bound(trial.module_id)},
        "the trial could not be registered");
  });
  return uid;
}

void Records::moved(const std::string& uid, const std::filesystem::path& log) {
  connection_->write([&] {
    connection_->run("UPDATE open_trials SET log_path = ? WHERE uid = ?",
                     {bound(std::filesystem::absolute(log).string()), bound(uid)});
  });
}

void Records::abandon(const std::string& uid) {
  connection_->write([&] { connection_->run("DELETE FROM open_trials WHERE uid = ?", {bound(uid)}); });
}

std::vector<OpenTrial> Records::open_trials() const {
  std::vector<OpenTrial> trials;
  connection_->read([&] {
    trials.clear();
    QSqlQuery query = connection_->run("SELECT * FROM open_trials WHERE station = ? ORDER BY started_utc, uid",
                                       {bound(connection_->location().station)}, Connection::kCannotBeRead);
    while (query.next()) {
      const auto word = [&](const char* column) { return query.value(column).toString().toStdString(); };
      trials.push_back({word("uid"), word("started_utc"), word("curriculum_id"), word("scenario_id"),
                        word("device_kind"), word("log_path"), query.value("trainee_id").toLongLong(), word("module_id")});
    }
  });
  return trials;
}

long long Records::add(const RecordRow& row) {
  must_be_a_time("finished_utc", row.finished_utc);
  if (!row.started_utc.empty()) must_be_a_time("started_utc", row.started_utc);
  const std::string uid = row.uid.empty() ? random_id() : row.uid;
  long long id = 0;
  connection_->write([&] {
    QSqlQuery known = connection_->run("SELECT id FROM trials WHERE uid = ?", {bound(uid)}, Connection::kCannotBeRead);
    if (known.next()) {
      id = known.value(0).toLongLong();
      return;
    }
    if (!row.uid.empty() &&
        connection_->run("DELETE FROM open_trials WHERE uid = ?", {bound(uid)}).numRowsAffected() == 0) {
      throw RecordsError(
          "records " + connection_->location().shown() +
          ": the trial is not among those begun: its trainee was deleted meanwhile, so nothing of it is kept");
    }
    id = insert_trial(*connection_, row, uid);
    insert_figures(*connection_, id, row.score);
  });
  return id;
}

std::vector<RecordRow> Records::newest(int count) const {
  return trial_rows(*connection_, "trainee_id IS NULL ORDER BY finished_utc DESC, id DESC LIMIT ?",
                    {count > 0 ? count : 0}, WithFigures::yes);
}

namespace {

/// Of the rows that `where` found.
void read_figures(Connection& connection, const QString& where, const QVariantList& values,
                  std::vector<RecordRow>& rows) {
  std::map<long long, RecordRow*> by_id;
  for (RecordRow& row : rows) by_id[row.id] = &row;
  QSqlQuery query = connection.run(
      "SELECT trial_id, name, value FROM figures WHERE trial_id IN (SELECT id FROM trials WHERE " + where + ")", values,
      Connection::kCannotBeRead);
  while (query.next()) {
    const auto row = by_id.find(query.value(0).toLongLong());  // a trial may have come between the two
    if (row != by_id.end()) row->second->figures[query.value(1).toString().toStdString()] = query.value(2).toDouble();
  }
}

}  // namespace

std::vector<RecordRow> trial_rows(Connection& connection, const QString& where, const QVariantList& values,
                                  WithFigures with_figures) {
  std::vector<RecordRow> rows;
  connection.read([&] {
    rows.clear();
    QSqlQuery query = connection.run("SELECT * FROM trials WHERE " + where, values, Connection::kCannotBeRead);
    while (query.next()) {
      const auto word = [&](const char* column) { return query.value(column).toString().toStdString(); };
      const auto number = [&](const char* column) { return query.value(column).toDouble(); };
      const auto whole = [&](const char* column) { return query.value(column).toLongLong(); };
      RecordRow row;
      row.id = whole("id");
      row.uid = word("uid");
      row.trainee_id = whole("trainee_id");
      row.started_utc = word("started_utc");
      row.finished_utc = word("finished_utc");
      row.curriculum_id = word("curriculum_id");
      row.scenario_id = word("scenario_id");
      row.device_kind = word("device_kind");
      row.trial_path = word("trial_path");
      row.station = word("station");
      row.log_sha256 = word("log_sha256");
      row.module_id = word("module_id");
      row.mode = word("mode") == name_of(Mode::assessment) ? Mode::assessment : Mode::practice;
      row.attempt_seed = static_cast<std::uint32_t>(whole("attempt_seed"));
      const auto known = [&](const char* column) {
        return query.value(column).isNull() ? std::nullopt : std::optional(number(column));
      };
      row.duration_s = known("duration_s");
      row.points = known("points");
      Score& s = row.score;
      s.complete = whole("complete") != 0;
      s.passed = whole("passed") != 0;
      for (const QJsonValue& reason : QJsonDocument::fromJson(query.value("reasons").toByteArray()).array()) {
        s.reasons.push_back(reason.toString().toStdString());
      }
      for (const QString& why : query.value("set_aside").toString().split('\n', Qt::SkipEmptyParts))
        s.set_aside.push_back(why.toStdString());
      s.peak_tongue_force_n = number("peak_tongue_force_n");
      s.time_of_peak_tongue_force_s = number("time_of_peak_tongue_force_s");
      const QVariant visible = query.value("time_to_trachea_visible_s");
      s.time_to_trachea_visible_s = visible.isNull() ? -1.0 : visible.toDouble();
      s.glottis_visible_max_percent = number("glottis_visible_max_percent");
      s.peak_gum_force_n = number("peak_gum_force_n");
      s.time_of_peak_gum_force_s = number("time_of_peak_gum_force_s");
      s.attempt_time_s = number("attempt_time_s");
      s.attempt_start_s = number("attempt_start_s");
      s.time_over_force_limit_s = number("time_over_force_limit_s");
      s.time_over_target_s = number("time_over_target_s");
      s.loop_rate_hz = number("loop_rate_hz");
      s.deadline_misses = whole("deadline_misses");
      s.ticks = whole("ticks");
      if (const auto outcome = outcome_named(word("outcome"))) {
        s.intubation.emplace().outcome = *outcome;
        s.intubation->lowest_spo2_percent = known("lowest_spo2_percent");
        s.intubation->lowest_heart_per_min = known("lowest_heart_per_min");
        row.attempts = static_cast<int>(whole("attempts"));
        row.time_to_pass_s = known("time_to_pass_s");
      }
      rows.push_back(row);
    }
    if (with_figures == WithFigures::yes) read_figures(connection, where, values, rows);
  });
  return rows;
}

}  // namespace vallecula::curricula
