#include "curricula/export/trial_table.h"

#include <map>

#include "curricula/export/csv.h"
#include "curricula/records/audit.h"
#include "curricula/records/connection.h"
#include "curricula/records/permissions.h"
#include "curricula/records/trial_rows.h"
#include "curricula/score/figures.h"

namespace vallecula::curricula {
namespace {

struct TrialColumn {
  ColumnText text;
  std::string (*cell)(const ExportTrial& trial);
};

std::string whole(long long value) { return std::to_string(value); }

/// What is known of a trial before its figures.
const std::vector<TrialColumn>& first_columns() {
  static const std::vector<TrialColumn> kColumns{
      {{"trial", "", "the trial's own random id; empty in records older than schema 4", ""},
       [](const ExportTrial& t) { return csv_text(t.row.uid); }},
      {{"trainee", "", "the trainee's number, never a name; empty: nobody was signed in", ""},
       [](const ExportTrial& t) { return t.row.trainee_id == 0 ? std::string() : whole(t.row.trainee_id); }},
      {{"station", "", "random id of the computer", ""}, [](const ExportTrial& t) { return csv_text(t.row.station); }},
      {{"curriculum", "", "its id", ""}, [](const ExportTrial& t) { return csv_text(t.row.curriculum_id); }},
      {{"module", "", "its id in the curriculum; empty: not known", ""},
       [](const ExportTrial& t) { return csv_text(t.row.module_id); }},
      {{"scenario", "", "its id in the curriculum", ""},
       [](const ExportTrial& t) { return csv_text(t.row.scenario_id); }},
      {{"device_kind", "", "figures are never to be pooled across kinds", ""},
       [](const ExportTrial& t) { return csv_text(t.row.device_kind); }},
      {{"mode", "", "practice or assessment", ""},
       [](const ExportTrial& t) { return std::string(name_of(t.row.mode)); }},
      {{"seed", "", "what the attempt was drawn with; 0: as written", ""},
       [](const ExportTrial& t) { return whole(t.row.attempt_seed); }},
      {{"started_utc", "", "ISO 8601; empty: not known", ""},
       [](const ExportTrial& t) { return csv_text(t.row.started_utc); }},
      {{"finished_utc", "", "ISO 8601", ""}, [](const ExportTrial& t) { return csv_text(t.row.finished_utc); }},
      {{"duration_s", "s", "trial time; empty: not known", ""},
       [](const ExportTrial& t) { return csv_number(t.row.duration_s); }},
      {{"complete", "", "1; 0: the trial was cut off, and its figures are those up to there", ""},
       [](const ExportTrial& t) { return whole(t.row.score.complete ? 1 : 0); }},
      {{"set_aside", "",
        "1: an instructor changed it, it began at the vallecula or had no attempt, so it counts neither way; else 0",
        ""},
       [](const ExportTrial& t) { return whole(t.row.score.set_aside.empty() ? 0 : 1); }},
      {{"outcome", "", "where the tube's tip lay at the end; empty: no intubation", ""},
       [](const ExportTrial& t) {
         return t.row.score.intubation ? csv_text(name_of(t.row.score.intubation->outcome)) : std::string();
       }},
      {{"points", "", "of 100, by the rubric's weights, which nobody has validated; empty: not known", "own"},
       [](const ExportTrial& t) { return csv_number(t.row.points); }},
  };
  return kColumns;
}

const TrialColumn kName{{"trainee_name", "", "with `--names` only", ""},
                        [](const ExportTrial& t) { return csv_text(t.trainee_name); }};

/// Whose rows this person may have; within a transaction.
QString may_have(Connection& connection, const Who& who, const ExportFilter& filter, QVariantList& values) {
  if (filter.names && !who)
    throw NotAllowed("names are handed out to instructors only; an instructor must sign in");
  if (filter.names) require_instructor(connection, *who);
  if (filter.trainee_id) {
    require_own_or_instructor(connection, who, *filter.trainee_id);
    if (*filter.trainee_id == 0) return "trainee_id IS NULL";
    values << bound_id(*filter.trainee_id);
    return "trainee_id = ?";
  }
  if (!who) return "trainee_id IS NULL";
  if (is_instructor(connection, *who)) return "1 = 1";
  values << bound_id(who->id());
  return "trainee_id = ?";
}

}  // namespace

std::vector<ExportTrial> trials_to_export(Records& records, const Who& who, const ExportFilter& filter) {
  Connection& connection = records.connection();
  std::vector<ExportTrial> trials;
  connection.write([&] {  // the audit's line with what it tells of
    trials.clear();
    QVariantList values;
    QString where = may_have(connection, who, filter, values);
    const auto also = [&](const char* condition, const std::string& value) {
      if (value.empty()) return;
      where += QString(" AND ") + condition;
      values << bound(value);
    };
    also("curriculum_id = ?", filter.curriculum_id);
    also("finished_utc >= ?", filter.since_utc);
    also("finished_utc < ?", filter.until_utc);
    std::map<long long, std::string> names;
    if (filter.names) {
      QSqlQuery query = connection.run("SELECT id, name FROM people", {}, Connection::kCannotBeRead);
      while (query.next()) names[query.value(0).toLongLong()] = query.value(1).toString().toStdString();
    }
    for (RecordRow& row : trial_rows(connection, where + " ORDER BY id", values, WithFigures::yes)) {
      const std::string name = names[row.trainee_id];
      trials.push_back({std::move(row), name});
    }
    add_to_audit(connection, who ? who->id() : 0, filter.names ? "trials exported with names" : "trials exported",
                 filter.trainee_id.value_or(0));
  });
  return trials;
}

std::string trials_csv(const std::vector<ExportTrial>& trials, bool names) {
  std::vector<TrialColumn> columns = first_columns();
  if (names) columns.insert(columns.begin() + 2, kName);
  std::vector<std::string> cells;
  for (const TrialColumn& column : columns) cells.push_back(column.text.name);
  for (const Figure& figure : figures()) cells.emplace_back(figure.name);
  std::string csv = csv_line(cells);
  for (const ExportTrial& trial : trials) {
    cells.clear();
    for (const TrialColumn& column : columns) cells.push_back(column.cell(trial));
    for (const Figure& figure : figures()) {
      const auto found = trial.row.figures.find(figure.name);
      cells.push_back(found == trial.row.figures.end() ? std::string() : csv_number(found->second));
    }
    csv += csv_line(cells);
  }
  return csv;
}

std::string trial_column_table() {
  std::vector<ColumnText> all;
  for (const TrialColumn& column : first_columns()) {
    all.push_back(column.text);
    if (column.text.name == "trainee") all.push_back(kName.text);
  }
  for (const Figure& figure : figures())
    all.push_back({figure.name, figure.unit,
                   std::string(figure.definition) + (figure.for_researchers ? " (for researchers)" : ""),
                   figure.source});
  return column_table(all);
}

}  // namespace vallecula::curricula
