#include "device/drivers/scripted_device.h"

#include <gtest/gtest.h>

#include <complex>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "device/rotation.h"
#include "tests/device/allocation_guard.h"

namespace vallecula::device {
namespace {

constexpr double kServoTick = 0.001;

Trajectory still(double seconds = 10.0) { return Trajectory({{0, {0.01, 0.02, 0.03}}, {seconds, {0.01, 0.02, 0.03}}}); }

/// Reads and writes `force` for `ticks`; returns the last reading.
DeviceReading hold(ScriptedDevice& device, int& tick, int ticks, const Vector& force) {
  DeviceReading reading;
  for (int i = 0; i < ticks; ++i, ++tick) {
    reading = device.read(tick * kServoTick);
    device.write(force);
  }
  return reading;
}

TEST(ScriptedDevice, YieldsForceOverStiffnessAndComesBack) {
  for (const double stiffness : {200.0, 400.0, 1000.0}) {
    HandSettings hand;
    hand.stiffness_n_m = stiffness;
    ScriptedDevice device(still(), hand);
    int tick = 0;
    const Vector force{1.0, -2.0, 3.0};
    const DeviceReading pushed = hold(device, tick, 2000, force);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(pushed.position_m[axis], 0.01 * (static_cast<double>(axis) + 1) + force[axis] / stiffness, 1e-12);
    }
    const DeviceReading released = hold(device, tick, 2000, {0, 0, 0});
    EXPECT_LT(length(subtract(released.position_m, {0.01, 0.02, 0.03})), 1e-12);
  }
}

TEST(ScriptedDevice, YieldingLagsByDampingOverStiffness) {
  HandSettings hand;
  hand.stiffness_n_m = 400.0;
  hand.damping_n_s_m = 20.0;  // 50 ms
  ScriptedDevice device(still(), hand);
  int tick = 0;
  const DeviceReading reading = hold(device, tick, 51, {4.0, 0, 0});  // 50 ms after the first force
  EXPECT_NEAR(reading.position_m[0] - 0.01, 0.01 * (1.0 - std::exp(-1.0)), 1e-12);
}

TEST(ScriptedDevice, ForceIsClampedToTheDeviceLimit) {
  HandSettings hand;
  hand.device_limit_n = 5.0;
  ScriptedDevice device(still(), hand);
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0.0, 20.0);
  for (int i = 0; i < 5000; ++i) {
    device.read(i * kServoTick);
    device.write({normal(random), normal(random), normal(random)});
    ASSERT_LE(length(device.given_force_n()), 5.0 * (1 + 1e-15));
  }
}

TEST(ScriptedDevice, OverTheLimitTooLongIsAFaultAtTheStatedTime) {
  HandSettings hand;
  hand.limit_time_s = 0.1;
  hand.recovery_time_s = 0.25;
  ScriptedDevice device(still(), hand);
  int tick = 0;
  hold(device, tick, 50, {0, 0, 9.0});
  hold(device, tick, 1, {0, 0, 1.0});  // one tick below the limit starts the time anew
  const int first_at_limit = tick;
  int fault_tick = -1;
  while (fault_tick < 0 && tick < 1000) {
    hold(device, tick, 1, {0, 0, 9.0});
    if (device.fault() == DeviceFault::force_exceeded) fault_tick = tick - 1;
  }
  // "longer than 0.1 s": tick 100 after the first is exactly 0.1 s, give or take the rounding of tick * 0.001.
  EXPECT_GE(fault_tick - first_at_limit, 100);
  EXPECT_LE(fault_tick - first_at_limit, 101);
  EXPECT_EQ(device.given_force_n(), (Vector{0, 0, 0}));
  EXPECT_EQ(device.fault_count(), 1);

  EXPECT_FALSE(hold(device, tick, 1, {0, 0, 0}).valid);
  int back = -1;
  while (back < 0 && tick < 5000) {
    const DeviceReading reading = hold(device, tick, 1, {0, 0, 0});
    if (reading.valid) back = tick - 1;
  }
  EXPECT_GE(back - fault_tick, 250);
  EXPECT_LE(back - fault_tick, 251);
  EXPECT_EQ(device.fault(), DeviceFault::none);
}

TEST(ScriptedDevice, StaysFaultedWhileTheForceIsStillDemanded) {
  HandSettings hand;
  hand.limit_time_s = 0.05;
  hand.recovery_time_s = 0.1;
  ScriptedDevice device(still(), hand);
  int tick = 0;
  EXPECT_FALSE(hold(device, tick, 2000, {9.0, 0, 0}).valid);
  EXPECT_FALSE(hold(device, tick, 500, {kDemandGoneShare * 7.9 + 0.01, 0, 0}).valid);
  EXPECT_EQ(device.given_force_n(), (Vector{0, 0, 0}));
  EXPECT_TRUE(hold(device, tick, 3, {1.0, 0, 0}).valid);
  EXPECT_EQ(device.fault_count(), 1);
}

