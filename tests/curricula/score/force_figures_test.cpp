#include "curricula/score/force_figures.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/curricula/score/hand_made_intubation.h"

namespace vallecula::curricula {
namespace {

using namespace testing;

ForceFigures figures_of(const Change& change) { return score_of(change).force; }

/// The tongue presses the blade down with 3 N from 6 to 8 s; `gum_n` upwards from 7 to 8 s. The handle points along z.
Change pressed(double gum_n) {
  return [gum_n](LogTick& t) {
    if (between(t, 6, 8)) t.loads[kTongue].force_n = {0, 0, -3};
    if (between(t, 7, 8)) t.loads[kGum].force_n = {0, 0, gum_n};
  };
}

TEST(ForceFigures, MeanAndIntegralOfAConstantForceAreItsOwn) {
  const ForceFigures f = figures_of([](LogTick& t) {
    if (between(t, 6, 8)) t.loads[kTongue].force_n = {0, -2.4, 3.2};  // 4 N
  });
  EXPECT_NEAR(f.tongue_contact_s, 2.0, 1e-9);
  EXPECT_NEAR(f.tongue_integral_ns, 8.0, 1e-9);
  EXPECT_NEAR(*f.mean_tongue_n, 4.0, 1e-12);
}

TEST(ForceFigures, MeanAndIntegralOfARamp) {
  // 0 to 6 N within 3 s: mean 3 N, 9 N s; the last tick is 1 ms short of the end.
  const ForceFigures f = figures_of([](LogTick& t) {
    if (between(t, 6, 9)) t.loads[kTongue].force_n = {2.0 * (t.time_s - 6.0), 0, 0};
  });
  EXPECT_NEAR(f.tongue_integral_ns, 9.0, 0.004);
  EXPECT_NEAR(*f.mean_tongue_n, 3.0, 0.002);
}

TEST(ForceFigures, NothingTouchedIsNoMeanAndNoShare) {
  const ForceFigures f = figures_of({});
  EXPECT_FALSE(f.mean_tongue_n);
  EXPECT_FALSE(f.lift_share);
  EXPECT_EQ(f.tongue_integral_ns, 0.0);
  EXPECT_EQ(f.levered_n.at_s, -1.0);
}

TEST(ForceFigures, WhatTheGumBearsIsLevered) {
  const ForceFigures lifted = figures_of(pressed(0.0)), levered = figures_of(pressed(1.5));
  EXPECT_NEAR(*lifted.lift_share, 1.0, 1e-12);
  // 1.5 N of 3 N in the second of two seconds: a quarter of 6 N s.
  EXPECT_NEAR(*levered.lift_share, 0.75, 1e-12);
  EXPECT_NEAR(levered.levered_n.value, 1.5, 1e-12);
  EXPECT_NEAR(levered.levered_n.at_s, 7.0, 1e-9);
  EXPECT_EQ(levered.levered_over_target_s, 0.0) << "the gums' target is 2 N";
  const ForceFigures hard = figures_of(pressed(2.5));
  EXPECT_NEAR(hard.levered_over_target_s, 1.0, 1e-9);
  EXPECT_NEAR(hard.levered_over_target_at_s, 7.0, 1e-9);
}

TEST(ForceFigures, AFulcrumBearsNoMoreThanThereIs) {
  // A handle pulled back presses the gum with more than the tongue's load: all of that is levered, not more.
  EXPECT_NEAR(*figures_of(pressed(9.0)).lift_share, 0.5, 1e-12);
  // The lower gum pushes the other way: not a fulcrum.
  EXPECT_NEAR(*figures_of(pressed(-2.0)).lift_share, 1.0, 1e-12);
}

TEST(ForceFigures, TheAxisIsTheHandlesHoweverTheBladeIsTurned) {
  // Turned by 90 degrees about x the handle points along -y.
  const ForceFigures f = figures_of([](LogTick& t) {
    t.proxy_pose.rotation_wxyz = {std::sqrt(0.5), std::sqrt(0.5), 0, 0};
    if (!between(t, 6, 8)) return;
    t.loads[kTongue].force_n = {1, 2, 0};
    t.loads[kEpiglottis].force_n = {0, 1, 1};
    t.loads[kPalate].force_n = {0, -0.75, 4};
  });
  EXPECT_NEAR(*f.lift_share, 0.75, 1e-12);
}

TEST(ForceFigures, PressureIsForceByArea) {
  const Change change = [](LogTick& t) {
    if (between(t, 6, 7)) t.loads[kTongue] = {{0, 0, -2}, {}, 9, 80e-6};
    if (between(t, 7, 8)) t.loads[kTongue] = {{0, 0, -3}, {}, 9, 150e-6};
    if (between(t, 8, 9)) t.loads[kTongue] = {{0, 0, -0.4}, {}, 1, 1e-6};  // too little to tell
    if (between(t, 9, 10)) t.loads[kTongue] = {{0, 0, -4}, {}, 9, 0.0};    // its area is not known
  };
  const ForceFigures f = figures_of(change);
  ASSERT_TRUE(f.tongue_pressure_pa);
  EXPECT_NEAR(f.tongue_pressure_pa->value, 25e3, 1e-6);
  EXPECT_NEAR(f.tongue_pressure_pa->at_s, 6.0, 1e-9);
  EXPECT_FALSE(figures_of(pressed(0.0)).tongue_pressure_pa) << "a log of an older schema";
}

TEST(ForceFigures, PausesAndForcesThatAreNoNumbersCountForNothing) {
  const auto change = [](LogTick& t) {
    pressed(1.5)(t);
    if (between(t, 6.5, 7.5)) t.device_valid = false;
    if (t.tick == 7700) t.loads[kLarynx].force_n[1] = std::numeric_limits<double>::quiet_NaN();
  };
  const ForceFigures f = figures_of(change);
  EXPECT_NEAR(f.tongue_contact_s, 0.999, 1e-9);
  EXPECT_NEAR(f.tongue_integral_ns, 2.997, 1e-9);
  EXPECT_NEAR(f.levered_n.at_s, 7.5, 1e-9);
}

}  // namespace
}  // namespace vallecula::curricula
