#include "curricula/score/figures.h"

#include <gtest/gtest.h>

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
  }
  EXPECT_EQ(find_figure("no_such_figure"), nullptr);
}

TEST(Figures, WhatATrialDoesNotHaveIsNothing) {
  const Score none;
  for (const char* name : {"attempt_time_s", "time_to_trachea_visible_s", "attempts", "time_to_pass_s",
                           "lowest_spo2_percent", "lowest_heart_per_min"})
    EXPECT_FALSE(find_figure(name)->value(none)) << name;
  Score some;
  some.intubation.emplace().attempts.resize(2);
  some.intubation->attempts[1].time_to_pass_s = some.intubation->attempts[1].passed_cords_s = 7.5;
  EXPECT_EQ(find_figure("attempts")->value(some), 2.0);
  EXPECT_EQ(find_figure("time_to_pass_s")->value(some), 7.5);
}

}  // namespace
}  // namespace vallecula::curricula
