#include "device/drivers/mouse_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <random>
#include <thread>
#include <utility>

#include "device/rotation.h"
#include "tests/device/allocation_guard.h"

namespace vallecula::device {
namespace {

constexpr double kTick = 0.001;

DeviceReading run(MouseDevice& mouse, int& tick, int ticks) {
  DeviceReading reading;
  for (int i = 0; i < ticks; ++i, ++tick) {
    reading = mouse.read(tick * kTick);
    mouse.write({0, 0, 0});
  }
  return reading;
}

TEST(MouseDevice, ArrivesWhereItWasMoved) {
  MouseDevice mouse;
  mouse.place({0.1, 0.2, 0.3}, {1, 0, 0, 0});
  mouse.set_view_axes({0, 1, 0}, {0, 0, 1}, {1, 0, 0});
  int tick = 0;
  EXPECT_EQ(run(mouse, tick, 1).position_m, (Vector{0.1, 0.2, 0.3}));
  mouse.move(0.02, -0.01);
  mouse.advance(0.03);
  const DeviceReading reading = run(mouse, tick, 2000);
  EXPECT_LT(length(subtract(reading.position_m, {0.13, 0.22, 0.29})), 1e-9);
  EXPECT_TRUE(reading.valid);
}

TEST(MouseDevice, StepsBecomeSmoothMotionWithinTheSpeed) {
  const MouseSettings settings;
  MouseDevice mouse(settings);
  mouse.place({0, 0, 0}, {1, 0, 0, 0});
  std::mt19937 random(4);
  std::uniform_real_distribution<double> step(-0.03, 0.03), angle(-0.3, 0.3);
  int tick = 0;
  DeviceReading before = run(mouse, tick, 1);
  double last_speed = 0.0, largest_change = 0.0;
  for (int event = 0; event < 300; ++event) {
    mouse.move(step(random), step(random));
    mouse.turn(angle(random), angle(random), angle(random));
    for (int i = 0; i < 16; ++i) {  // a mouse speaks about every 16 ms
      const DeviceReading now = run(mouse, tick, 1);
      const double speed = length(subtract(now.position_m, before.position_m)) / kTick;
      ASSERT_LE(speed, settings.max_speed_m_s * (1 + 1e-9));
      ASSERT_LE(angle_between(before.rotation_wxyz, now.rotation_wxyz) / kTick, settings.max_turn_rad_s * 1.001);
      ASSERT_NEAR(dot(now.rotation_wxyz, now.rotation_wxyz), 1.0, 1e-12);
      largest_change = std::max(largest_change, std::abs(speed - last_speed));
      last_speed = speed;
      before = now;
    }
  }
  // Two low-passes of 20 ms: speed changes by at most 2 * max_speed * 1 ms / 20 ms a tick.
  EXPECT_LE(largest_change, 2.0 * settings.max_speed_m_s * kTick / settings.smoothing_s);
}

TEST(MouseDevice, LiftsAlongTheHandleWhileTheKeyIsHeldAndStays) {
  const MouseSettings settings;
  MouseDevice mouse(settings);
  const Rotation pose = about_axis({1, 0, 0}, M_PI / 2);  // the handle, tool +z, points along world -y
  mouse.place({0, 0, 0}, pose);
  int tick = 0;
  run(mouse, tick, 10);
  mouse.set_lift(1.0);
  run(mouse, tick, 500);
  mouse.set_lift(0.0);
  const DeviceReading held = run(mouse, tick, 1000);
  EXPECT_NEAR(mouse.lift_m(), 0.5 * settings.lift_speed_m_s, 1e-9);
  EXPECT_LT(length(subtract(held.position_m, {0, -0.5 * settings.lift_speed_m_s, 0})), 1e-9);
  mouse.set_lift(1.0);
  run(mouse, tick, 10000);
  EXPECT_NEAR(mouse.lift_m(), settings.lift_range_m, 1e-9);
  mouse.set_lift(-1.0);
  run(mouse, tick, 10000);
  EXPECT_NEAR(mouse.lift_m(), 0.0, 1e-9);
}

TEST(MouseDevice, ComesLevelAsItRisesAndGoesBackAsItIsLowered) {
  const MouseSettings settings;
  MouseDevice mouse(settings);
  const Rotation pose = about_axis({1, 0, 0}, M_PI / 2);
  mouse.place({0, 0, 0}, pose);
  int tick = 0;
  run(mouse, tick, 10);
  mouse.set_lift(1.0);
  run(mouse, tick, 1000);
  mouse.set_lift(0.0);
  DeviceReading held = run(mouse, tick, 1000);
  const double turn = settings.lift_speed_m_s * settings.lift_levels_rad_m;
  EXPECT_LT(angle_between(held.rotation_wxyz, multiply(pose, about_axis({0, 1, 0}, turn))), 1e-6);
  EXPECT_LT(length(subtract(held.position_m, {0, -settings.lift_speed_m_s, 0})), 1e-9) << "the tip goes straight";
  mouse.set_lift(-1.0);
  held = run(mouse, tick, 3000);
  EXPECT_LT(angle_between(held.rotation_wxyz, pose), 1e-6);
}

TEST(MouseDevice, TheKeyLiftsSlowerTheHarderTheTissuePullsAndLowersAsEver) {
  const MouseSettings settings;
  MouseDevice mouse(settings);
  int tick = 0;
  run(mouse, tick, 10);
  const auto lifted_in_a_second = [&](double force_n, double limit_n, double direction) {
    const double from = mouse.lift_m();
    mouse.set_lift(direction);
    for (int frame = 0; frame < 10; ++frame) {
      mouse.feel(force_n, limit_n);
      run(mouse, tick, 100);
    }
    mouse.set_lift(0.0);
    run(mouse, tick, 500);
    return mouse.lift_m() - from;
  };
  // The same force against two devices: what is half of the one's share is all of the other's.
  const double share = settings.lift_force_share, speed = settings.lift_speed_m_s;
  EXPECT_NEAR(lifted_in_a_second(0.0, 8.0, 1.0), speed, 1e-9);
  EXPECT_NEAR(lifted_in_a_second(2.0 * share, 4.0, 1.0), 0.5 * speed, 1e-9);
  EXPECT_NEAR(lifted_in_a_second(2.0 * share, 2.0, 1.0), 0.0, 1e-9);
  EXPECT_NEAR(lifted_in_a_second(7.0, 8.0, 1.0), 0.0, 1e-9);
  EXPECT_NEAR(lifted_in_a_second(7.0, 8.0, -1.0), -speed, 1e-9);
}

TEST(MouseDevice, WhatIsNoNumberIsNotFelt) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const std::pair<double, double> none[] = {{nan, 8.0},      {infinite, 8.0}, {1.0, nan},
                                            {1.0, infinite}, {1.0, 0.0},      {1.0, -8.0}};
  for (const auto& [force_n, limit_n] : none) {
    const MouseSettings settings;
    MouseDevice mouse(settings);
    int tick = 0;
    run(mouse, tick, 10);
    mouse.feel(4.0 * settings.lift_force_share, 8.0);
    mouse.feel(force_n, limit_n);
    mouse.set_lift(1.0);
    run(mouse, tick, 200);
    mouse.set_lift(0.0);
    run(mouse, tick, 500);
    EXPECT_NEAR(mouse.lift_m(), 0.5 * 0.2 * settings.lift_speed_m_s, 1e-9) << "as it was told last";
  }
}

TEST(MouseDevice, TheLiftStopsWhenNothingIsFeltAnyLongerThoughTheKeyIsHeld) {
  const MouseSettings settings;
  const double limit_n = 8.0, half_n = 0.5 * settings.lift_force_share * limit_n;
  MouseDevice mouse(settings);
  int tick = 0;
  run(mouse, tick, 10);
  mouse.feel(half_n, limit_n);
  mouse.set_lift(1.0);
  run(mouse, tick, 2000);  // the window stands
  const double stood = mouse.lift_m();
  EXPECT_NEAR(stood, 0.5 * settings.feel_age_s * settings.lift_speed_m_s, 2 * kTick * settings.lift_speed_m_s);
  mouse.move(0.001, 0.0);
  run(mouse, tick, 500);
  EXPECT_NEAR(mouse.lift_m(), stood, 1e-9) << "that the hand moved tells no force";
  mouse.place({0, 0, 0}, {1, 0, 0, 0});
  mouse.set_lift(1.0);
  run(mouse, tick, 500);
  EXPECT_EQ(mouse.lift_m(), 0.0) << "nor does a reset";
  mouse.feel(half_n, limit_n);
  run(mouse, tick, 200);
  mouse.set_lift(-1.0);
  EXPECT_GT(mouse.lift_m(), 0.0) << "the next frame lets it go on";
  run(mouse, tick, 2000);
  EXPECT_NEAR(mouse.lift_m(), 0.0, 1e-9) << "lowered as ever";
}

TEST(MouseDevice, TurnsAboutTheTip) {
  MouseDevice mouse;
  mouse.place({0.01, 0, 0}, {1, 0, 0, 0});
  int tick = 0;
  mouse.turn(0.4, 0, 0);
  const DeviceReading reading = run(mouse, tick, 2000);
  EXPECT_LT(length(subtract(reading.position_m, {0.01, 0, 0})), 1e-12);
  EXPECT_NEAR(angle_between(reading.rotation_wxyz, about_axis({0, 1, 0}, 0.4)), 0.0, 1e-7);
}

TEST(MouseDevice, PlaceJumpsAndForgetsTheLift) {
  MouseDevice mouse;
  int tick = 0;
  mouse.set_lift(1.0);
  mouse.move(0.05, 0.05);
  run(mouse, tick, 1000);
  mouse.place({0.3, 0.2, 0.1}, {0, 1, 0, 0});
  const DeviceReading reading = run(mouse, tick, 1);
  EXPECT_EQ(reading.position_m, (Vector{0.3, 0.2, 0.1}));
  EXPECT_EQ(reading.rotation_wxyz, (Rotation{0, 1, 0, 0}));
  EXPECT_EQ(mouse.lift_m(), 0.0);
}

TEST(MouseDevice, StaysInItsWorkspaceAndIgnoresWhatIsNoNumber) {
  const MouseSettings settings;
  MouseDevice mouse(settings);
  mouse.place({1, 1, 1}, {1, 0, 0, 0});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  int tick = 0;
  for (int i = 0; i < 200; ++i) {
    mouse.move(0.01, 0.02);
    mouse.move(nan, 0.0);
    mouse.advance(std::numeric_limits<double>::infinity());
    mouse.turn(nan, 0, 0);
    mouse.set_lift(nan);
    const DeviceReading reading = run(mouse, tick, 50);
    ASSERT_TRUE(finite(reading.position_m));
    ASSERT_LE(length(subtract(reading.position_m, {1, 1, 1})), settings.workspace_m * (1 + 1e-12));
  }
  mouse.place({nan, 0, 0}, {1, 0, 0, 0});
  EXPECT_TRUE(finite(run(mouse, tick, 10).position_m));
}

TEST(MouseDevice, ButtonsPassThrough) {
  MouseDevice mouse;
  int tick = 0;
  mouse.set_buttons(5);
  EXPECT_EQ(run(mouse, tick, 1).buttons, 5u);
}

TEST(MouseDevice, ReadsOnlyWholePosesWhileTheWindowWrites) {
  MouseDevice mouse;
  mouse.set_view_axes({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  std::atomic<bool> stop{false};
  std::thread window([&] {
    for (int i = 0; !stop; ++i) mouse.place({i * 1e-6, i * 2e-6, i * 3e-6}, {1, 0, 0, 0});
  });
  double last = -1.0;
  for (int tick = 0; tick < 200000; ++tick) {
    const Vector p = mouse.read(tick * kTick).position_m;
    ASSERT_NEAR(p[1], 2 * p[0], 1e-12 + 1e-12 * p[1]);  // the three belong to one call of place()
    ASSERT_NEAR(p[2], 3 * p[0], 1e-12 + 1e-12 * p[2]);
    ASSERT_GE(p[0], last);
    last = p[0];
  }
  stop = true;
  window.join();
}

TEST(MouseDevice, TicksAllocateNothing) {
  MouseDevice mouse;
  const long long before = testing::allocations();
  for (int i = 0; i < 2000; ++i) {
    mouse.move(0.001, 0);
    mouse.turn(0.001, 0, 0);
    mouse.set_lift(1);
    mouse.feel(1.0, 7.9);
    mouse.read(i * kTick);
    mouse.write({1, 0, 0});
  }
  EXPECT_EQ(testing::allocations(), before);
}

TEST(MouseDevice, RefusesSettingsThatCannotWork) {
  MouseSettings settings;
  settings.max_speed_m_s = 0.0;
  EXPECT_THROW(MouseDevice{settings}, DeviceError);
  settings = {};
  settings.smoothing_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(MouseDevice{settings}, DeviceError);
}

}  // namespace
}  // namespace vallecula::device
