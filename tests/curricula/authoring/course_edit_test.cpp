// A course stays valid when its parts are added, copied, moved and deleted.
#include "curricula/authoring/course_edit.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "curricula/scenario.h"
#include "tests/curricula/full_course.h"

namespace vallecula::curricula {
namespace {

std::string shipped(const std::string& name) {
  std::ifstream in(std::string(VALLECULA_SOURCE_DIR) + "/curricula/courses/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void expect_valid(const std::string& text) {
  for (const Problem& problem : problems_of(text))
    ADD_FAILURE() << problem.line << ": " << problem.message << "\n" << text;
}

std::vector<std::string> order(const std::string& text, const std::string& module) {
  const YamlText course(text);
  std::vector<std::string> ids;
  const YamlNode* list = course.find(path_of(course, "modules", module) + ".scenarios");
  for (const YamlNode& one : list->children) ids.push_back(one.value);
  return ids;
}

using Ids = std::vector<std::string>;

TEST(CourseEdit, AnEmptyCourseIsValidWhateverItsTitle) {
  expect_valid(empty_course("mine", "My course"));
  expect_valid(empty_course("mine", "Title: with # and \"quotes\""));
}

TEST(CourseEdit, PartsAreAddedToAnyCourse) {
  for (const std::string& whole :
       {shipped("neonatal-intubation.yaml"), std::string(testing::kFullCourse), empty_course("mine", "My course")}) {
    std::string id, other;
    const std::string more = with_new_scenario(YamlText(whole), 0, id);
    expect_valid(more);
    EXPECT_EQ(id, "new-scenario");
    const std::string again = with_new_scenario(YamlText(more), 0, other);
    expect_valid(again);
    EXPECT_EQ(other, "new-scenario-2");
    EXPECT_EQ(without_scenario(YamlText(more), id), whole) << "taken away again, to the byte";
    const std::string with_module = with_new_module(YamlText(whole), id);
    expect_valid(with_module);
    EXPECT_EQ(without_module(YamlText(with_module), id), whole);
  }
}

TEST(CourseEdit, CopiesHaveIdsOfTheirOwn) {
  const YamlText course(shipped("neonatal-intubation.yaml"));
  std::string id;
  const std::string scenario = with_scenario_copied(course, course, "lift", 1, 0, id);
  expect_valid(scenario);
  EXPECT_EQ(id, "lift-2");
  EXPECT_EQ(order(scenario, "finding-the-view").front(), "lift-2");
  const std::string module = with_module_copied(course, course, "passing-the-tube", id);
  expect_valid(module);
  EXPECT_EQ(id, "passing-the-tube-2");
  EXPECT_EQ(order(module, id), (Ids{"tube-stylet-2", "tube-plain-2", "tube-secretions-2"}));
}

TEST(CourseEdit, WeightsAndSourcesComeWithACopiedScenario) {
  const std::string to = empty_course("mine", "Mine") +
                         "rubric:\n  peak_gum_force_n: { weight: 7, source: ours }\n";
  const YamlText from(empty_course("theirs", "Theirs") +
                      "rubric:\n  peak_gum_force_n: { weight: 2, source: theirs }\n"
                      "  peak_tongue_force_n: { weight: 3, source: a study }\n");
  std::string id;
  const std::string text = with_scenario_copied(YamlText(to), from, "first-scenario", 0, 1, id);
  expect_valid(text);
  const YamlText course(text);
  const YamlNode* copy = course.find(path_of(course, "scenarios", id) + ".rubric");
  ASSERT_NE(copy, nullptr);
  ASSERT_EQ(copy->children.size(), 1u) << "of the other mark the course has its own";
  EXPECT_EQ(copy->child("peak_tongue_force_n")->child("weight")->value, "3");
  EXPECT_EQ(copy->child("peak_tongue_force_n")->child("source")->value, "a study");
}

TEST(CourseEdit, AModuleOfAnotherCourseComesWithItsScenarios) {
  const YamlText from(shipped("neonatal-intubation.yaml"));
  std::string id;
  const std::string text = with_module_copied(YamlText(empty_course("mine", "Mine")), from, "handling-the-blade", id);
  EXPECT_EQ(order(text, id), (Ids{"way-in", "lift", "light-hand"}));
  // Its sizes by weight and its sources are the other course's: what is missing now is said by name.
  for (const Problem& problem : problems_of(text))
    EXPECT_NE(problem.field.find("blade"), std::string::npos) << problem.message;
}

TEST(CourseEdit, ScenariosMoveWithinAndBetweenModules) {
  const std::string whole = shipped("neonatal-intubation.yaml");
  const std::string up = with_scenario_moved(YamlText(whole), "light-hand", 0, 0);
  EXPECT_EQ(order(up, "handling-the-blade"), (Ids{"light-hand", "way-in", "lift"}));
  const std::string over = with_scenario_moved(YamlText(whole), "lift", 1, 1);
  expect_valid(over);
  EXPECT_EQ(order(over, "handling-the-blade"), (Ids{"way-in", "light-hand"}));
  EXPECT_EQ(order(over, "finding-the-view"), (Ids{"view-term", "lift", "view-many", "view-preterm"}));
  EXPECT_EQ(with_scenario_moved(YamlText(over), "lift", 0, 1), whole) << "back again, to the byte";
}

TEST(CourseEdit, WhatACourseNeedsCannotBeTaken) {
  const YamlText course(empty_course("mine", "Mine"));
  EXPECT_THROW(without_scenario(course, "first-scenario"), std::runtime_error);
  EXPECT_THROW(without_module(course, "first-module"), std::runtime_error);
  const YamlText full(testing::kFullCourse);
  EXPECT_THROW(with_scenario_moved(full, "one", 1, 0), std::runtime_error);
  expect_valid(without_module(full, "a"));  // what waited for it waits no more
}

TEST(CourseEdit, AnIdChangesWhereverItIsNamed) {
  const std::string scenario = with_id(YamlText(testing::kFullCourse), "scenarios", "one", "first");
  expect_valid(scenario);
  EXPECT_EQ(order(scenario, "a"), Ids{"first"});
  const std::string module = with_id(YamlText(testing::kFullCourse), "modules", "a", "begin");
  expect_valid(module);
  EXPECT_EQ(module.find("after: [a]"), std::string::npos);
}

TEST(CourseEdit, AnOldCourseIsDividedIntoModulesAsItIsReadAnyway) {
  for (const char* name : {"first-steps.yaml", "first-intubation.yaml"}) {
    const std::string whole = shipped(name), text = with_modules(YamlText(whole));
    expect_valid(text);
    const YamlText course(text);
    EXPECT_EQ(ids_in(course, "scenarios"), order(text, ids_in(course, "modules").at(0)));
    EXPECT_EQ(text.substr(0, whole.find("schema: 1")), whole.substr(0, whole.find("schema: 1")));
  }
}

}  // namespace
}  // namespace vallecula::curricula
