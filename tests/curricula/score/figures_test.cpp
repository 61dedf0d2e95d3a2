#include "curricula/score/figures.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace vallecula::curricula {
namespace {

TEST(Figures, AreNamedOnceEachWithUnitDefinitionAndSource) {
  std::set<std::string> names;
  for (const Figure& one : figures()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_EQ(find_figure(one.name), &one);
    for (const char* text : {one.label, one.definition, one.source}) EXPECT_NE(std::string(text), "") << one.name;
    const std::string name = one.name, unit = one.unit;
    const auto ends = [&name](const std::string& end) {
      return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
    };
    EXPECT_EQ(ends("_n"), unit == "N") << name;
    EXPECT_EQ(ends("_percent"), unit == "%") << name;
    EXPECT_EQ(ends("_per_min"), unit == "1/min") << name;
    EXPECT_EQ(ends("_kpa"), unit == "kPa") << name;
    EXPECT_EQ(ends("_mm"), unit == "mm") << name;
  }
  EXPECT_EQ(find_figure("no_such_figure"), nullptr);
}

TEST(Figures, WhatATrialDoesNotHaveIsNothing) {
  const Score none;
  for (const char* name : {"attempt_time_s", "time_to_trachea_visible_s", "attempts", "time_to_pass_s",
                           "lowest_spo2_percent", "lowest_heart_per_min", "desaturated", "bradycardia",
                           "depth_error_mm", "tube_at_lips_cm", "mean_tongue_force_n", "peak_tongue_pressure_kpa", "lift_share_percent", "time_to_stable_view_s",
                           "mean_glottis_visible_percent", "cormack_lehane", "entry_left_mm", "blade_from_midline_mm",
                           "tip_to_vallecula_mm", "vallecula_reached", "past_vallecula_mm", "tip_path_mm",
                           "smoothness_sparc", "tremor_mm", "dual_task_reaction_s", "dual_task_errors",
                           "dual_task_missed"})
    EXPECT_FALSE(find_figure(name)->value(none)) << name;
  Score some;
  some.intubation.emplace().attempts.resize(2);
  some.intubation->attempts[1].time_to_pass_s = some.intubation->attempts[1].passed_cords_s = 7.5;
  EXPECT_EQ(find_figure("attempts")->value(some), 2.0);
  EXPECT_EQ(find_figure("time_to_pass_s")->value(some), 7.5);
}

TEST(Figures, EachReadsItsOwnPartOfTheScore) {
  Score s;
  s.attempt_begun = true;
  s.mouth_entries = 3;
  s.glottis_visible_max_percent = 40.0;
  s.peak_force_n[kPalate] = 1.5;
  s.force.mean_tongue_n = 2.5;
  s.force.tongue_integral_ns = 30.0;
  s.force.tongue_pressure_pa = Peak{12500.0, 3.0};
  s.force.lift_share = 0.75;
  s.force.levered_n = {1.25, 4.0};
  s.view.mean_percent = 33.0;
  s.view.time_to_stable_s = 6.0;
  s.blade = {-0.009, 0.004, 5.0, -0.002, true, 5.0, 0.007, 6.0};
  s.motion = {0.42, -3.5, 0.0006};
  s.dual_task.emplace();
  s.dual_task->wrong = 1;
  s.dual_task->false_answers = 2;
  s.dual_task->missed = 4;
  s.dual_task->mean_reaction_s = 2.25;
  s.intubation.emplace().attempts.resize(2);
  s.intubation->attempts[1].desaturated = true;
  s.intubation->cords_to_carina_m = 0.048;
  s.intubation->depth_m = 0.031;
  for (const auto& [name, value] : std::map<std::string, double>{
           {"mouth_entries", 3},         {"cormack_lehane", 2},        {"peak_palate_force_n", 1.5},
           {"mean_tongue_force_n", 2.5}, {"tongue_force_integral_ns", 30}, {"lift_share_percent", 75},
           {"peak_tongue_pressure_kpa", 12.5},
           {"peak_levered_n", 1.25},     {"mean_glottis_visible_percent", 33}, {"time_to_stable_view_s", 6},
           {"entry_left_mm", -9},        {"tip_to_vallecula_mm", 4},   {"blade_from_midline_mm", 2},
           {"vallecula_reached", 1},     {"past_vallecula_mm", 7},     {"tip_path_mm", 420},
           {"smoothness_sparc", -3.5},   {"tremor_mm", 0.6},           {"dual_task_errors", 3},
           {"dual_task_missed", 4},      {"dual_task_reaction_s", 2.25}, {"desaturated", 1},
           {"bradycardia", 0},           {"depth_error_mm", 7}}) {
    ASSERT_TRUE(find_figure(name)) << name;
    ASSERT_TRUE(find_figure(name)->value(s)) << name;
    EXPECT_NEAR(*find_figure(name)->value(s), value, 1e-9) << name;
  }
}

TEST(Figures, OnlySmoothnessAndTremorAreForResearchersAlone) {
  for (const Figure& one : figures())
    EXPECT_EQ(one.for_researchers, std::string(one.name) == "smoothness_sparc" || std::string(one.name) == "tremor_mm")
        << one.name;
}

}  // namespace
}  // namespace vallecula::curricula
