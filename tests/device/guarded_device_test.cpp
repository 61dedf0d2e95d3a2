#include "device/guarded_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <random>
#include <thread>

#include "device/drivers/scripted_device.h"
#include "device/rotation.h"
#include "tests/device/allocation_guard.h"

namespace vallecula::device {
namespace {

constexpr double kTick = 0.001;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A device that does as it is told.
class Puppet final : public HapticDevice {
 public:
  explicit Puppet(bool own_axes, double continuous_n = 0.0) : own_axes_(own_axes), continuous_n_(continuous_n) {}
  DeviceInfo info() const override {
    DeviceInfo info;
    info.kind = "puppet";
    info.peak_force_n = 7.9;
    info.continuous_force_n = continuous_n_;
    info.own_axes = own_axes_;
    return info;
  }
  DeviceReading read(double) noexcept override { return reading; }
  void write(const std::array<double, 3>& force_n) noexcept override { heard = force_n, ++writes; }
  DeviceFault fault() const noexcept override { return trouble; }
  Calibration calibration() const noexcept override { return calibrated; }

  DeviceReading reading;
  DeviceFault trouble = DeviceFault::none;
  Calibration calibrated = Calibration::good;
  Vector heard{0, 0, 0};
  int writes = 0;

 private:
  bool own_axes_;
  double continuous_n_;
};

/// A guard on a puppet, ticked by hand; the scene's tool goes where the valid readings say.
struct Bench {
  explicit Bench(bool own_axes = true) : puppet(own_axes), guard(puppet, guard_for(puppet.info())) {
    guard.begin_at({0.1, 0.2, 0.3}, {1, 0, 0, 0});
  }
  DeviceReading tick(const Vector& force = {1, 0, 0}) {
    last = guard.read(now++ * kTick);
    if (last.valid || now == 1) tool = last;  // the first pose places the tool
    guard.see_tool(tool.position_m, tool.rotation_wxyz);
    guard.write(force);
    return last;
  }
  void ticks(int n, const Vector& force = {1, 0, 0}) {
    for (int i = 0; i < n; ++i) tick(force);
  }
  double shown() const { return length(puppet.heard); }

