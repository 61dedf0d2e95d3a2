#include "curricula/progress/cusum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace vallecula::curricula {
namespace {

/// Figures worked out by hand from the formula: P = ln 2, Q = ln(4/3), a = b = ln 9.
TEST(Cusum, LimitsAreTheFormulasForEightyPercent) {
  const CusumLimits limits = cusum_limits();
  EXPECT_NEAR(limits.success_step, 0.2933049, 1e-7);
  EXPECT_NEAR(limits.failure_step, 0.7066951, 1e-7);
  EXPECT_NEAR(limits.competent, 2.2401703, 1e-7);
  EXPECT_NEAR(limits.deficient, 2.2401703, 1e-7);
}

/// In print in many places for p0 = 0.1, p1 = 0.2, alpha = beta = 0.1: s = 0.145, h0 = h1 = 2.71.
TEST(Cusum, LimitsAgreeWithATableInPrint) {
  const CusumLimits limits = cusum_limits({0.1, 0.2, 0.1, 0.1});
  EXPECT_NEAR(limits.success_step, 0.145, 5e-4);
  EXPECT_NEAR(limits.competent, 2.71, 5e-3);
}

/// PMC8290971: the quickest fellow needed 8 procedures.
TEST(Cusum, EightSuccessesShowCompetenceAndFourFailuresTheOpposite) {
  const CusumCurve good = cusum(std::vector<bool>(10, true));
  EXPECT_EQ(good.competent_at, 7);
  EXPECT_EQ(good.deficient_at, -1);
  EXPECT_EQ(good.last, CusumVerdict::competent);
  EXPECT_NEAR(good.sum[7], -8 * 0.2933049, 1e-5);
  const CusumCurve bad = cusum(std::vector<bool>(4, false));
  EXPECT_EQ(bad.deficient_at, 3);
  EXPECT_EQ(bad.competent_at, -1);
  EXPECT_EQ(cusum({}).last, CusumVerdict::undecided);
}

TEST(Cusum, AfterADecisionTheTestBeginsAnew) {
  std::vector<bool> success(8, true);  // competent, then four failures in a row
  success.insert(success.end(), 4, false);
  const CusumCurve curve = cusum(success);
  EXPECT_EQ(curve.competent_at, 7);
  EXPECT_EQ(curve.deficient_at, 11);
  EXPECT_EQ(curve.last, CusumVerdict::deficient);
}

/// Wald: whoever fails at p0 is called deficient first in about alpha of all cases, at p1 competent in about beta; the
/// overshoot makes it rarer. 0.02 is three standard errors of 2,000 runs and more.
TEST(Cusum, ErrsAsOftenAsItSays) {
  std::mt19937 random(7);
  for (const double p : {0.2, 0.4}) {
    std::bernoulli_distribution succeeds(1.0 - p);
    int wrong = 0;
    for (int run = 0; run < 2000; ++run) {
      std::vector<bool> success;
      for (int i = 0; i < 400; ++i) success.push_back(succeeds(random));
      const CusumCurve curve = cusum(success);
      const int first_good = curve.competent_at < 0 ? 1000 : curve.competent_at;
      const int first_bad = curve.deficient_at < 0 ? 1000 : curve.deficient_at;
      ASSERT_NE(first_good, first_bad) << "400 procedures decide";
      wrong += (p == 0.2) == (first_bad < first_good) ? 1 : 0;
    }
    EXPECT_LT(wrong / 2000.0, 0.1 + 0.02) << p;
    EXPECT_GT(wrong / 2000.0, 0.04) << p;
  }
}

TEST(Cusum, ARuleThatIsNoneIsRefused) {
  for (const CusumRule& rule :
       {CusumRule{0.0, 0.4, 0.1, 0.1}, CusumRule{0.4, 0.2, 0.1, 0.1}, CusumRule{0.2, 0.2, 0.1, 0.1},
        CusumRule{0.2, 1.0, 0.1, 0.1}, CusumRule{0.2, 0.4, 0.0, 0.1}, CusumRule{0.2, 0.4, 0.6, 0.4},
        CusumRule{std::nan(""), 0.4, 0.1, 0.1}})
    EXPECT_THROW(cusum_limits(rule), std::invalid_argument);
  EXPECT_THROW(procedures_to_consecutive({true}, 0), std::invalid_argument);
}

TEST(Cusum, CountsToSuccessesInARow) {
  EXPECT_EQ(procedures_to_consecutive({true, false, true, true, true, false}, 3), 5);
  EXPECT_EQ(procedures_to_consecutive({true, true, false, true, true}, 3), -1);
  EXPECT_EQ(procedures_to_consecutive({true}, 1), 1);
  EXPECT_EQ(procedures_to_consecutive({}, 1), -1);
}

}  // namespace
}  // namespace vallecula::curricula
