#include "gui/records_pages/curve_reading.h"

#include <gtest/gtest.h>

#include "curricula/score/figures.h"

namespace vallecula::gui {
namespace {

using curricula::RecordRow;

RecordRow trial(bool passed, int attempts = 1, bool complete = true) {
  RecordRow row;
  row.curriculum_id = "course";
  row.scenario_id = "view";
  row.score.passed = passed;
  row.score.complete = complete;
  row.attempts = attempts;
  return row;
}

std::vector<RecordRow> trials(const std::string& results) {
  std::vector<RecordRow> rows;
  for (const char one : results) {
    rows.push_back(trial(one == '+'));
    if (one == 'x') rows.back().score.complete = false;
  }
  return rows;
}

curricula::Curriculum course_with(const curricula::MasteryRule& rule) {
  curricula::Curriculum course;
  course.id = "course";
  course.modules.emplace_back();
  course.modules[0].title = "The view";
  course.modules[0].scenarios = {"view"};
  course.modules[0].mastery = rule;
  return course;
}

TEST(CurveReading, CountsWholeTrialsAndNamesTheInterrupted) {
  const CurveReading reading = read_curve(trials("-+x+-+++"), nullptr);
  EXPECT_EQ(reading.successes, (std::vector<bool>{false, true, true, false, true, true, true}));
  EXPECT_EQ(reading.interrupted, 1);
  EXPECT_EQ(reading.to_three_in_a_row, 7) << "the interrupted one neither breaks nor makes a row";
  EXPECT_EQ(reading.in_a_row, 3);
  EXPECT_EQ(reading.to_competent, -1);
  EXPECT_EQ(reading.cusum.size(), 7u);
  EXPECT_NE(reading.rule_in_words.find("PMC8290971"), std::string::npos);
  std::vector<RecordRow> rows = trials("-+x+-+++");
  rows[3].score.set_aside = {"why"};
  const CurveReading other = read_curve(rows, nullptr);
  EXPECT_EQ(other.interrupted, 1);
  EXPECT_EQ(other.set_aside, 1);
  EXPECT_EQ(other.successes.size(), 6u);
}

/// By hand, for p0 = 0.2, p1 = 0.4, alpha = beta = 0.1: P = ln 2, Q = ln(0.8 / 0.6), s = 0.29330, h0 = ln 9 / (P + Q)
/// = 2.24013: the eighth success in a row takes the sum to -2.3464.
TEST(CurveReading, SaysAfterHowManyTrialsTheSumIsCompetentByThePublishedRule) {
  EXPECT_EQ(read_curve(trials("+++++++"), nullptr).to_competent, -1);
  EXPECT_EQ(read_curve(trials("++++++++"), nullptr).to_competent, 8);
  EXPECT_EQ(read_curve(trials("-++++++++"), nullptr).to_competent, -1);
  EXPECT_EQ(verdict_in_words(read_curve(trials("+++++++++-"), nullptr).cusum), "competent (trial 8)");
  EXPECT_EQ(verdict_in_words(read_curve(trials("----"), nullptr).cusum), "not competent (trial 4)");
  EXPECT_EQ(verdict_in_words({}), "undecided");
}

TEST(CurveReading, GoesByTheModulesOwnRuleWhereItIsKnown) {
  curricula::MasteryRule rule;
  rule.by_cusum = true;
  rule.attempts = 1;
  rule.cusum.unacceptable_failure = 0.8;  // told apart after fewer trials
  rule.source = "a faculty's own";
  const auto course = course_with(rule);
  std::vector<RecordRow> rows = trials("+++");
  rows.push_back(trial(true, 2));
  const CurveReading reading = read_curve(rows, &course);
  EXPECT_EQ(reading.rule.unacceptable_failure, 0.8);
  EXPECT_EQ(reading.successes.back(), false) << "two attempts are one too many there";
  EXPECT_EQ(read_curve(rows, nullptr).successes.back(), true);
  EXPECT_NE(reading.rule_in_words.find("The view"), std::string::npos);
  EXPECT_NE(reading.rule_in_words.find("a faculty's own"), std::string::npos);
  rule.assessments_only = true;
  const auto of_assessments = course_with(rule);
  rows.front().mode = curricula::Mode::assessment;
  EXPECT_EQ(read_curve(rows, &of_assessments).successes, std::vector<bool>{true}) << "practice counts in nothing";
  EXPECT_EQ(read_curve(rows, &of_assessments).cusum.size(), 1u);
  EXPECT_NE(read_curve(rows, &of_assessments).rule_in_words.find("assessments alone"), std::string::npos);
  rule.by_cusum = false;
  const auto by_passes = course_with(rule);
  EXPECT_NE(read_curve(rows, &by_passes).rule_in_words.find("published"), std::string::npos);
}

TEST(CurveReading, LimitsAreThoseOfTheScenarioAndOfFiguresThatExist) {
  curricula::Scenario scenario;
  scenario.targets = {5.0, 2.0};
  scenario.pass = {6.8, 3.0, 50.0, 30.0, 3.0, 0.2};
  EXPECT_EQ(pass_limit(scenario, "peak_tongue_force_n"), 6.8);
  EXPECT_EQ(training_target(scenario, "peak_tongue_force_n"), 5.0);
  EXPECT_EQ(training_target(scenario, "peak_gum_force_n"), 2.0);
  EXPECT_EQ(pass_limit(scenario, "time_to_pass_s"), std::nullopt) << "laryngoscopy alone";
  scenario.intubation.emplace().pass.time_to_pass_s = 20.0;
  EXPECT_EQ(pass_limit(scenario, "time_to_pass_s"), 20.0);
  EXPECT_EQ(pass_limit(scenario, "lowest_spo2_percent"), std::nullopt) << "not asked for";
  int limited = 0;
  auto& pass = scenario.intubation->pass;
  pass.attempts = 2;
  pass.lowest_heart_per_min = pass.lowest_spo2_percent = 90.0;
  for (const curricula::Figure& figure : curricula::figures()) limited += pass_limit(scenario, figure.name) ? 1 : 0;
  EXPECT_EQ(limited, 10) << "each line is of a figure of the table: a name that changes there loses its line here";
}

}  // namespace
}  // namespace vallecula::gui