TEST(ScriptedDevice, JustBelowTheLimitIsNeverAFault) {
  ScriptedDevice device(still(20), HandSettings{});
  int tick = 0;
  EXPECT_TRUE(hold(device, tick, 10000, {0.98 * 7.9, 0, 0}).valid);
  EXPECT_EQ(device.fault_count(), 0);
}

TEST(ScriptedDevice, NotANumberOnAnyAxisIsAFaultWithoutForce) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ScriptedDevice device(still(), HandSettings{});
      int tick = 0;
      hold(device, tick, 10, {1, 0, 0});
      Vector force{0, 0, 0};
      force[axis] = bad;
      hold(device, tick, 1, force);
      EXPECT_EQ(device.fault(), DeviceFault::non_finite_command);
      EXPECT_EQ(device.given_force_n(), (Vector{0, 0, 0}));
      EXPECT_FALSE(hold(device, tick, 1, {0, 0, 0}).valid);
      const DeviceReading later = hold(device, tick, 2000, {0, 0, 0});
      EXPECT_TRUE(later.valid);
      EXPECT_TRUE(finite(later.position_m));
    }
  }
}

TEST(ScriptedDevice, SameSeedSameTremorAndAnotherSeedAnother) {
  HandSettings hand;
  hand.tremor_amplitude_m = 2e-4;
  const auto record = [&](unsigned seed) {
    hand.tremor_seed = seed;
    ScriptedDevice device(still(), hand);
    std::vector<Vector> positions;
    for (int i = 0; i < 4000; ++i) {
      positions.push_back(device.read(i * kServoTick).position_m);
      device.write({0.1, 0, 0});
    }
    return positions;
  };
  EXPECT_EQ(record(5), record(5));
  EXPECT_NE(record(5), record(6));
}

TEST(ScriptedDevice, TremorStaysInItsBandAndBound) {
  HandSettings hand;
  hand.tremor_amplitude_m = 2e-4;
  ScriptedDevice device(still(), hand);
  constexpr int kSamples = 8000;
  std::vector<double> x(kSamples);
  for (int i = 0; i < kSamples; ++i) {
    const Vector offset = subtract(device.read(i * kServoTick).position_m, {0.01, 0.02, 0.03});
    for (const double v : offset) EXPECT_LE(std::abs(v), 2e-4 + 1e-15);
    // Hann window: without it the ends of the record smear a sine over the whole spectrum.
    x[static_cast<std::size_t>(i)] = offset[0] * 0.5 * (1.0 - std::cos(2.0 * M_PI * i / kSamples));
  }
  double inside = 0.0, outside = 0.0;
  for (double f = 0.125; f < 40.0; f += 0.125) {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < kSamples; ++i)
      sum += x[static_cast<std::size_t>(i)] * std::polar(1.0, -2.0 * M_PI * f * i * kServoTick);
    (f > 7.6 && f < 12.4 ? inside : outside) += std::norm(sum);
  }
  EXPECT_GT(inside, 0.0);
  EXPECT_LT(outside, 1e-3 * inside);
}

/// A device that gave up its force still senses where the hand goes; one that does not answer tells nothing.
TEST(ScriptedDevice, EveryFaultComesAndGoesByTheScript) {
  const Trajectory moving({{0, {0, 0, 0}}, {10, {0.1, 0, 0}}});
  for (auto kind = DeviceFault::force_exceeded; kind <= DeviceFault::driver_error;
       kind = static_cast<DeviceFault>(static_cast<int>(kind) + 1)) {
    ScriptedDevice device(moving, HandSettings{}, {{kind, 1.0, 0.5}, {DeviceFault::unplugged, 3.0, 0.1}});
    Vector at_fault{0, 0, 0}, last{0, 0, 0};
    for (int tick = 0; tick < 4000; ++tick) {
      const double t = tick * kServoTick;
      const DeviceReading reading = device.read(t);
      device.write({1, 0, 0});
      const bool faulty = (t >= 1.0 && t < 1.5) || (t >= 3.0 && t < 3.1);
      ASSERT_EQ(reading.valid, !faulty) << name_of(kind) << " at " << t;
      ASSERT_EQ(device.fault(), !faulty ? DeviceFault::none : t < 2.0 ? kind : DeviceFault::unplugged) << t;
      if (faulty) {
        ASSERT_EQ(device.given_force_n(), (Vector{0, 0, 0}));
      }
      if (tick == 1010) at_fault = reading.position_m;
      if (tick == 1490) last = reading.position_m;
    }
    const bool blind = kind == DeviceFault::communication_lost || kind == DeviceFault::unplugged ||
                       kind == DeviceFault::not_calibrated || kind == DeviceFault::driver_error;
    EXPECT_EQ(at_fault == last, blind) << name_of(kind);
    EXPECT_EQ(fault_named(name_of(kind)), kind);
    EXPECT_EQ(device.fault_count(), 2);
  }
}

