#include "curricula/progress/progress.h"

#include <gtest/gtest.h>

namespace vallecula::curricula {
namespace {

/// a (scenarios a1, a2; passes running: 2) opens b (b1; CUSUM), whose scenario b2 waits for c; c waits for nothing.
Curriculum course() {
  Curriculum c;
  for (const char* id : {"a1", "a2", "b1", "b2", "c1"}) c.scenarios.emplace_back().id = id;
  c.scenarios[3].after = {"c"};
  Module a;
  a.id = "a";
  a.scenarios = {"a1", "a2"};
  a.mastery.passes = 2;
  a.mastery.attempts = 2;
  Module b;
  b.id = "b";
  b.scenarios = {"b1", "b2"};
  b.after = {"a"};
  b.mastery.by_cusum = true;
  b.mastery.attempts = 2;
  Module last;
  last.id = "c";
  last.scenarios = {"c1"};
  last.mastery.passes = 1;
  last.mastery.assessments_only = true;
  c.modules = {a, b, last};
  return c;
}

PastResult pass(const char* scenario, int attempts = 1) { return {scenario, "mouse", Mode::practice, true, attempts}; }
PastResult miss(const char* scenario) { return {scenario, "mouse", Mode::practice, false, 1}; }

using Ids = std::vector<std::string>;

TEST(Progress, WhoHasDoneNothingMayBeginWhatWaitsForNothing) {
  const auto all = progress_of(course(), {}, "mouse");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[0].open);
  EXPECT_EQ(all[0].open_scenarios, (Ids{"a1", "a2"}));
  EXPECT_FALSE(all[1].open);
  EXPECT_TRUE(all[1].open_scenarios.empty());
  EXPECT_TRUE(all[2].open);
  for (const ModuleProgress& module : all) EXPECT_FALSE(module.mastered);
}

TEST(Progress, PassesMustRunInEachScenarioWhateverIsDoneBetween) {
  const auto mastered = [](const std::vector<PastResult>& results) {
    return progress_of(course(), results, "mouse")[0].mastered;
  };
  EXPECT_FALSE(mastered({pass("a1"), pass("a1")})) << "a2 was never done";
  EXPECT_FALSE(mastered({pass("a1"), pass("a2"), miss("a1"), pass("a1"), pass("a2")}));
  EXPECT_TRUE(mastered({pass("a1"), pass("a2"), miss("b1"), pass("a1"), pass("a2")}));
  EXPECT_TRUE(mastered({pass("a1"), pass("a1"), pass("a2"), pass("a2"), miss("a1")})) << "once reached it stays";
  EXPECT_FALSE(mastered({pass("a1"), pass("a1", 3), pass("a2"), pass("a2")})) << "three attempts are no success";
  EXPECT_TRUE(mastered({pass("a1"), pass("a1", 2), pass("a2"), pass("a2")}));
}

TEST(Progress, MasteryOpensModulesAndScenarios) {
  std::vector<PastResult> results{pass("a1"), pass("a1"), pass("a2"), pass("a2")};
  auto all = progress_of(course(), results, "mouse");
  EXPECT_TRUE(all[1].open);
  EXPECT_EQ(all[1].open_scenarios, Ids{"b1"}) << "b2 waits for c";
  results.push_back(pass("c1"));
  EXPECT_EQ(progress_of(course(), results, "mouse")[1].open_scenarios, Ids{"b1"}) << "practice does not count in c";
  results.push_back({"c1", "mouse", Mode::assessment, true, 1});
  all = progress_of(course(), results, "mouse");
  EXPECT_TRUE(all[2].mastered);
  EXPECT_EQ(all[1].open_scenarios, (Ids{"b1", "b2"}));
}

TEST(Progress, ACusumRunsOverTheModulesTrialsAndNeedsEachScenarioPassed) {
  // By hand: 8 successes running reach the lower line (8 x 0.293305 = 2.346440 >= 2.240171).
  std::vector<PastResult> results(8, pass("b1"));
  auto b = progress_of(course(), results, "mouse")[1];
  ASSERT_EQ(b.cusum.size(), 8u);
  EXPECT_NEAR(b.cusum.back().sum, -2.346440, 1e-5);
  EXPECT_EQ(b.cusum.back().verdict, CusumVerdict::competent);
  EXPECT_FALSE(b.mastered) << "b2 was never passed";
  results.push_back(pass("b2", 3));
  EXPECT_FALSE(progress_of(course(), results, "mouse")[1].mastered) << "not within two attempts";
  results.push_back(pass("b2"));
  EXPECT_TRUE(progress_of(course(), results, "mouse")[1].mastered);
  // One failure among them costs 1 - 0.293305 + 0.293305: four more than eight are needed.
  results.assign(12, pass("b1"));
  results[3] = miss("b2");
  results[5] = pass("b2");
  EXPECT_TRUE(progress_of(course(), results, "mouse")[1].mastered);
  results.pop_back();
  EXPECT_FALSE(progress_of(course(), results, "mouse")[1].mastered);
}

TEST(Progress, KindsOfDeviceAreNeverPooled) {
  std::vector<PastResult> results{pass("a1"), pass("a1"), pass("a2"), pass("a2")};
  results[1].device_kind = "touch";
  EXPECT_FALSE(progress_of(course(), results, "mouse")[0].mastered);
  EXPECT_FALSE(progress_of(course(), results, "touch")[0].mastered);
  results.push_back(pass("a1"));
  EXPECT_TRUE(progress_of(course(), results, "mouse")[0].mastered);
  EXPECT_FALSE(progress_of(course(), results, "touch")[0].mastered);
}

TEST(Progress, ResultsOfOtherCoursesAreLeftOut) {
  EXPECT_TRUE(progress_of(course(), {pass("elsewhere"), miss("elsewhere")}, "mouse")[1].cusum.empty());
}

TEST(Progress, CountsWhatIsDoneOnTheWay) {
  const auto all = progress_of(course(), {pass("a1"), pass("a1"), pass("a2", 3), miss("a2"), pass("a2")}, "mouse");
  EXPECT_EQ(all[0].trials, 5);
  EXPECT_EQ(all[0].succeeded, 3) << "three attempts are one too many";
  EXPECT_EQ(all[0].scenarios_done, 1) << "a2 was never passed twice running";
  EXPECT_EQ(all[1].trials, 0);
  EXPECT_EQ(progress_of(course(), {pass("b1")}, "mouse")[1].scenarios_done, 1) << "CUSUM asks for one success of each";
}

}  // namespace
}  // namespace vallecula::curricula
