// What must hold whatever device and scene do.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <random>
#include <thread>

#include "device/drivers/scripted_device.h"
#include "device/guarded_device.h"
#include "tests/device/allocation_guard.h"
#include "tests/device/puppet_device.h"

namespace vallecula::device {
namespace {

constexpr double kTick = 0.001;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A million ticks of a device that fails and a scene that asks for anything.
TEST(GuardedDeviceSafety, AMillionTicksOfFaultsNeverHarmTheHand) {
  for (const bool own_axes : {true, false}) {
    PuppetDevice puppet(own_axes, 1.75);
    GuardSettings settings = guard_for(puppet.info());
    GuardedDevice guard(puppet, settings);
    const double step_n = settings.limits.rate_n_s * settings.limits.period_s;
    std::mt19937_64 random(own_axes ? 1 : 2);
    const auto chance = [&](double p) { return static_cast<double>(random() >> 11) * 0x1.0p-53 < p; };
    const auto number = [&](double size) { return size * (static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0); };
    long long pauses = 0, resumed = 0, clutched = 0, with_force = 0;
    int fault_left = 0;
    bool was_quiet = false;
    Vector hand{0, 0, 0}, force{0, 0, 0};
    constexpr int kTicks = 500000;  // twice: a million in all
    const long long allocated = testing::allocations();
    for (int i = 0; i < kTicks; ++i) {
      if (fault_left == 0 && chance(0.0005)) {
        fault_left = 1 + static_cast<int>(random() % 300);
        puppet.trouble = static_cast<DeviceFault>(1 + random() % 8);
        if (chance(0.3)) puppet.calibrated = Calibration::needs_hand;
      } else if (fault_left > 0 && --fault_left == 0) {
        puppet.trouble = DeviceFault::none;
        puppet.calibrated = Calibration::good;
      }
      for (double& x : hand) x = std::clamp(x + number(2e-4), -0.1, 0.1);
      puppet.reading.position_m = hand;
      if (chance(0.0003)) puppet.reading.position_m[random() % 3] = kNan;
      puppet.reading.rotation_wxyz = chance(0.0003) ? Rotation{0, 0, 0, 0} : about_axis({0, 0, 1}, 0.001 * i);
      puppet.reading.valid = !chance(0.0003);
      puppet.reading.buttons = chance(0.001) ? static_cast<std::uint32_t>(random() % 8) : puppet.reading.buttons;
      if (chance(0.002)) guard.confirm();
      if (chance(0.01)) force = {number(12), number(12), number(12)};
      Vector wanted = force;
      if (chance(0.002)) wanted = {number(1e300), number(1e300), number(1e-300)};
      const bool not_a_number = chance(0.0005);
      if (not_a_number) wanted[random() % 3] = chance(0.5) ? kNan : std::numeric_limits<double>::infinity();

      const Vector before = puppet.heard;
      const DeviceReading reading = guard.read(i * kTick);
      guard.see_tool({0, 0, 0}, {1, 0, 0, 0});
      if (chance(0.0002)) puppet.trouble = DeviceFault::unplugged, fault_left = 100;  // pulled between the two
      const int writes = puppet.writes;
      guard.write(wanted);
      ASSERT_EQ(puppet.writes, writes + 1);
      const Vector sent = puppet.heard;
      ASSERT_TRUE(finite(sent));
      ASSERT_LE(length(sent), settings.limits.peak_force_n);
      const bool zeroed = sent == Vector{0, 0, 0};
      const bool quiet = guard.state() == GuardState::paused || guard.state() == GuardState::confirming;
      ASSERT_TRUE(zeroed || length(subtract(sent, before)) <= step_n + 1e-12) << i;
      ASSERT_TRUE(!(quiet || puppet.trouble != DeviceFault::none || not_a_number) || zeroed) << i;
      // A step to zero beyond the rate limit is a fault's only.
      ASSERT_TRUE(quiet || length(subtract(sent, before)) <= step_n + 1e-12) << i;
      if (was_quiet && !quiet) {
        ASSERT_LE(length(sent), 7.9 * 2 / 500.0) << "taking hold begins from nothing";
      }
      ASSERT_TRUE(!reading.valid || !was_quiet || !quiet || not_a_number || fault_left > 0 ||
                  !finite(reading.position_m));
      pauses += !was_quiet && quiet;
      resumed += was_quiet && !quiet;
      clutched += guard.state() == GuardState::clutched;
      with_force += length(sent) > 1.0;
      was_quiet = quiet;
    }
    EXPECT_EQ(testing::allocations(), allocated);
    EXPECT_GT(pauses, 200);
    EXPECT_GT(resumed, 200);
    EXPECT_GT(with_force, kTicks / 10);
    EXPECT_EQ(clutched > 0, own_axes);
  }
}

/// The laryngoscope in the left hand, the tube in the right: what befalls one does not touch the other.
TEST(GuardedDeviceSafety, TwoDevicesRunAtOnceEachOnItsOwn) {
  PuppetDevice left(true), right(true);
  GuardedDevice left_hand(left, guard_for(left.info())), right_hand(right, guard_for(right.info()));
  left_hand.begin_at({0, 0, 0}, {1, 0, 0, 0});
  right_hand.begin_at({0.1, 0, 0}, {1, 0, 0, 0});
  std::atomic<bool> stop{false}, right_wrong{false};
  std::atomic<int> right_ticks{0};
  std::thread servo([&] {  // its own rate and thread
    for (int i = 0; !stop; ++i) {
      const DeviceReading reading = right_hand.read(i * 0.002);
      right_hand.see_tool(reading.position_m, reading.rotation_wxyz);
      right_hand.write({0, 2, 0});
      if (!reading.valid || length(subtract(reading.position_m, {0.1, 0, 0})) > 1e-12 ||
          (i > 1000 && std::abs(length(right.heard) - 2.0) > 1e-6))
        right_wrong = true;
      right_ticks = i;
    }
  });
  for (int i = 0; i < 20000; ++i) {
    left.trouble = i % 4000 < 2000 ? DeviceFault::none : DeviceFault::motor_warm;
    left_hand.read(i * kTick);
    left_hand.see_tool({0, 0, 0}, {1, 0, 0, 0});
    left_hand.write({6, 0, 0});
    if (left.trouble != DeviceFault::none) {
      ASSERT_EQ(left.heard, (Vector{0, 0, 0}));
    }
  }
  for (int i = 0; i < 2000 && right_ticks < 2000; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  stop = true;
  servo.join();
  EXPECT_GE(right_ticks, 2000);
  EXPECT_FALSE(right_wrong);
  EXPECT_EQ(right_hand.fault(), DeviceFault::none);
  EXPECT_EQ(left_hand.fault(), DeviceFault::motor_warm);
}

/// The paper's case at the device: it gives up at its maximum while the hand keeps pushing, and comes back.
TEST(GuardedDeviceSafety, ADeviceThatGivesUpAtItsMaximumComesBackWhenTheHandDoes) {
  HandSettings hand = firm_hand();
  hand.limit_time_s = 0.2;
  hand.recovery_time_s = 0.3;
  // Into a wall of 2000 N/m at z = 0, 12 mm deep, and slowly back to it.
  ScriptedDevice device(Trajectory({{0, {0, 0, 0.01}}, {1, {0, 0, -0.012}}, {2, {0, 0, -0.012}}, {6, {0, 0, 0.002}}}),
                        hand);
  GuardedDevice guard(device, guard_for(device.info()));
  double tool_z = 0.01, deepest_ghost = 0.0, before = 0.0;
  bool paused = false, resumed = false;
  for (int i = 0; i < 6000; ++i) {
    const DeviceReading reading = guard.read(i * kTick);
    if (reading.valid) tool_z = std::max(reading.position_m[2], -0.0039);  // what the device can bear
    if (!reading.valid) deepest_ghost = std::min(deepest_ghost, reading.position_m[2]);
    guard.see_tool({0, 0, tool_z}, {1, 0, 0, 0});
    const double wanted = std::max(0.0, -2000.0 * (reading.valid ? reading.position_m[2] : 0.0));
    const double sent = length(guard.write({0, 0, wanted}));
    paused |= guard.state() == GuardState::paused && guard.fault() == DeviceFault::force_exceeded;
    if (paused && guard.state() == GuardState::working) resumed = true;
    ASSERT_LE(sent - before, 0.4 + 1e-12);
    before = sent;
  }
  EXPECT_TRUE(paused);
  EXPECT_LT(deepest_ghost, -0.0115) << "the ghost shows the hand";
  EXPECT_TRUE(resumed);
  EXPECT_EQ(guard.state(), GuardState::working);
}

}  // namespace
}  // namespace vallecula::device
