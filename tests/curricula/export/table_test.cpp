// The tables for other programs: RFC 4180, nothing a spreadsheet would run, nobody's name unless asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <set>

#include "curricula/export/csv.h"
#include "curricula/export/tick_table.h"
#include "curricula/export/trial_table.h"
#include "curricula/score/figures.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

using Table = std::vector<std::vector<std::string>>;

/// Read by the letter of RFC 4180, without the code under test; stray bytes are failures.
Table parsed(const std::string& csv) {
  Table table(1);
  std::size_t i = 0;
  while (i < csv.size()) {
    std::string cell;
    if (csv[i] == '"') {
      for (++i; i < csv.size() && (csv[i] != '"' || csv.compare(i, 2, "\"\"") == 0); ++i)
        cell += csv[i] == '"' ? csv[i++] : csv[i];
      ++i;
    } else {
      while (i < csv.size() && csv[i] != ',' && csv[i] != '\r') {
        EXPECT_NE(csv[i], '"');
        EXPECT_NE(csv[i], '\n');
        cell += csv[i++];
      }
    }
    table.back().push_back(cell);
    if (csv.compare(i, 2, "\r\n") == 0) {
      i += 2;
      table.emplace_back();
    } else {
      EXPECT_EQ(csv[i], ',');
      ++i;
    }
  }
  EXPECT_TRUE(table.back().empty()) << "the last line has no end";
  table.pop_back();
  return table;
}

std::string at(const Table& table, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < table[0].size(); ++i)
    if (table[0][i] == column) return table[row][i];
  ADD_FAILURE() << "no column " << column;
  return {};
}

TEST(Csv, TextIsQuotedAndNoFormulaIsRun) {
  EXPECT_EQ(csv_text("plain"), "plain");
  EXPECT_EQ(csv_text("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_text("say \"ah\"\n"), "\"say \"\"ah\"\"\n\"");
  EXPECT_EQ(csv_text("=HYPERLINK(\"x\")"), "\"'=HYPERLINK(\"\"x\"\")\"");
  for (const char* formula : {"=1", "+1", "-1", "@SUM(1)", "\t=1", "\r=1"})
    EXPECT_EQ(parsed(csv_text(formula) + "\r\n")[0][0], std::string("'") + formula);
}

