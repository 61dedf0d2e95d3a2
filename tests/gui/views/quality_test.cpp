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

TEST(QualityGovernor, AfterABusyMomentTheFinestStepThatTheMachineKeepsIsTakenBack) {
  // As measured of two views without a graphics card, ms (gui/README.md): step 2 is just at the limit, step 3 has room.
  const std::array<double, 7> quiet_ms{41, 36, 29, 27, 26, 24, 20};
  const auto at_load = [&](double load) {
    return [&quiet_ms, load](int step) { return 1e-3 * load * quiet_ms[static_cast<std::size_t>(step)]; };
  };
  QualityGovernor governor;
  const auto down = steps_over(governor, 20.0, at_load(2.0));
  EXPECT_EQ(down.back(), 6);
  const auto up = steps_over(governor, 60.0, at_load(1.0), 20.0);
  EXPECT_EQ(up.back(), 3);
  for (std::size_t i = 1; i < up.size(); ++i) EXPECT_LT(up[i], up[i - 1]) << "to and fro";
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