  Puppet puppet;
  GuardedDevice guard;
  DeviceReading last, tool;
  int now = 0;
};

TEST(GuardedDevice, BeginsAtTheGivenPlaceWhereverTheHandIs) {
  Bench bench;
  bench.puppet.reading.position_m = {0.03, -0.02, 0.01};
  bench.puppet.reading.rotation_wxyz = about_axis({0, 0, 1}, 1.0);
  const DeviceReading first = bench.tick();
  EXPECT_LT(length(subtract(first.position_m, {0.1, 0.2, 0.3})), 1e-15);
  EXPECT_LT(angle_between(first.rotation_wxyz, {1, 0, 0, 0}), 1e-7);
}

TEST(GuardedDevice, ForceGoesToTheDevicesAxes) {
  Bench bench;
  bench.guard.set_view_axes({0, 1, 0}, {0, 0, 1});
  bench.ticks(1000, {0, 2, 0});  // along the view's right
  EXPECT_LT(length(subtract(bench.puppet.heard, {2, 0, 0})), 1e-6);
  Bench patient(false);
  patient.ticks(1000, {0, 2, 0});
  EXPECT_LT(length(subtract(patient.puppet.heard, {0, 2, 0})), 1e-6);
}

TEST(GuardedDevice, AWeakDeviceShowsTheWholeRangeScaledDown) {
  DeviceInfo info;
  info.peak_force_n = 3.3;
  EXPECT_EQ(guard_for(info).limits.force_scale, 1.0) << "a script's force is its own";
  info.own_axes = true;
  const GuardSettings settings = guard_for(info);
  EXPECT_DOUBLE_EQ(settings.limits.force_scale, 3.3 / 7.9);
  EXPECT_NEAR(largest_model_force_n(settings), 7.9, 1e-12);
  info.peak_force_n = 8.0;
  EXPECT_EQ(guard_for(info).limits.force_scale, 1.0);
}

TEST(GuardedDevice, EveryFaultIsZeroForceInItsVeryTickAndAPause) {
  for (auto kind = DeviceFault::force_exceeded; kind <= DeviceFault::driver_error;
       kind = static_cast<DeviceFault>(static_cast<int>(kind) + 1)) {
    Bench bench;
    bench.ticks(600, {3, 0, 0});
    ASSERT_NEAR(bench.shown(), 3.0, 1e-6);
    bench.puppet.trouble = kind;
    EXPECT_FALSE(bench.tick({3, 0, 0}).valid);
    EXPECT_EQ(bench.puppet.heard, (Vector{0, 0, 0})) << name_of(kind);
    EXPECT_EQ(bench.guard.state(), GuardState::paused);
    EXPECT_EQ(bench.guard.fault(), kind);
  }
  Bench between;  // between reading and force
  between.ticks(600, {3, 0, 0});
  EXPECT_TRUE(between.guard.read(1.0).valid);
  between.puppet.trouble = DeviceFault::unplugged;
  between.guard.write({3, 0, 0});
  EXPECT_EQ(between.puppet.heard, (Vector{0, 0, 0}));
  EXPECT_FALSE(between.tick().valid);
}

TEST(GuardedDevice, NoForceBeforeCalibration) {
  for (const Calibration missing : {Calibration::needs_hand, Calibration::needs_update}) {
    Bench bench;
    bench.puppet.calibrated = missing;
    for (int i = 0; i < 500; ++i) {
      const DeviceReading reading = bench.tick({5, 0, 0});
      ASSERT_FALSE(reading.valid);
      ASSERT_EQ(reading.position_m, (Vector{0.1, 0.2, 0.3})) << "the tool waits where it begins";
      ASSERT_EQ(bench.puppet.heard, (Vector{0, 0, 0}));
    }
    EXPECT_EQ(bench.guard.fault(), DeviceFault::not_calibrated);
    bench.puppet.calibrated = Calibration::good;
    bench.puppet.reading.position_m = {0.05, 0, 0};
    bench.tick();
    bench.guard.confirm();
    const DeviceReading begins = bench.tick();
    EXPECT_TRUE(begins.valid);
    EXPECT_LT(length(subtract(begins.position_m, {0.1, 0.2, 0.3})), 1e-15);
  }
}

TEST(GuardedDevice, AForceThatIsNotANumberPausesUntilConfirmed) {
  Bench bench;
  bench.ticks(600, {3, 0, 0});
  bench.tick({3, kNan, 0});
  EXPECT_EQ(bench.puppet.heard, (Vector{0, 0, 0}));
  EXPECT_EQ(bench.guard.fault(), DeviceFault::non_finite_command);
  bench.puppet.reading.position_m = {0.02, 0, 0};  // not near
  for (int i = 0; i < 2000; ++i) {
    ASSERT_FALSE(bench.tick({3, 0, 0}).valid);
    ASSERT_EQ(bench.puppet.heard, (Vector{0, 0, 0}));
  }
  EXPECT_EQ(bench.guard.state(), GuardState::confirming);
  bench.guard.confirm();
  EXPECT_TRUE(bench.tick().valid);
}

TEST(GuardedDevice, APoseThatIsNoneComesThroughOnceAndPauses) {
  Bench bench(false);
  bench.ticks(10);
  const DeviceReading before = bench.last;
  bench.puppet.reading.position_m[1] = kNan;
  const DeviceReading once = bench.tick();
  EXPECT_TRUE(once.valid);
  EXPECT_TRUE(std::isnan(once.position_m[1]));
  EXPECT_EQ(bench.puppet.heard, (Vector{0, 0, 0}));
  const DeviceReading then = bench.tick();
  EXPECT_FALSE(then.valid);
  EXPECT_EQ(then.position_m, before.position_m);
}

/// Faults for 0.1 s after 0.3 s and calls `after` every tick then; ticks until it is valid again, or -1 after 3 s.
int ticks_to_resume(Bench& bench, const std::function<void(int)>& after) {
  bench.ticks(300);
  bench.puppet.trouble = DeviceFault::communication_lost;
  bench.ticks(100);
  bench.puppet.trouble = DeviceFault::none;
  for (int i = 0; i < 3000; ++i) {
    after(i);
    if (bench.tick().valid) return i;
    EXPECT_EQ(bench.puppet.heard, (Vector{0, 0, 0}));
  }
  return -1;
}

TEST(GuardedDevice, TheHandConfirmsByAButtonAKeyOrHoldingNear) {
  for (const bool own_axes : {true, false}) {
    Bench button(own_axes), held(own_axes), key(own_axes), near(own_axes), passing(own_axes), never(own_axes);
    const auto far = [](Bench& b) { b.puppet.reading.position_m = {0.03, 0, 0}; };
    EXPECT_EQ(ticks_to_resume(button, [&](int i) { far(button), button.puppet.reading.buttons = i >= 50 ? 4 : 0; }),
              50);
    // A button that was down all the time says nothing.
    held.puppet.reading.buttons = 1;
    EXPECT_EQ(ticks_to_resume(held, [&](int) { far(held); }), -1);
    // A key pressed while the device is away neither.
    EXPECT_EQ(ticks_to_resume(key,
                              [&](int i) {
                                far(key);
                                if (i == 70) key.guard.confirm();
                              }),
              70);
    const int held_near = ticks_to_resume(near, [&](int i) {
      near.puppet.reading.position_m = {i < 100 ? 0.03 : 0.0049, 0, 0};
    });
    EXPECT_NEAR(held_near, 100 + 500, 2);
    EXPECT_EQ(ticks_to_resume(passing,
                              [&](int i) {
                                passing.puppet.reading.position_m = {i % 450 < 400 ? 0.004 : 0.006, 0, 0};
                              }),
              -1)
        << "it must stay near";
    EXPECT_EQ(ticks_to_resume(never, [&](int) { far(never); }), -1);
  }
  Bench early;
  early.ticks(300);
  early.puppet.trouble = DeviceFault::unplugged;
  early.ticks(10);
  early.guard.confirm();
  early.puppet.trouble = DeviceFault::none;
  early.puppet.reading.position_m = {0.03, 0, 0};
  early.ticks(300);
  EXPECT_EQ(early.guard.state(), GuardState::confirming);
}

TEST(GuardedDevice, AMappedDeviceGoesOnFromTheFrozenToolWithoutAJump) {
  Bench bench;
  for (int i = 0; i < 400; ++i) {
    bench.puppet.reading.position_m = {1e-4 * i, 0, 0};
    bench.tick();
  }
  const DeviceReading frozen = bench.tool;
  bench.puppet.trouble = DeviceFault::unplugged;
  bench.ticks(50);
  bench.puppet.trouble = DeviceFault::none;
  bench.puppet.reading.position_m = {-0.06, 0.05, 0.04};  // put down, taken up elsewhere and otherwise
  bench.puppet.reading.rotation_wxyz = about_axis({1, 0, 0}, 2.0);
  bench.ticks(20);
  EXPECT_GT(length(subtract(bench.last.position_m, frozen.position_m)), 0.05) << "the ghost shows the hand";
  bench.guard.confirm();
  const DeviceReading back = bench.tick();
  ASSERT_TRUE(back.valid);
  EXPECT_LT(length(subtract(back.position_m, frozen.position_m)), 1e-12);
  EXPECT_LT(angle_between(back.rotation_wxyz, frozen.rotation_wxyz), 1e-7);
  double before = 0.0;
  for (int i = 0; i < 700; ++i) {  // and the force comes back gently
    bench.tick({5, 0, 0});
    ASSERT_LE(bench.shown(), 7.9 * (i + 2) / 500.0 + 1e-9);
    ASSERT_LE(std::abs(bench.shown() - before), 0.4 + 1e-12);
    before = bench.shown();
  }
  EXPECT_NEAR(bench.shown(), 5.0, 1e-6);
}

TEST(GuardedDevice, TheClutchFreesTheHandAndTheToolStandsStill) {
  Bench bench;
  bench.ticks(700, {3, 0, 0});
  const DeviceReading still = bench.last;
  bench.puppet.reading.buttons = 2;
  double before = bench.shown();
  for (int i = 0; i < 300; ++i) {
    bench.puppet.reading.position_m = {2e-4 * i, 1e-4 * i, 0};
    bench.puppet.reading.rotation_wxyz = about_axis({0, 1, 0}, 0.005 * i);
    const DeviceReading reading = bench.tick({3, 0, 0});
    ASSERT_TRUE(reading.valid);
    ASSERT_EQ(reading.position_m, still.position_m);
    ASSERT_EQ(reading.rotation_wxyz, still.rotation_wxyz);
    ASSERT_LE(bench.shown(), before + 1e-12);
    ASSERT_LE(before - bench.shown(), 0.4 + 1e-12) << "no jump";
    before = bench.shown();
  }
  EXPECT_LT(bench.shown(), 1e-6);
  EXPECT_EQ(bench.guard.state(), GuardState::clutched);
  bench.puppet.reading.buttons = 0;
  const DeviceReading again = bench.tick({3, 0, 0});
  EXPECT_LT(length(subtract(again.position_m, still.position_m)), 1e-12);
  EXPECT_LT(angle_between(again.rotation_wxyz, still.rotation_wxyz), 1e-7);
  EXPECT_LT(bench.shown(), 0.1) << "it takes hold gently";
  bench.puppet.reading.position_m[0] += 0.01;
  EXPECT_NEAR(length(subtract(bench.tick().position_m, still.position_m)), 0.01, 1e-12);
  // A device whose readings are the patient's already has no clutch.
  Bench patient(false);
  patient.puppet.reading.buttons = 2;
  patient.tick();
  EXPECT_EQ(patient.guard.state(), GuardState::working);
}

/// A million ticks of a device that fails and a scene that asks for anything.
TEST(GuardedDevice, AMillionTicksOfFaultsNeverHarmTheHand) {
  for (const bool own_axes : {true, false}) {
    Puppet puppet(own_axes, 1.75);
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
TEST(GuardedDevice, TwoDevicesRunAtOnceEachOnItsOwn) {
  Puppet left(true), right(true);
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
TEST(GuardedDevice, ADeviceThatGivesUpAtItsMaximumComesBackWhenTheHandDoes) {
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

TEST(GuardedDevice, LettingGoIsZeroForce) {
  Bench bench;
  bench.ticks(600, {3, 0, 0});
  bench.guard.let_go();
  EXPECT_EQ(bench.puppet.heard, (Vector{0, 0, 0}));
}

}  // namespace
}  // namespace vallecula::device