TEST(Csv, NumbersReadBackToTheBit) {
  for (const double value : {0.0, -0.25, 1.0 / 3.0, 1e-300, 6.02e23, 123456789.125}) {
    EXPECT_EQ(std::stod(csv_number(value)), value);
    EXPECT_EQ(csv_number(value).find(','), std::string::npos);
  }
  EXPECT_EQ(csv_number(std::nullopt), "");
  EXPECT_EQ(csv_number(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST_P(AnyRecords, TheTableOfTrialsHasEveryColumnAndFigureAndNobodysName) {
  Records records(location());
  People people(records);
  const SignedIn doctor = people.create_first_instructor("=Doctor, \"D\"", "1234");
  const long long anna = people.register_trainee("Änna", "2345"), ben = people.register_trainee("Ben", "3456");
  RecordRow row = sample("2026-05-03T10:20:30Z");
  row.trainee_id = anna;
  row.module_id = "the-view";
  row.mode = Mode::assessment;
  row.attempt_seed = 7;
  row.points = 62.5;
  row.duration_s = 40.25;
  records.add(row);
  row.trainee_id = ben;
  row.finished_utc = "2026-05-04T10:20:30Z";
  row.scenario_id = "-odd, \"id\"\r\nof old";
  row.score.intubation.emplace().outcome = Outcome::good_depth;
  records.add(row);
  row.trainee_id = 0;
  row.score.complete = false;
  records.add(row);

  const Table all = parsed(trials_csv(trials_to_export(records, doctor, {}), false));
  ASSERT_EQ(all.size(), 4u);
  for (const auto& line : all) EXPECT_EQ(line.size(), all[0].size());
  EXPECT_EQ(at(all, 1, "trainee"), std::to_string(anna));
  EXPECT_EQ(at(all, 1, "module"), "the-view");
  EXPECT_EQ(at(all, 1, "mode"), "assessment");
  EXPECT_EQ(at(all, 1, "seed"), "7");
  EXPECT_EQ(at(all, 1, "points"), "62.5");
  EXPECT_EQ(at(all, 1, "duration_s"), "40.25");
  EXPECT_EQ(at(all, 1, "complete"), "1");
  EXPECT_EQ(at(all, 1, "outcome"), "");
  EXPECT_EQ(std::stod(at(all, 1, "peak_tongue_force_n")), row.score.peak_tongue_force_n);
  EXPECT_EQ(at(all, 1, "lowest_spo2_percent"), "") << "no intubation";
  EXPECT_EQ(at(all, 2, "scenario"), "'" + row.scenario_id);
  EXPECT_EQ(at(all, 2, "outcome"), "good-depth");
  EXPECT_EQ(at(all, 3, "trainee"), "");
  EXPECT_EQ(at(all, 3, "complete"), "0");
  for (const Figure& figure : figures()) {
    const auto value = figure.value(row.score);
    EXPECT_EQ(at(all, 2, figure.name), value ? csv_number(*value) : "") << figure.name;
  }
  std::string text;
  for (const auto& line : all)
    for (const std::string& cell : line) text += cell + "|";
  EXPECT_EQ(text.find("nna"), std::string::npos);

  ExportFilter named;
  named.names = true;
  const Table names = parsed(trials_csv(trials_to_export(records, doctor, named), true));
  EXPECT_EQ(at(names, 1, "trainee_name"), "Änna");
  EXPECT_EQ(at(names, 3, "trainee_name"), "");
  ExportFilter later;
  later.since_utc = "2026-05-04";
  EXPECT_EQ(trials_to_export(records, doctor, later).size(), 2u);

  // Who may have what.
  const SignedIn as_anna = people.sign_in(anna, "2345");
  ExportFilter of_ben;
  of_ben.trainee_id = ben;
  EXPECT_EQ(trials_to_export(records, as_anna, {}).size(), 1u);
  EXPECT_EQ(trials_to_export(records, {}, {}).size(), 1u) << "those that belong to nobody";
  EXPECT_EQ(trials_to_export(records, doctor, of_ben).size(), 1u);
  EXPECT_THROW(trials_to_export(records, as_anna, of_ben), NotAllowed);
  EXPECT_THROW(trials_to_export(records, {}, of_ben), NotAllowed);
  EXPECT_THROW(trials_to_export(records, as_anna, named), NotAllowed);
  EXPECT_THROW(trials_to_export(records, {}, named), NotAllowed);
  const auto audit = people.audit(doctor, 20);
  EXPECT_EQ(std::count_if(audit.begin(), audit.end(),
                          [](const AuditEntry& line) { return line.action == "trials exported with names"; }),
            1)
      << "and none of those that were not allowed";
}

TEST(TickTable, EveryTickIsARowWithWhatTheLogHas) {
  TrialLog log;
  log.ticks.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    LogTick& t = log.ticks[i];
    t.tick = static_cast<std::int64_t>(i);
    t.time_s = 0.001 * static_cast<double>(i);
    t.loads[kLarynx].force_n = {0.0, 0.0, 1.0 / 3.0};
    t.model_force_n = {1.0, -2.0, 3.0};
  }
  log.ticks[0].step_fed = 7;
  log.ticks[0].step_used = 6;
  log.ticks[0].has_areas = true;
  log.ticks[0].loads[kTongue].area_m2 = 2.5e-05;
  log.ticks[1].has_sight = true;
  log.ticks[1].glottis_visible = 0.25;
  log.ticks[2].device_valid = false;
  log.ticks[2].state = LoggedState::lost;
  const Table plain = parsed(ticks_csv(log));
  ASSERT_EQ(plain.size(), 4u);
  EXPECT_EQ(at(plain, 2, "time_s"), "0.001");
  EXPECT_EQ(at(plain, 1, "glottis_visible"), "");
  EXPECT_EQ(at(plain, 2, "glottis_visible"), "0.25");
  EXPECT_EQ(at(plain, 3, "paused"), "1");
  EXPECT_EQ(at(plain, 3, "state"), "lost");
  EXPECT_EQ(at(plain, 1, "model_force_y_n"), "-2");
  EXPECT_EQ(std::stod(at(plain, 1, "larynx_force_z_n")), 1.0 / 3.0);
  EXPECT_EQ(at(plain, 1, "proxy_qw"), "1");
  EXPECT_EQ(at(plain, 1, "step_fed"), "7");
  EXPECT_EQ(at(plain, 1, "step_used"), "6");
  EXPECT_EQ(at(plain, 2, "device_valid") + at(plain, 3, "device_valid"), "10");
  EXPECT_EQ(at(plain, 1, "tongue_area_m2"), "2.5e-05");
  EXPECT_EQ(at(plain, 2, "tongue_area_m2"), "") << "not known is not none";

  log.header.has_intubation = true;
  for (LogTick& t : log.ticks) t.has_intubation = true;
  log.ticks[0].intubation.place = LoggedPlace::main_bronchus;
  log.ticks[0].intubation.side = 1;
  log.ticks[0].intubation.spo2 = 0.93;
  const Table tube = parsed(ticks_csv(log));
  EXPECT_GT(tube[0].size(), plain[0].size());
  EXPECT_EQ(at(tube, 1, "tip_in"), "main-bronchus");
  EXPECT_EQ(at(tube, 1, "bronchus_side"), "1");
  EXPECT_EQ(at(tube, 2, "bronchus_side"), "");
  EXPECT_EQ(at(tube, 1, "spo2"), "0.93");
  std::set<std::string> names(tube[0].begin(), tube[0].end());
  EXPECT_EQ(names.size(), tube[0].size()) << "a column twice";
}

TEST(ColumnTables, StandInTheReadme) {
  std::ifstream in(std::string(VALLECULA_SOURCE_DIR) + "/curricula/README.md");
  const std::string readme{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(readme.find(trial_column_table()), std::string::npos)
      << "put what `vallecula records columns` prints under \"Columns of the exports\" in curricula/README.md";
  EXPECT_NE(readme.find(tick_column_table()), std::string::npos)
      << "put what `vallecula records columns --ticks` prints there";
}

}  // namespace
}  // namespace vallecula::curricula::testing
