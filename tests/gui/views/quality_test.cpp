// The governor's rule on made-up clocks: resolution before effects before frame rate, and no to and fro.
#include "gui/views/quality.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace vallecula::gui {
namespace {

/// Draws for so long; a frame at step s keeps the window for cost(s), and frames come as fast as that allows, at most
/// 30 a second. The steps taken.
template <class Cost>
std::vector<int> steps_over(QualityGovernor& governor, double seconds, Cost cost, double from_s = 0.0) {
  std::vector<int> steps{governor.step()};
  for (double now = from_s; now < from_s + seconds;) {
    const double busy = cost(governor.step());
    now += std::max(busy, QualityGovernor::kFrameS);
    if (governor.frame(now, busy)) steps.push_back(governor.step());
  }
  return steps;
}

TEST(QualityGovernor, GivesUpResolutionThenEffectsOneAfterTheOther) {
  for (std::size_t i = 1; i < kQualities.size(); ++i) {
    EXPECT_LE(kQualities[i].resolution, kQualities[i - 1].resolution);
    EXPECT_FALSE(kQualities[i] == kQualities[i - 1]);
    EXPECT_FALSE(kQualities[i].resolution > 0.6 && !(kQualities[i].rim && kQualities[i].shadows));
  }
  QualityGovernor governor;
  EXPECT_TRUE(governor.reduced().isEmpty());
  const auto steps = steps_over(governor, 20.0, [](int) { return 0.050; });
  ASSERT_EQ(steps.size(), kQualities.size());
  for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_EQ(steps[i], static_cast<int>(i));
  EXPECT_TRUE(governor.reduced().contains("50 %")) << governor.reduced().toStdString();
}

TEST(QualityGovernor, KeepsEverythingWhereTheGoalIsKept) {
  QualityGovernor governor;
  EXPECT_EQ(steps_over(governor, 20.0, [](int) { return 0.029; }).size(), 1u);
}

TEST(QualityGovernor, TakesItBackWhenTheMachineIsFreeAgainAndDoesNotChaseItself) {
  QualityGovernor governor;
  steps_over(governor, 20.0, [](int) { return 0.050; });
  const auto back = steps_over(
      governor, 60.0, [](int) { return 0.010; }, 20.0);
  EXPECT_EQ(back.back(), 0);
  // Whatever the machine: costs by pixels (0.5 squared to 1), with a part that no step takes away.
  for (const double fixed_ms : {0.0, 8.0, 20.0})
    for (double full_ms = 5.0; full_ms < 150.0; full_ms *= 1.15) {
      QualityGovernor g;
      const auto cost = [&](int step) {
        const Quality& q = kQualities[static_cast<std::size_t>(step)];
        const double effects = (q.rim ? 0.04 : 0.0) + (q.shadows ? 0.06 : 0.0) + (q.coarser == 0 ? 0.03 : 0.0);
        return 1e-3 * (fixed_ms + full_ms * (0.87 + effects) * q.resolution * q.resolution);
      };
      const auto steps = steps_over(g, 60.0, cost);
      for (std::size_t i = 1; i < steps.size(); ++i)
        EXPECT_GT(steps[i], steps[i - 1]) << "to and fro at " << full_ms << " + " << fixed_ms << " ms";
    }
}

/// As measured of two views without a graphics card (gui/README.md): step 2 is just at the limit, step 3 has room.
double two_views_s(int step) {
  const std::array<double, 7> quiet_ms{41, 36, 29, 27, 26, 24, 20};
  return 1e-3 * quiet_ms[static_cast<std::size_t>(step)];
}

TEST(QualityGovernor, AfterABusyMomentTheFinestStepThatTheMachineKeepsIsTakenBack) {
  for (double busy_s = 1.0; busy_s <= 20.0; busy_s += 0.5) {
    QualityGovernor governor;
    steps_over(governor, busy_s, [](int step) { return 2.0 * two_views_s(step); });
    steps_over(governor, 300.0, two_views_s, busy_s);
    EXPECT_LE(governor.step(), 3) << busy_s;
    EXPECT_GE(governor.step(), 2) << busy_s;
    EXPECT_EQ(steps_over(governor, 60.0, two_views_s, busy_s + 300.0).size(), 1u) << "it stays there: " << busy_s;
  }
}

TEST(QualityGovernor, ALoadThatComesAndGoesIsNotFollowedForEver) {
  QualityGovernor governor;
  std::size_t changes = 0;
  for (double now = 0.0; now < 600.0; now += 16.0) {
    changes += steps_over(
                   governor, 8.0, [](int step) { return 1.35 * two_views_s(step); }, now)
                   .size() -
               1;
    changes += steps_over(governor, 8.0, two_views_s, now + 8.0).size() - 1;
  }
  EXPECT_LT(changes, 40u) << "of the picture's sharpness, in ten minutes";
}

TEST(QualityGovernor, APauseOfTheTrialCountsNeitherWay) {
  QualityGovernor governor;
  steps_over(governor, 5.0, [](int) { return 0.025; });
  EXPECT_FALSE(governor.frame(500.0, 30.0)) << "one frame minutes later";
  EXPECT_EQ(steps_over(
                governor, 5.0, [](int) { return 0.025; }, 500.0)
                .size(),
            1u);
}

TEST(QualityGovernor, HighAndLowStay) {
  QualityGovernor governor;
  governor.set_mode(QualityGovernor::mode_of("low"));
  EXPECT_EQ(steps_over(governor, 10.0, [](int) { return 0.001; }), std::vector<int>{governor.step()});
  EXPECT_EQ(governor.quality().resolution, 0.5);
  governor.set_mode(QualityGovernor::mode_of("high"));
  EXPECT_EQ(steps_over(governor, 10.0, [](int) { return 0.2; }), std::vector<int>{0});
  governor.set_mode(QualityGovernor::mode_of("auto"));
  EXPECT_GT(steps_over(governor, 10.0, [](int) { return 0.2; }).size(), 1u);
  EXPECT_EQ(QualityGovernor::mode_of("?"), QualityGovernor::Mode::automatic);
}

}  // namespace
}  // namespace vallecula::gui