TEST(ScriptedDevice, PushedHarderThanItCanTheHandGivesWay) {
  HandSettings hand;
  hand.max_force_n = 3.0;
  ScriptedDevice device(still(), hand);
  int tick = 0;
  EXPECT_NEAR(hold(device, tick, 500, {2.9, 0, 0}).position_m[0], 0.01 + 2.9 / 400.0, 1e-6);
  const double from = hold(device, tick, 500, {5.0, 0, 0}).position_m[0];
  // What is more than it can moves it: (5 - 3) N / 8 N s/m.
  EXPECT_NEAR(hold(device, tick, 100, {5.0, 0, 0}).position_m[0] - from, 0.1 * 2.0 / 8.0, 1e-6);
  EXPECT_NEAR(hold(device, tick, 2000, {0, 0, 0}).position_m[0], 0.01, 1e-9) << "it comes back when let";
}

TEST(HandScript, TellsOfTheHandAndItsFaults) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "vallecula-hand.csv";
  const auto script = [&](const std::string& text) {
    std::ofstream(file) << text;
    return read_hand_script(file);
  };
  const HandScript read = script(
      "# a remark on faults\n# hand stiffness_n_m 400\n#hand tremor_seed 7\nt,x,y,z\n0,0,0,0\n"
      "# fault communication_lost 0.5 0.25\n1,0,0,0.01\n # fault motor_warm 2 1.5\n");
  EXPECT_EQ(read.keyframes.size(), 2u);
  EXPECT_EQ(read.hand.stiffness_n_m, 400.0);
  EXPECT_EQ(read.hand.tremor_seed, 7u);
  EXPECT_EQ(read.hand.damping_n_s_m, firm_hand().damping_n_s_m);
  ASSERT_EQ(read.faults.size(), 2u);
  EXPECT_EQ(read.faults[0].fault, DeviceFault::communication_lost);
  EXPECT_EQ(read.faults[0].from_s, 0.5);
  EXPECT_EQ(read.faults[1].for_s, 1.5);
  EXPECT_EQ(ScriptedDevice(Trajectory(read.keyframes), read.hand, read.faults).faults_too_late(), 1)
      << "the one at 2 s: the script ends at 1 s";
  for (const std::string bad : {"# fault sleepy 1 1", "# fault unplugged 1", "# fault unplugged x 1",
                                "# fault none 1 1", "# fault unplugged -1 1", "# fault unplugged nan 1",
                                "# hand stiffness 4", "# hand tremor_seed -1", "# hand max_force_n strong"}) {
    try {
      script("0,0,0,0\n" + bad + "\n");
      ADD_FAILURE() << bad;
    } catch (const DeviceError& error) {
      EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(bad[2] == 'f' ? "motor_warm" : "stiffness_n_m"), std::string::npos);
    }
  }
  std::filesystem::remove(file);
}

TEST(ScriptedDevice, FinishesAfterItsLastKeyframe) {
  ScriptedDevice device(still(2.0), HandSettings{});
  EXPECT_FALSE(device.finished(0.0));
  EXPECT_FALSE(device.finished(2.0));
  EXPECT_TRUE(device.finished(2.001));
}

TEST(ScriptedDevice, RefusesAHandThatIsNone) {
  const auto refused = [](auto change) {
    HandSettings hand;
    change(hand);
    EXPECT_THROW(ScriptedDevice(still(), hand), DeviceError);
  };
  refused([](HandSettings& h) { h.stiffness_n_m = 0; });
  refused([](HandSettings& h) { h.stiffness_n_m = std::numeric_limits<double>::quiet_NaN(); });
  refused([](HandSettings& h) { h.damping_n_s_m = 0; });
  refused([](HandSettings& h) { h.tremor_amplitude_m = -1e-4; });
  refused([](HandSettings& h) { h.device_limit_n = std::numeric_limits<double>::infinity(); });
  refused([](HandSettings& h) { h.limit_time_s = -1; });
  refused([](HandSettings& h) { h.max_force_n = 0; });
  refused([](HandSettings& h) { h.recovery_time_s = -1; });
}

TEST(ScriptedDevice, TicksAllocateNothing) {
  HandSettings hand;
  hand.tremor_amplitude_m = 1e-4;
  hand.limit_time_s = 0.01;
  ScriptedDevice device(still(), hand);
  const long long before = testing::allocations();
  for (int i = 0; i < 3000; ++i) {
    device.read(i * kServoTick);
    device.write({i * 0.01, 0, i == 2000 ? std::numeric_limits<double>::quiet_NaN() : 0.0});
  }
  EXPECT_EQ(testing::allocations(), before);
  EXPECT_GT(device.fault_count(), 0);
}

}  // namespace
}  // namespace vallecula::device
