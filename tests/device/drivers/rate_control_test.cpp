#include "device/drivers/spacemouse/rate_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "device/rotation.h"
#include "tests/device/allocation_guard.h"

namespace vallecula::device {
namespace {

constexpr double kStep = 0.001;

/// A cap held like this reports every 8 ms; `ticks` of 1 ms from `time_s` on.
DeviceReading hold_cap(RateControl& rate, SpaceMouseState& cap, double& time_s, int ticks) {
  DeviceReading reading;
  for (int i = 0; i < ticks; ++i) {
    if (i % 8 == 0) ++cap.translation_reports, ++cap.rotation_reports;
    reading = rate.step(cap, time_s += kStep);
  }
  return reading;
}

/// A first-order low-pass of time constant tau lags a ramp by tau: after t the way is v (t - tau), the exponential
/// gone.
TEST(RateControl, MovesAtTheStatedGainAlongTheDevicesAxes) {
  const RateSettings settings;
  struct Case {
    std::array<std::int16_t, 3> pushed;
    Vector direction;  ///< right, up, towards the person
  };
  for (const Case& c : {Case{{350, 0, 0}, {1, 0, 0}}, Case{{0, 350, 0}, {0, 0, 1}}, Case{{0, 0, 350}, {0, -1, 0}},
                        Case{{-350, 0, 0}, {-1, 0, 0}}, Case{{0, 0, -350}, {0, 1, 0}}}) {
    RateControl rate(settings);
    SpaceMouseState cap;
    cap.translation = c.pushed;
    double time_s = 0.0;
    rate.step(cap, time_s);
    const DeviceReading reading = hold_cap(rate, cap, time_s, 1000);
    const double way = settings.max_speed_m_s * (1.0 - settings.smoothing_s);
    for (std::size_t i = 0; i < 3;
         ++i)  // a millisecond's step: the sum of the discrete low-pass differs by half a tick
      EXPECT_NEAR(reading.position_m[i], way * c.direction[i], settings.max_speed_m_s * kStep);
    EXPECT_EQ(reading.rotation_wxyz, (Rotation{1, 0, 0, 0}));
  }
}

TEST(RateControl, HalfTheWayBeyondTheDeadZoneIsHalfTheSpeed) {
  const RateSettings settings;
  RateControl rate(settings);
  SpaceMouseState cap;
  cap.translation[0] = static_cast<std::int16_t>(std::lround(350 * (1.0 + settings.dead_zone) / 2.0));
  double time_s = 0.0;
  const double begin = hold_cap(rate, cap, time_s, 1000).position_m[0];
  const double end = hold_cap(rate, cap, time_s, 1000).position_m[0];
  EXPECT_NEAR(end - begin, 0.5 * settings.max_speed_m_s, 0.002 * settings.max_speed_m_s);  // counts are whole
}

TEST(RateControl, TurnsAboutTheDevicesAxesThroughTheTip) {
  const RateSettings settings;
  struct Case {
    std::array<std::int16_t, 3> turned;
    Vector axis;
  };
  for (const Case& c : {Case{{350, 0, 0}, {1, 0, 0}}, Case{{0, 350, 0}, {0, 0, 1}}, Case{{0, 0, 350}, {0, -1, 0}}}) {
    RateControl rate(settings);
    SpaceMouseState cap;
    cap.rotation = c.turned;
    double time_s = 0.0;
    rate.step(cap, time_s);
    const DeviceReading reading = hold_cap(rate, cap, time_s, 1000);
    const Rotation expected = about_axis(c.axis, settings.max_turn_rad_s * (1.0 - settings.smoothing_s));
    EXPECT_LT(angle_between(reading.rotation_wxyz, expected), settings.max_turn_rad_s * kStep);
    EXPECT_EQ(reading.position_m, (Vector{0, 0, 0}));
  }
  // The second turn is about the device's axis, not the turned blade's.
  RateControl rate(settings);
  SpaceMouseState cap;
  double time_s = 0.0;
  cap.rotation = {350, 0, 0};
  const Rotation first = hold_cap(rate, cap, time_s, 700).rotation_wxyz;
  cap.rotation = {0, 350, 0};
  const Rotation both = hold_cap(rate, cap, time_s, 700).rotation_wxyz;
  const Rotation second = multiply(both, {first[0], -first[1], -first[2], -first[3]});
  const double about_z = std::abs(second[3]) / length({second[1], second[2], second[3]});
  EXPECT_GT(about_z, 0.999) << "the low-pass lets a little of the first turn into the second";
}

TEST(RateControl, HandsOffStandsStillToTheBit) {
  RateControl rate;
  SpaceMouseState cap;
  cap.translation = {300, -200, 100};
  cap.rotation = {100, 200, -300};
  double time_s = 0.0;
  hold_cap(rate, cap, time_s, 500);
  cap.translation = {20, -20, 0};  // a cap at rest is a few counts off
  cap.rotation = {0, 15, -20};
  const DeviceReading rest = hold_cap(rate, cap, time_s, 300);
  const DeviceReading later = hold_cap(rate, cap, time_s, 5000);
  EXPECT_EQ(later.position_m, rest.position_m);
  EXPECT_EQ(later.rotation_wxyz, rest.rotation_wxyz);
}

TEST(RateControl, ADeviceThatFallsSilentStopsTheBlade) {
  const RateSettings settings;
  RateControl rate(settings);
  SpaceMouseState cap;
  cap.translation = {350, 0, 0};
  cap.rotation = {0, 0, 350};
  double time_s = 0.0;
  const double begin = hold_cap(rate, cap, time_s, 505).position_m[0];  // the last report came in the last tick
  for (int i = 0; i < 99; ++i) rate.step(cap, time_s += kStep);
  const double silent = rate.step(cap, time_s).position_m[0];
  EXPECT_NEAR(silent - begin, 0.099 * settings.max_speed_m_s, 1e-9) << "a gap shorter than that is nothing";
  DeviceReading rest;
  for (int i = 0; i < 200; ++i) rest = rate.step(cap, time_s += kStep);
  EXPECT_LT(rest.position_m[0] - silent, settings.max_speed_m_s * (settings.smoothing_s + 3 * kStep));
  for (int i = 0; i < 2000; ++i) {
    const DeviceReading now = rate.step(cap, time_s += kStep);
    ASSERT_EQ(now.position_m, rest.position_m);
    ASSERT_EQ(now.rotation_wxyz, rest.rotation_wxyz);
  }
  EXPECT_GT(hold_cap(rate, cap, time_s, 100).position_m[0], rest.position_m[0]) << "it reports again: it moves again";
}

/// Old models tell translation and rotation by reports of their own: one that falls silent does not live on the other.
TEST(RateControl, EachHalfFallsSilentByItself) {
  RateControl rate;
  SpaceMouseState cap;
  cap.translation = {350, 0, 0};
  cap.rotation = {0, 0, 350};
  double time_s = 0.0;
  hold_cap(rate, cap, time_s, 300);
  DeviceReading before, after;
  for (int i = 0; i < 1000; ++i) {
    if (i % 8 == 0) ++cap.rotation_reports;
    after = rate.step(cap, time_s += kStep);
    if (i == 400) before = after;
  }
  EXPECT_EQ(after.position_m, before.position_m);
  EXPECT_GT(angle_between(after.rotation_wxyz, before.rotation_wxyz), 0.5);
}

/// Any reports at any times: never faster than stated, never out of the cube, always a pose.
TEST(RateControl, StaysWithinItsBoundsWhateverComes) {
  const RateSettings settings;
  RateControl rate(settings);
  SpaceMouseState cap;
  std::mt19937 random(3);
  double time_s = 0.0;
  DeviceReading last = rate.step(cap, time_s);
  const long long allocated = testing::allocations();
  for (int i = 0; i < 1000000; ++i) {
    if (random() % 7 == 0) {
      for (auto& count : cap.translation) count = static_cast<std::int16_t>(random());
      ++cap.translation_reports;
    }
    if (random() % 7 == 0) {
      for (auto& count : cap.rotation) count = static_cast<std::int16_t>(random());
      ++cap.rotation_reports;
    }
    double step = kStep;
    if (random() % 1000 == 0) step = 0.001 * (random() % 3000);
    if (random() % 1000 == 0) step = -1.0;
    const double told = random() % 1000 == 0 ? std::numeric_limits<double>::quiet_NaN() : (time_s += step);
    const DeviceReading now = rate.step(cap, told);
    const double bound_s = 0.05 + 1e-12;  // a longer pause counts as this
    const double lasted = std::isfinite(told) ? std::min(std::max(step, kStep) + kStep, bound_s) : kStep;
    ASSERT_LE(length(subtract(now.position_m, last.position_m)), settings.max_speed_m_s * lasted * (1 + 1e-9)) << i;
    ASSERT_LE(angle_between(now.rotation_wxyz, last.rotation_wxyz), settings.max_turn_rad_s * lasted + 1e-7) << i;
    for (const double x : now.position_m) ASSERT_LE(std::abs(x), 0.5 * settings.workspace_m);
    ASSERT_NEAR(dot(now.rotation_wxyz, now.rotation_wxyz), 1.0, 1e-12);
    last = now;
  }
  EXPECT_EQ(testing::allocations(), allocated);
}

TEST(RateControl, HeldForAGoneDeviceItCatchesNothingUp) {
  RateControl rate;
  SpaceMouseState cap;
  cap.translation = {350, 0, 0};
  cap.buttons = 1;
  double time_s = 0.0;
  const DeviceReading last = hold_cap(rate, cap, time_s, 400);
  const DeviceReading held = rate.hold(time_s += 5.0);
  EXPECT_EQ(held.position_m, last.position_m);
  EXPECT_EQ(held.buttons, 0u);
  ++cap.translation_reports;
  const DeviceReading next = rate.step(cap, time_s += kStep);
  EXPECT_LT(next.position_m[0] - last.position_m[0], RateSettings{}.max_speed_m_s * kStep);
}

TEST(RateControl, RefusesSettingsThatMeanNothing) {
  const double inf = std::numeric_limits<double>::infinity();
  for (double RateSettings::*field :
       {&RateSettings::max_speed_m_s, &RateSettings::max_turn_rad_s, &RateSettings::full_counts,
        &RateSettings::dead_zone, &RateSettings::smoothing_s, &RateSettings::silence_s, &RateSettings::workspace_m}) {
    for (const double value : {0.0, -1.0, inf, std::nan("")}) {
      RateSettings settings;
      settings.*field = value;
      EXPECT_THROW(RateControl{settings}, DeviceError);
    }
  }
  RateSettings settings;
  settings.dead_zone = 1.0;
  EXPECT_THROW(RateControl{settings}, DeviceError);
}

}  // namespace
}  // namespace vallecula::device
