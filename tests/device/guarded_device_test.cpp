#include "device/guarded_device.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "device/drivers/scripted_device.h"
#include "tests/device/puppet_device.h"

namespace vallecula::device {
namespace {

constexpr double kServoTick = 0.001;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// A guard on a puppet, ticked by hand; the scene's tool goes where the valid readings say.
struct Bench {
  explicit Bench(bool own_axes = true) : puppet(own_axes), guard(puppet, guard_for(puppet.info())) {
    guard.begin_at({0.1, 0.2, 0.3}, {1, 0, 0, 0});
  }
  DeviceReading tick(const Vector& force = {1, 0, 0}) {
    last = guard.read(now++ * kServoTick);
    if (last.valid || now == 1) tool = last;  // the first pose places the tool
    guard.see_tool(tool.position_m, tool.rotation_wxyz);
    guard.write(force);
    return last;
  }
  void ticks(int n, const Vector& force = {1, 0, 0}) {
    for (int i = 0; i < n; ++i) tick(force);
  }
  double shown() const { return length(puppet.heard); }

  PuppetDevice puppet;
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

/// A wall of the model's largest stiffness, felt through the map: what the hand feels is measured, not computed.
TEST(GuardedDevice, NoContactIsStifferThanTheDeviceCanShow) {
  for (const double stiffest : {1020.0, 2350.0, 0.0}) {
    for (const double motion_scale : {kLeastMotionScale, 1.0, 2.0, kMostMotionScale}) {
      PuppetDevice puppet(true);
      puppet.max_stiffness_n_m = stiffest;
      MapSettings map;
      map.motion_scale = motion_scale;
      GuardSettings settings = guard_for(puppet.info(), map);
      settings.limits.soft_start_s = kServoTick;
      GuardedDevice guard(puppet, settings);
      const double pressed_m = 1e-3;
      double start_x = 0.0;
      for (int i = 0; i < 500; ++i) {
        puppet.reading.position_m = {i == 0 ? 0.0 : pressed_m, 0, 0};
        const DeviceReading reading = guard.read(i * kServoTick);
        if (i == 0) start_x = reading.position_m[0];
        guard.write({kStiffestModelNM * (start_x - reading.position_m[0]), 0, 0});
      }
      const double felt = length(puppet.heard) / pressed_m;
      const double by_peak = std::min(1.0, 7.9 / (kFullForceN * motion_scale)) * 1200.0 * motion_scale * motion_scale;
      EXPECT_NEAR(felt, stiffest > 0.0 ? std::min(stiffest, by_peak) : by_peak, 1e-3)
          << stiffest << " " << motion_scale;
    }
  }
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

TEST(GuardedDevice, AFaultThatEndsWhileItIsAskedForStillPauses) {
  // Of a driver's thread that mends itself just after the first asking.
  class Flicker final : public HapticDevice {
   public:
    DeviceInfo info() const override { return PuppetDevice(true).info(); }
    DeviceReading read(double) noexcept override { return {}; }
    void write(const std::array<double, 3>& force_n) noexcept override { heard = force_n; }
    DeviceFault fault() const noexcept override { return std::exchange(next, DeviceFault::none); }
    mutable DeviceFault next = DeviceFault::none;
    Vector heard{0, 0, 0};
  };
  for (const bool before_reading : {true, false}) {
    Flicker device;
    GuardedDevice guard(device, guard_for(device.info()));
    guard.read(0.0);
    guard.write({1, 0, 0});
    if (before_reading) device.next = DeviceFault::servo_late;
    guard.read(kServoTick);
    device.next = before_reading ? DeviceFault::none : DeviceFault::servo_late;
    guard.write({1, 0, 0});
    EXPECT_EQ(guard.state(), GuardState::paused) << before_reading;
    EXPECT_EQ(guard.fault(), DeviceFault::servo_late);
    EXPECT_EQ(device.heard, (Vector{0, 0, 0}));
  }
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
  bench.tick({3, kNotANumber, 0});
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
  bench.puppet.reading.position_m[1] = kNotANumber;
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

// The button nearest at hand is the clutch, and it confirms as any other does.
TEST(GuardedDevice, ConfirmedByTheClutchTheToolStaysWhereItWasFrozen) {
  Bench bench;
  for (int i = 0; i < 400; ++i) {
    bench.puppet.reading.position_m = {1e-4 * i, 0, 0};
    bench.tick();
  }
  const DeviceReading frozen = bench.tool;
  bench.puppet.trouble = DeviceFault::unplugged;
  bench.ticks(50);
  bench.puppet.trouble = DeviceFault::none;
  bench.puppet.reading.position_m = {-0.06, 0.05, 0.04};
  bench.puppet.reading.rotation_wxyz = about_axis({1, 0, 0}, 2.0);
  bench.ticks(20);
  ASSERT_EQ(bench.guard.state(), GuardState::confirming);
  const auto expect_frozen = [&](const DeviceReading& reading) {
    EXPECT_TRUE(reading.valid);
    EXPECT_LT(length(subtract(reading.position_m, frozen.position_m)), 1e-12);
    EXPECT_LT(angle_between(reading.rotation_wxyz, frozen.rotation_wxyz), 1e-7);
  };
  bench.puppet.reading.buttons = 2;
  expect_frozen(bench.tick());
  EXPECT_EQ(bench.guard.state(), GuardState::clutched);
  bench.puppet.reading.position_m = {0.02, 0.01, 0};  // the hand is free
  expect_frozen(bench.tick());
  bench.puppet.reading.buttons = 0;
  expect_frozen(bench.tick());
  EXPECT_EQ(bench.guard.state(), GuardState::working);
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

TEST(GuardedDevice, AnotherAttemptBeginsAsTheFirstDidButTheMotorsStayWarm) {
  PuppetDevice puppet(true, 1.75);
  GuardedDevice guard(puppet, guard_for(puppet.info()));
  guard.begin_at({0.1, 0.2, 0.3}, {1, 0, 0, 0});
  const auto tick = [&](int i) {
    const DeviceReading reading = guard.read(i * kServoTick);
    guard.see_tool(reading.position_m, reading.rotation_wxyz);
    guard.write({50, 0, 0});
    return reading;
  };
  for (int i = 0; i < 60000; ++i) tick(i);
  EXPECT_LT(length(puppet.heard), 1.9) << "a minute at the limit: warm";
  puppet.trouble = DeviceFault::unplugged;
  tick(60000);
  puppet.trouble = DeviceFault::none;
  puppet.reading.position_m = {0.05, 0.05, 0};
  guard.let_go();
  guard.begin_anew();
  EXPECT_EQ(guard.state(), GuardState::working);
  EXPECT_LT(length(subtract(tick(0).position_m, {0.1, 0.2, 0.3})), 1e-12);
  EXPECT_LT(length(puppet.heard), 0.05) << "softly";
  for (int i = 1; i < 1000; ++i) tick(i);
  EXPECT_LT(length(puppet.heard), 2.2) << "still warm";
}

TEST(GuardedDevice, LettingGoIsZeroForce) {
  Bench bench;
  bench.ticks(600, {3, 0, 0});
  bench.guard.let_go();
  EXPECT_EQ(bench.puppet.heard, (Vector{0, 0, 0}));
}

TEST(GuardedDevice, WhoHoldsTheTrialTakesNoFaultOfAScriptAway) {
  std::vector<Keyframe> way(2);  // 50 mm/s: no hand that holds still
  way[1].time_s = 2.0;
  way[1].position_m = {0.1, 0, 0};
  const auto held_after = [&](std::vector<InjectedFault> faults) {
    ScriptedDevice script(Trajectory(way), HandSettings{}, std::move(faults));
    GuardedDevice guard(script, guard_for(script.info()));
    double waited_s = 0.0;
    for (int n = 0; n < 1200; ++n) {
      guard.freeze(n >= 600 && n < 900);
      if (guard.waits()) waited_s += kServoTick;
      guard.read(n * kServoTick, waited_s);
      guard.write({0, 0, 0});
    }
    return guard.state();
  };
  EXPECT_EQ(held_after({}), GuardState::working) << "it goes on by itself";
  EXPECT_EQ(held_after({{DeviceFault::communication_lost, 0.4, 0.1}}), GuardState::confirming)
      << "its tool stands where it was when the device went: somebody has to take hold";
}

}  // namespace
}  // namespace vallecula::device
