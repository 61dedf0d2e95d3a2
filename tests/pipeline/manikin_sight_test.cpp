// The sight property: hidden at rest, seen when the tongue base is lifted, for every weight and seed; and the unvaried
// term manikin against the design's table, which was made with a script of its own in the mid-sagittal plane.
#include <gtest/gtest.h>

#include <thread>

#include "pipeline/manikin/manikin.h"

namespace vallecula::pipeline {
namespace {

struct Row {
  double lift;
  double tongue;
  double epiglottis;
  double pogo;
};
// Displacement (mm), tongue and epiglottis to the sight line (mm, negative = in the way), glottis seen (%).
constexpr Row kTable[] = {{0, -9.3, -10.9, 0}, {4, -5.3, -7.3, 0}, {6, -3.3, -4.8, 0}, {8, -1.3, -1.9, 5},
                          {9, -0.3, -0.4, 29}, {10, 0.7, 1.2, 46}, {11, 1.7, 2.8, 63}, {12, 2.4, 4.3, 78},
                          {13, 2.8, 4.5, 83},  {15, 3.0, 4.9, 85}};

TEST(ManikinSight, UnvariedTermFollowsTheTable) {
  const Manikin man(3.2, 0);
  // The solid's outline is a smooth curve through the design's points, sampled every 0.1 mm: half a millimetre between
  // the two. At the table's steepest, 24 % of the glottis comes free in a millimetre, hence 10 % there.
  for (const auto& row : kTable) {
    EXPECT_NEAR(man.sight_clearance("tongue", row.lift), row.tongue, 0.5) << "lift " << row.lift;
    EXPECT_NEAR(man.sight_clearance("epiglottis", row.lift), row.epiglottis, 0.5) << "lift " << row.lift;
    EXPECT_NEAR(100.0 * man.glottis_seen_midline(row.lift), row.pogo, 10.0) << "lift " << row.lift;
  }
}

TEST(ManikinSight, FixedPartsLeaveTheLineClearAsInTheTable) {
  const Manikin man(3.2, 0);
  // Edges are rounded where the table has corners: up to a millimetre either way.
  const std::pair<const char*, double> clearances[] = {{"upper_lip", 2.0}, {"upper_gum", 3.6},
                                                       {"lower_gum", 5.3}, {"arytenoids", 6.5},
                                                       {"nose", 9.3},      {"posterior_wall", 11.6}};
  for (const auto& [part, expected] : clearances) EXPECT_NEAR(man.sight_clearance(part), expected, 1.0) << part;
  // The table's palate starts at the gum (5.5 mm); the plate behind it lies higher.
  EXPECT_GE(man.sight_clearance("hard_palate"), 5.5);
  EXPECT_GE(man.sight_clearance("soft_palate"), 10.0);
  EXPECT_THROW(man.sight_clearance("elbow"), std::runtime_error);
}

struct Case {
  double weight;
  std::uint64_t seed;
};

/// Runs `check` over the cases on all cores; messages are gathered and reported by the caller's thread.
template <class Check>
void over(const std::vector<Case>& cases, Check&& check) {
  std::vector<std::string> complaints(cases.size());
  std::vector<std::thread> threads;
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t t = 0; t < cores; ++t)
    threads.emplace_back([&, t] {
      for (std::size_t i = t; i < cases.size(); i += cores) complaints[i] = check(cases[i]);
    });
  for (auto& thread : threads) thread.join();
  for (std::size_t i = 0; i < cases.size(); ++i)
    EXPECT_EQ(complaints[i], "") << cases[i].weight << " kg, seed " << cases[i].seed;
}

TEST(ManikinSight, HiddenAtRestAndSeenWhenLiftedForEveryWeightAndSeed) {
  // Every seed at one weight, the weights taken in turn so that each meets many seeds; the corners of the range and the
  // term weight see all of the first seeds.
  std::vector<Case> cases;
  constexpr double kWeights[] = {0.6, 0.9, 1.3, 1.8, 2.4, 3.2, 3.8, 4.5};
  for (std::uint64_t seed = 0; seed < 50; ++seed) cases.push_back({kWeights[seed % 8], seed});
  for (std::uint64_t seed = 0; seed < 8; ++seed)
    for (const double weight : {0.6, 3.2, 4.5}) cases.push_back({weight, seed});
  over(cases, [](const Case& c) -> std::string {
    const Manikin man(c.weight, c.seed);
    const double s = man.scale();
    std::string wrong;
    const auto complain = [&](const std::string& what, double value) {
      wrong += what + " " + std::to_string(value) + "; ";
    };
    if (man.glottis_seen(0.0) > 0.0) complain("seen at rest", man.glottis_seen(0.0));
    if (man.sight_clearance("tongue") > -3.0 * s) complain("tongue hides too little", man.sight_clearance("tongue"));
    if (man.sight_clearance("epiglottis") > -3.0 * s)
      complain("epiglottis hides too little", man.sight_clearance("epiglottis"));
    // The design's 12 mm; the fullest tongues (1.5 mm more than the design's) need 13.
    if (man.glottis_seen_midline(12.0 * s) < 0.5) complain("seen at 12 mm only", man.glottis_seen_midline(12.0 * s));
    if (man.glottis_seen_midline(13.0 * s) < 0.6) complain("seen at 13 mm only", man.glottis_seen_midline(13.0 * s));
    if (man.glottis_seen(13.0 * s) < 0.5) complain("area seen at 13 mm only", man.glottis_seen(13.0 * s));
    for (const char* part :
         {"upper_lip", "upper_gum", "hard_palate", "soft_palate", "nose", "posterior_wall", "arytenoids", "lower_gum"})
      if (man.sight_clearance(part) < 1.4 * s) complain(part, man.sight_clearance(part));
    return wrong;
  });
}

}  // namespace
}  // namespace vallecula::pipeline
