#include "curricula/score/points.h"

#include <gtest/gtest.h>

#include <utility>

namespace vallecula::curricula {
namespace {

Criterion judged(const char* name, bool met, double at_s) {
  return {name, "", 0.0, 0.0, at_s, met, std::string("about ") + name};
}

TEST(Points, WeightsShareAHundredAndEachSaysWhenAndWhy) {
  Scenario scenario;
  scenario.rubric["peak_tongue_force_n"] = {3.0, "NCT05197868"};
  scenario.rubric["glottis_visible_percent"] = {0.0, "assumed"};
  scenario.rubric["outcomes"] = {4.0, "assumed"};
  Score score;
  score.complete = score.attempt_begun = true;
  score.criteria = {judged("trial_complete", true, 40.0), judged("peak_tongue_force_n", false, 12.5),
                    judged("glottis_visible_max_percent", false, -1.0), judged("outcome", true, 20.0),
                    judged("time_over_force_limit_s", true, -1.0)};
  const auto points = points_of(score, scenario);
  ASSERT_EQ(points.size(), 4u) << "that a trial is complete earns nothing";
  // Weights 3, 0, 4 and, not named, 1: together 8.
  EXPECT_EQ(points[0].mark, "peak_tongue_force_n");
  EXPECT_NEAR(points[0].of, 37.5, 1e-12);
  EXPECT_EQ(points[0].earned, 0.0);
  EXPECT_EQ(points[0].at_s, 12.5);
  EXPECT_EQ(points[0].sentence, "about peak_tongue_force_n");
  EXPECT_EQ(points[0].source, "NCT05197868; not validated");
  EXPECT_EQ(points[1].mark, "glottis_visible_percent");
  EXPECT_EQ(points[1].of, 0.0);
  EXPECT_EQ(points[2].mark, "outcomes");
  EXPECT_NEAR(points[2].earned, 50.0, 1e-12);
  EXPECT_EQ(points[3].mark, "time_over_device_limit_s");
  EXPECT_NEAR(points[3].earned, 12.5, 1e-12);
  EXPECT_EQ(points[3].source, "no source given; not validated");
}

TEST(Points, WhatCouldNotBeJudgedEarnsNone) {
  for (const auto& [complete, begun] : {std::pair(false, true), std::pair(true, false)}) {
    Score score;
    score.complete = complete;
    score.attempt_begun = begun;
    score.criteria = {judged("peak_tongue_force_n", true, -1.0), judged("attempt_time_s", true, -1.0)};
    const auto points = points_of(score, Scenario{});
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].of, 50.0);
    EXPECT_EQ(points[0].earned + points[1].earned, 0.0);
  }
}

TEST(Points, WithoutAnyWeightThereAreNone) {
  Scenario scenario;
  scenario.rubric["attempts"] = {0.0, "x"};
  Score score;
  score.criteria = {judged("attempts", true, 1.0)};
  EXPECT_TRUE(points_of(score, scenario).empty());
  EXPECT_TRUE(points_of(Score{}, scenario).empty());
}

}  // namespace
}  // namespace vallecula::curricula
