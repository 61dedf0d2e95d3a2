#include "curricula/progress/cusum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace vallecula::curricula {
namespace {

// By hand, p0 = 0.2, p1 = 0.4, alpha = beta = 0.1: P = ln 2 = 0.693147, Q = ln(4/3) = 0.287682, P + Q = 0.980829,
// s = 0.293305, h0 = h1 = ln 9 / 0.980829 = 2.197225 / 0.980829 = 2.240171.
constexpr double kStep = 0.293305, kLine = 2.240171, kByHand = 2e-6;

TEST(Cusum, LinesAreTheOnesComputedByHand) {
  const CusumLines lines = cusum_lines({});
  EXPECT_NEAR(lines.step, kStep, kByHand);
  EXPECT_NEAR(lines.lower, -kLine, kByHand);
  EXPECT_NEAR(lines.upper, kLine, kByHand);
}

TEST(Cusum, UnequalRisksMoveOneLineEach) {
  // alpha = 0.05, beta = 0.2: h0 = ln(0.95 / 0.2) / 0.980829 = 1.588599; h1 = ln(0.8 / 0.05) / 0.980829 = 2.826781.
  const CusumLines lines = cusum_lines({0.2, 0.4, 0.05, 0.2});
  EXPECT_NEAR(lines.lower, -1.588599, kByHand);
  EXPECT_NEAR(lines.upper, 2.826781, kByHand);
}

TEST(Cusum, EightSuccessesAreTheShortestWay) {
  // 7 x 0.293305 = 2.053 stays above the line, 8 x = 2.346 is below.
  const auto points = cusum({}, std::vector<bool>(8, true));
  ASSERT_EQ(points.size(), 8u);
  EXPECT_NEAR(points[6].sum, -2.053135, 1e-5);
  EXPECT_EQ(points[6].verdict, CusumVerdict::undecided);
  EXPECT_NEAR(points[7].sum, -2.346440, 2e-5);
  EXPECT_EQ(points[7].verdict, CusumVerdict::competent);
}

TEST(Cusum, FourFailuresAreDeficientAndTheNextTestBeginsAtZero) {
  // 3 x 0.706695 = 2.120 stays below the line, 4 x = 2.827 is above; then one success: -0.293.
  const auto points = cusum({}, {false, false, false, false, true});
  EXPECT_NEAR(points[2].sum, 2.120085, 1e-5);
  EXPECT_EQ(points[2].verdict, CusumVerdict::undecided);
  EXPECT_NEAR(points[3].sum, 2.826780, 1e-5);
  EXPECT_EQ(points[3].verdict, CusumVerdict::deficient);
  EXPECT_NEAR(points[4].sum, -kStep, kByHand);
  EXPECT_EQ(points[4].verdict, CusumVerdict::undecided);
}

TEST(Cusum, AFailureCostsMoreThanTwoSuccesses) {
  // One failure among successes: (n - 1) x 0.293305 - 0.706695 >= 2.240171 first for n - 1 = 11, so at trial 12.
  std::vector<bool> series(12, true);
  series[1] = false;
  const auto points = cusum({}, series);
  EXPECT_EQ(points[10].verdict, CusumVerdict::undecided);
  EXPECT_NEAR(points[11].sum, -2.519660, 2e-5);
  EXPECT_EQ(points[11].verdict, CusumVerdict::competent);
}

TEST(Cusum, RefusesRulesThatDecideNothing) {
  for (const CusumRule& rule : {CusumRule{0.4, 0.2, 0.1, 0.1}, CusumRule{0.2, 0.2, 0.1, 0.1}, CusumRule{0.0, 0.4},
                                CusumRule{0.2, 1.0}, CusumRule{0.2, 0.4, 0.0, 0.1}, CusumRule{0.2, 0.4, 0.5, 0.5},
                                CusumRule{std::nan(""), 0.4}, CusumRule{0.2, 0.4, 0.1, std::nan("")}})
    EXPECT_THROW(cusum_lines(rule), std::invalid_argument);
  EXPECT_TRUE(cusum({}, {}).empty());
}

/// In print in many places for p0 = 0.1, p1 = 0.2, alpha = beta = 0.1: s = 0.145, h0 = h1 = 2.71.
TEST(Cusum, LinesAgreeWithATableInPrint) {
  const CusumLines lines = cusum_lines({0.1, 0.2, 0.1, 0.1});
  EXPECT_NEAR(lines.step, 0.145, 5e-4);
  EXPECT_NEAR(lines.lower, -2.71, 5e-3);
}

/// Wald: whoever fails at p0 is called deficient first in about alpha of all cases, at p1 competent in about beta; the
/// overshoot makes it rarer. 0.02 is three standard errors of 2,000 runs and more.
TEST(Cusum, ErrsAsOftenAsItSays) {
  std::mt19937 random(7);
  for (const double p : {0.2, 0.4}) {
    std::bernoulli_distribution succeeds(1.0 - p);
    int wrong = 0;
    for (int run = 0; run < 2000; ++run) {
      std::vector<bool> successes;
      for (int i = 0; i < 400; ++i) successes.push_back(succeeds(random));
      CusumVerdict first = CusumVerdict::undecided;
      for (const CusumPoint& point : cusum({}, successes))
        if (first == CusumVerdict::undecided) first = point.verdict;
      ASSERT_NE(first, CusumVerdict::undecided) << "400 trials decide";
      wrong += first == (p == 0.2 ? CusumVerdict::deficient : CusumVerdict::competent) ? 1 : 0;
    }
    EXPECT_LT(wrong / 2000.0, 0.1 + 0.02) << p;
    EXPECT_GT(wrong / 2000.0, 0.04) << p;
  }
}

TEST(Cusum, CountsToSuccessesInARow) {
  EXPECT_EQ(trials_to_consecutive({true, false, true, true, true, false}, 3), 5);
  EXPECT_EQ(trials_to_consecutive({true, true, false, true, true}, 3), -1);
  EXPECT_EQ(trials_to_consecutive({true}, 1), 1);
  EXPECT_EQ(trials_to_consecutive({}, 1), -1);
  EXPECT_THROW(trials_to_consecutive({true}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace vallecula::curricula
