// What a trial's verdict and a figure that it has not are called for people.
#include "gui/report/figure_row.h"

#include <gtest/gtest.h>

#include <QString>
#include <algorithm>
#include <sstream>
#include <utility>

#include "gui/commands/score_table.h"
#include "gui/pages/result_figures.h"
#include "gui/report/advice.h"
#include "gui/report/report.h"

namespace vallecula::gui {
namespace {

TEST(FigureRow, ATrialThatIsNotCountedSaysSoAndWhy) {
  curricula::Score score;
  EXPECT_STREQ(verdict(score), "Not passed");
  score.passed = true;
  EXPECT_STREQ(verdict(score), "Passed");
  score.set_aside = {"The instructor closed the vocal cords"};
  EXPECT_STREQ(verdict(score), "Changed by the instructor: not counted for the course");
  score.no_attempt = true;
  EXPECT_STREQ(verdict(score), "No attempt: not counted for the course");
  score.no_attempt = false;
  score.at_vallecula = true;
  EXPECT_STREQ(verdict(score), "Practice with help: not counted for the course");
}

TEST(FigureRow, WhereTheBladeNeverEnteredTheMouthThatIsSaid) {
  TrialOutcome outcome;
  outcome.score.intubation.emplace();
  outcome.score.criteria.push_back({"lowest_spo2_percent", "%", 0.0, 80.0, -1.0, false, ""});
  curricula::Scenario scenario;
  scenario.pass.attempt_time_s = 30.0;
  const auto rows = result_figures(outcome, scenario);
  for (const char* name : {"Lowest SpO2", "Lowest heart rate", "Attempt"}) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
    ASSERT_NE(found, rows.end()) << name;
    EXPECT_EQ(found->value, "no attempt") << name;
    const std::string also = std::string(name) == "Attempt" ? "; at most 30 s" : "";
    EXPECT_EQ(found->limit, "the blade did not enter the mouth" + also) << name;
    EXPECT_EQ(found->verdict, "") << name << ": what was never tried is neither met nor missed";
  }
}

TEST(FigureRow, WhoDidNothingHasMetNoLimitWhereverTheFiguresStand) {
  TrialOutcome outcome;
  curricula::Score& score = outcome.score;
  score.intubation.emplace();
  curricula::Scenario scenario;
  scenario.pass = {6.8, 3.0, 50.0, 30.0, 3.0, 0.2};
  scenario.intubation.emplace().pass.tube_force_n = 2.0;
  curricula::TrialLog log;
  std::vector<Row> all = result_figures(outcome, scenario);
  for (const Row& row : report_rows(score, log, scenario)) all.push_back(row);
  std::ostringstream table;
  print_score(table, score, scenario);
  int forces = 0;
  for (const Row& row : all) {
    EXPECT_NE(row.verdict, "met") << row.name;
    if (row.limit.rfind("not judged: no attempt; at most ", 0) == 0) ++forces;
  }
  EXPECT_EQ(forces, 2 * 5) << "tongue, gum, over the target, over the device limit and the tube, on page and report";
  EXPECT_EQ(table.str().find("(met"), std::string::npos) << table.str();
  EXPECT_NE(table.str().find("not judged: no attempt; at most 2 N"), std::string::npos) << table.str();
  // With an attempt, however light the hand, the rubric says.
  score.attempt_begun = true;
  score.criteria = {{"peak_gum_force_n", "N", 0.0, 3.0, -1.0, true, ""}};
  all = result_figures(outcome, scenario);
  const auto gum = std::find_if(all.begin(), all.end(), [](const Row& row) { return row.name == "Peak force, gum"; });
  ASSERT_NE(gum, all.end());
  EXPECT_EQ(gum->verdict, "met");
  EXPECT_EQ(gum->limit, "at most 3 N");
}

TEST(FigureRow, WhatATubePressesOnIsTold) {
  curricula::Score score;
  score.intubation.emplace().loads_n[curricula::kTubeCricoid] = {7.0, 3.0};
  for (const Row& row : report_rows(score, {}, {})) {
    if (row.value != "cricoid 7.0 N") continue;
    EXPECT_NE(row.limit.find("no limit"), std::string::npos) << row.limit;
    EXPECT_NE(row.limit.find("narrowest ring"), std::string::npos) << row.limit;
    return;
  }
  ADD_FAILURE() << "no line of the cricoid's load";
}

TEST(FigureRow, TheAttemptsLimitStandsBesideItWhetherItWasJudgedByItOrNot) {
  curricula::Scenario scenario;
  scenario.pass.attempt_time_s = 30.0;
  curricula::Score score;
  score.attempt_begun = true;
  score.attempt_time_s = 12.34;
  score.criteria.push_back({"attempt_time_s", "s", 12.34, 30.0, 0.0, true, ""});
  Row row = attempt_row(score, scenario, "Attempt");
  EXPECT_EQ(row.value, "12.3 s");
  EXPECT_EQ(row.limit, "at most 30 s");
  EXPECT_EQ(row.verdict, "met");
  curricula::Score unknown;
  unknown.mouth_unknown = true;
  row = attempt_row(unknown, scenario, "Attempt");
  EXPECT_EQ(row.value, "not timed") << "whether the blade entered it cannot be said";
  EXPECT_EQ(row.limit, "where the mouth begins is not known");
}

TEST(FigureRow, ATrialBegunAtTheValleculaHasNoTimesAndOneLineThatSaysSo) {
  TrialOutcome outcome;
  curricula::Score& score = outcome.score;
  score.attempt_begun = score.complete = true;
  score.attempt_time_s = 52.0;  // of which nothing is to be made
  score.time_to_trachea_visible_s = 3.5;
  curricula::Scenario scenario;
  scenario.pass.attempt_time_s = 30.0;
  const auto lines = [&] {
    std::vector<Row> all = result_figures(outcome, scenario);
    for (const Row& row : report_rows(score, {}, scenario)) all.push_back(row);
    return all;
  };
  const auto timed = [](const Row& row) {
    return row.name.rfind("Time to", 0) == 0 || row.name.find("ttempt") != std::string::npos;
  };
  const auto uncounted = [](const Row& row) { return row.name == "Times" && row.value == "not counted"; };
  for (const bool tube : {false, true}) {
    if (tube) score.intubation.emplace().attempts.resize(2);
    score.at_vallecula = false;
    auto all = lines();
    EXPECT_GE(std::count_if(all.begin(), all.end(), timed), tube ? 6 : 4);
    EXPECT_EQ(std::count_if(all.begin(), all.end(), uncounted), 0);
    score.at_vallecula = true;
    all = lines();
    for (const Row& row : all) EXPECT_FALSE(timed(row) && row.name != "Attempts") << row.name;
    EXPECT_EQ(std::count_if(all.begin(), all.end(), uncounted), 2) << "on the page and in the report";
  }
  const std::string advice = what_to_change(score, scenario);
  EXPECT_EQ(advice.find("30 seconds"), std::string::npos) << advice;
  EXPECT_EQ(summary_sentence(score, scenario).find("52"), std::string::npos) << summary_sentence(score, scenario);
}

TEST(FigureRow, AnAbortedTrialHasNoAttemptsThatAreMetAndTheTubesMarkStandsBesideItsRule) {
  TrialOutcome outcome;
  curricula::Score& score = outcome.score;
  curricula::IntubationScore& tube = score.intubation.emplace();
  tube.lips_rule_m = 0.092;
  curricula::Scenario scenario;
  scenario.intubation.emplace().pass.attempts = 2;
  const auto line = [&](bool page, const std::string& name) {
    const std::vector<Row> all = page ? result_figures(outcome, scenario) : report_rows(score, {}, scenario);
    const auto found = std::find_if(all.begin(), all.end(), [&](const Row& row) { return row.name == name; });
    return found == all.end() ? Row{} : *found;
  };
  for (const bool page : {true, false}) {
    tube.attempts.clear();
    tube.at_lips_m.reset();
    score.criteria = {{"attempt_begun", "", 0, 1, -1, false, "The attempt never began"}};
    EXPECT_EQ(line(page, "Attempts").value, "no attempt");
    EXPECT_EQ(line(page, "Attempts").verdict, "");
    EXPECT_EQ(line(page, "Tube's mark at the lips").value, "not in the mouth");
    tube.attempts.resize(2);
    tube.at_lips_m = 0.0906;
    score.criteria = {{"attempts", "", 2, 2, 1, true, "2 attempts"}};
    EXPECT_EQ(line(page, "Attempts").value, "2");
    EXPECT_EQ(line(page, "Attempts").verdict, "met");
    EXPECT_EQ(line(page, "Tube's mark at the lips").value, "9.1 cm");
    EXPECT_EQ(line(page, "Tube's mark at the lips").limit, "scenario's weight + 6: 9.2 cm, a help");
    EXPECT_EQ(line(page, "Tube's mark at the lips").verdict, "")
        << "a rule that hits half of all infants judges nobody";
  }
}

TEST(FigureRow, AFigureIsRoundedAsTheLiveFiguresAndTheSentencesAre) {
  // 29 of 40 points of the glottis: printf has 72, and half to even is nobody's rule at the bedside.
  for (const auto& [percent, said] : {std::pair{72.5, "73"}, {71.5, "72"}, {72.4999, "72"}, {0.5, "1"}}) {
    EXPECT_EQ(number(percent, 0), said);
    EXPECT_EQ(QString("%1").arg(percent, 0, 'f', 0), said) << "as the live figure is written";
  }
}

}  // namespace
}  // namespace vallecula::gui
