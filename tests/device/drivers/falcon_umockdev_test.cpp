// The Falcon's driver on the real libusb, against a mocked bus with a chip, a processor and a hand.
#include <atomic>
#include <random>
#include <thread>

#include "tests/device/allocation_guard.h"
#include "tests/device/drivers/falcon_bed_umockdev.h"

namespace vallecula::device {
namespace {

/// The order of the requests is that of the notes on the device, written down here anew.
TEST_F(FalconUmockdev, NoForceBeforeItIsHomed) {
  open_running();
  mock_->put({500, 500, 500});
  ticks({3, -4, 5}, 0.2);
  EXPECT_TRUE(ticks_until({3, -4, 5}, [&] { return device_->fault() == DeviceFault::not_calibrated; }));
  EXPECT_EQ(device_->calibration(), Calibration::needs_hand);
  EXPECT_FALSE(tick({3, -4, 5}).valid);
  EXPECT_EQ(mock_->seen().largest_motor_unhomed, 0);
  EXPECT_EQ(mock_->seen().lights, falcon::kRedLight);
  EXPECT_TRUE(mock_->seen().homing);

  mock_->home();
  EXPECT_TRUE(ticks_until({3, -4, 5}, [&] { return tick({3, -4, 5}).valid; }));
  EXPECT_EQ(device_->calibration(), Calibration::good);
  EXPECT_TRUE(ticks_until({3, -4, 5}, [&] { return !motors_zero(); }));
  EXPECT_EQ(mock_->seen().lights, falcon::kGreenLight);

  mock_->home(false);  // it lost its count
  EXPECT_TRUE(ticks_until({3, -4, 5}, [&] { return device_->fault() == DeviceFault::not_calibrated; }));
  EXPECT_TRUE(ticks_until({3, -4, 5}, [&] { return motors_zero(); }));
}

TEST_F(FalconUmockdev, ReadsPlaceAndButtons) {
  open_homed();
  for (const Vector& place : {Vector{0.02, 0.01, -0.01}, Vector{-0.03, 0.02, 0.02}, Vector{0.0, -0.04, 0.0}}) {
    mock_->put(encoders_at(place), 5);
    DeviceReading reading;
    EXPECT_TRUE(ticks_until({0, 0, 0}, [&] {
      reading = tick({0, 0, 0});
      // Half a count of each encoder is a fiftieth of a millimetre at the knee.
      return reading.valid && length(subtract(reading.position_m, place)) < 6e-5;
    })) << place[0];
    EXPECT_EQ(reading.buttons, 5u);
    EXPECT_EQ(reading.rotation_wxyz, (Rotation{1, 0, 0, 0}));
  }
}

TEST_F(FalconUmockdev, TheForceIsTheTransposedJacobianTimesIt) {
  open_homed();
  for (const Vector& place : {Vector{0, 0, 0}, Vector{0.03, -0.02, 0.01}, Vector{-0.02, 0.03, -0.03}}) {
    mock_->put(encoders_at(place));
    ASSERT_TRUE(ticks_until({0, 0, 0}, [&] { return length(subtract(tick({0, 0, 0}).position_m, place)) < 6e-5; }));
    const Vector read = tick({0, 0, 0}).position_m;
    for (const Vector& force : {Vector{1, 0, 0}, Vector{0, -2, 0}, Vector{0, 0, 2.5}, Vector{1.5, -1, 2}}) {
      const auto expected = motors_for(read, force);
      const auto right = [&] {
        const auto motors = mock_->seen().motors;
        bool all = true;
        for (int leg = 0; leg < 3; ++leg) all = all && std::abs(motors[leg] - expected[leg]) < 0.51;  // rounding
        return all;
      };
      EXPECT_TRUE(ticks_until(force, right))
          << mock_->seen().motors[0] << " for " << expected[0] << ", " << mock_->seen().motors[1] << " for "
          << expected[1] << ", " << mock_->seen().motors[2] << " for " << expected[2];
    }
  }
  EXPECT_EQ(mock_->seen().malformed, 0);
}

TEST_F(FalconUmockdev, AForceTooLargeKeepsItsDirection) {
  open_homed();
  for (const Vector& force : {Vector{300, 0, 0}, Vector{-20, 30, 10}, Vector{0, 0, 1e300}}) {
    const Vector read = tick(force).position_m;
    const auto unit = motors_for(read, scale(force, 1.0 / length(force)));
    const auto along = [&] {
      const auto motors = mock_->seen().motors;
      int largest = 0;
      for (int leg = 1; leg < 3; ++leg) {
        if (std::abs(unit[leg]) > std::abs(unit[largest])) largest = leg;
      }
      const double newtons = motors[largest] / unit[largest];
      if (newtons < 1.0 || newtons > 8.0 + 0.02) return false;
      for (int leg = 0; leg < 3; ++leg) {
        if (std::abs(motors[leg]) > falcon::kMostMotor || std::abs(motors[leg] - newtons * unit[leg]) > 1.01)
          return false;
      }
      return true;
    };
    EXPECT_TRUE(ticks_until(force, along)) << force[0];
  }
}

TEST_F(FalconUmockdev, WhatIsNotANumberIsNoForce) {
  open_homed();
  for (int axis = 0; axis < 3; ++axis) {
    ASSERT_TRUE(ticks_until({1, 1, 1}, [&] { return !motors_zero(); }));
    Vector bad{1, 1, 1};
    bad[axis] = axis == 1 ? HUGE_VAL : std::nan("");
    EXPECT_TRUE(ticks_until(bad, [&] { return motors_zero(); }));
    EXPECT_TRUE(ticks_until(bad, [&] { return device_->fault() == DeviceFault::non_finite_command; }));
    EXPECT_TRUE(ticks_until({1, 1, 1}, [&] { return device_->fault() == DeviceFault::none; }));
  }
}

TEST_F(FalconUmockdev, AServoThatStopsIsNoForce) {
  open_homed();
  ASSERT_TRUE(ticks_until({2, 2, 2}, [&] { return !motors_zero(); }));
  const long forces = mock_->seen().forces;
  EXPECT_TRUE(wait_for([&] { return device_->fault() == DeviceFault::servo_late && motors_zero(); }));
  EXPECT_LE(mock_->seen().forces, forces + 60);  // one a millisecond, for 50 ms from the last command
  EXPECT_FALSE(device_->read(since(begin_)).valid);
  EXPECT_TRUE(ticks_until({2, 2, 2}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
  // Without a force there is nothing to withhold: a trial has ended.
  ASSERT_TRUE(ticks_until({0, 0, 0}, [&] { return motors_zero(); }));
  const long commands = mock_->seen().commands;
  EXPECT_TRUE(wait_for([&] { return mock_->seen().commands > commands + 100; }));
  EXPECT_EQ(device_->fault(), DeviceFault::none);
}

TEST_F(FalconUmockdev, UnpluggedAndPluggedInAgain) {
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
  mock_->plug();
  write_file("falcon.bin", some_firmware());
  device_ = std::make_unique<FalconDevice>();
  mock_->put(encoders_at({0.01, 0.01, 0.01}));
  mock_->home();
  ASSERT_TRUE(ticks_until({1, 1, 1}, [&] { return !motors_zero(); }));
  for (int time = 1; time <= 3; ++time) {
    const DeviceReading before = tick({1, 1, 1});
    mock_->unplug();
    ASSERT_TRUE(ticks_until({1, 1, 1}, [&] { return device_->fault() == DeviceFault::unplugged; }));
    DeviceReading reading = ticks({1, 1, 1}, 0.6);  // and is looked for meanwhile
    EXPECT_FALSE(reading.valid);
    EXPECT_LT(length(subtract(reading.position_m, before.position_m)), 1e-9);  // Newton's last bits
    EXPECT_EQ(device_->fault(), DeviceFault::unplugged);
    EXPECT_EQ(device_->calibration(), Calibration::needs_hand);

    const long commands = mock_->seen().commands;
    mock_->plug();
    ASSERT_TRUE(ticks_until({1, 1, 1}, [&] { return device_->fault() == DeviceFault::not_calibrated; }));
    EXPECT_EQ(mock_->seen().loads, 1 + time);
    EXPECT_GT(mock_->seen().commands, commands);
    EXPECT_TRUE(motors_zero());
    mock_->home();
    ASSERT_TRUE(ticks_until({1, 1, 1}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
  }
  EXPECT_EQ(mock_->seen().largest_motor_unhomed, 0);
}

TEST_F(FalconUmockdev, SilenceIsAFaultAndNoForce) {
  open_homed();
  ASSERT_TRUE(ticks_until({2, 2, 2}, [&] { return !motors_zero(); }));
  mock_->set([](FalconFaults& f) { f.silent = true; });
  const auto before = mock_->seen();
  ASSERT_TRUE(ticks_until({2, 2, 2}, [&] { return device_->fault() == DeviceFault::communication_lost; }));
  EXPECT_LE(mock_->seen().commands, before.commands + 10);  // each waits 10 ms for its answer, 50 ms are a fault
  EXPECT_LE(mock_->seen().forces, before.forces + 1);       // the one that was not answered
  EXPECT_TRUE(motors_zero());
  EXPECT_FALSE(tick({2, 2, 2}).valid);
  mock_->set([](FalconFaults& f) { f.silent = false; });
  EXPECT_TRUE(ticks_until({2, 2, 2}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
  // Longer than it waits: opened anew.
  mock_->set([](FalconFaults& f) { f.silent = true; });
  const std::size_t requests = mock_->seen().requests.size();
  ASSERT_TRUE(ticks_until({2, 2, 2}, [&] { return mock_->seen().requests.size() > requests; }));
  mock_->set([](FalconFaults& f) { f.silent = false; });
  EXPECT_TRUE(ticks_until({2, 2, 2}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
}

TEST_F(FalconUmockdev, StallsPassAndLongOnesAreAFault) {
  open_homed();
  mock_->set([](FalconFaults& f) { f.stalls_out = 2, f.stalls_in = 2; });
  EXPECT_TRUE(ticks_until({2, 2, 2}, [&] {
    bool over = false;
    mock_->set([&](FalconFaults& f) { over = f.stalls_out == 0 && f.stalls_in == 0; });
    return over && device_->fault() == DeviceFault::none && !motors_zero();
  }));
  mock_->set([](FalconFaults& f) { f.stalls_out = 1000000; });
  EXPECT_TRUE(ticks_until({2, 2, 2}, [&] { return device_->fault() == DeviceFault::communication_lost; }));
  mock_->set([](FalconFaults& f) { f.stalls_out = 0; });
  EXPECT_TRUE(ticks_until({2, 2, 2}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
}

TEST_F(FalconUmockdev, BrokenFlippedLateAndRepeatedAnswers) {
  const Vector place{0.01, -0.01, 0.02};
  open_homed(place);
  const auto stays = [&] {
    return ticks_until({0, 0, 1}, [&] { return device_->fault() == DeviceFault::none; }) &&
           length(subtract(tick({0, 0, 1}).position_m, place)) < 6e-5;
  };
  for (int n = 0; n < 20; ++n) {
    mock_->set([](FalconFaults& f) { f.broken_packets = 1; });
    ticks({0, 0, 1}, 0.02);
    EXPECT_TRUE(stays());
    mock_->set([](FalconFaults& f) { f.flipped_packets = 2; });  // a jump of 32768 counts
    for (int i = 0; i < 20; ++i) {
      EXPECT_LT(length(subtract(tick({0, 0, 1}).position_m, place)), 6e-5);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(stays());
  }
  mock_->set([](FalconFaults& f) { f.twice = true; });
  ticks({0, 0, 1}, 0.2);
  EXPECT_TRUE(stays());
  mock_->set([](FalconFaults& f) { f = {}, f.late_ms = 15; });  // beyond what one exchange waits
  ticks({0, 0, 1}, 0.3);
  mock_->set([](FalconFaults& f) { f = {}; });
  EXPECT_TRUE(ticks_until({0, 0, 1}, [&] { return stays(); }));
  const Vector next{0.0, 0.0, 0.0};  // not one answer behind
  mock_->put(encoders_at(next));
  EXPECT_TRUE(ticks_until({0, 0, 0}, [&] { return length(subtract(tick({0, 0, 0}).position_m, next)) < 6e-5; }));
}

/// Random faults of the device and random forces of the servo for some seconds: bounds hold throughout, and it
/// recovers.
TEST_F(FalconUmockdev, RandomFaultsAndForces) {
  open_homed();
  std::mt19937 random(17);
  const auto chance = [&](unsigned one_in) { return random() % one_in == 0; };
  const auto force = [&] {
    const auto component = [&] { return (static_cast<double>(random() % 2001) - 1000.0) / 50.0; };
    Vector f{component(), component(), component()};
    if (chance(50)) f[random() % 3] = std::nan("");
    if (chance(50)) f[random() % 3] = 1e200;
    return f;
  };
  int unhomed = 0;
  for (const auto begin = Clock::now(); since(begin) < 4.0;) {
    if (chance(40)) {
      mock_->set([&](FalconFaults& f) {
        f = {};
        f.silent = chance(8);
        f.stalls_out = chance(4) ? static_cast<int>(random() % 10) : 0;
        f.stalls_in = chance(4) ? static_cast<int>(random() % 10) : 0;
        f.broken_packets = chance(3) ? 1 : 0;
        f.flipped_packets = chance(3) ? 1 : 0;
        f.late_ms = chance(4) ? static_cast<int>(random() % 15) : 0;
        f.twice = chance(4);
      });
      const bool homed = !chance(6);
      unhomed += !homed;
      mock_->home(homed);
    }
    const DeviceReading reading = tick(force());
    ASSERT_TRUE(finite(reading.position_m));
    ASSERT_LT(length(reading.position_m), 1e-3);  // the hand holds still in the middle
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const auto seen = mock_->seen();
  EXPECT_EQ(seen.malformed, 0);
  EXPECT_GT(seen.largest_motor, 500);
  EXPECT_LE(seen.largest_motor, falcon::kMostMotor);
  // A command on its way when the homing is lost is one that was sent before.
  EXPECT_LE(seen.forces_unhomed, 2 * unhomed);
  mock_->set([](FalconFaults& f) { f = {}; });
  mock_->home();
  EXPECT_TRUE(ticks_until({1, 1, 1}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
}

TEST_F(FalconUmockdev, ItEndsWithoutForceWhateverHappens) {
  open_homed();
  ASSERT_TRUE(ticks_until({2, 2, 2}, [&] { return !motors_zero(); }));
  device_.reset();
  EXPECT_TRUE(motors_zero());
  EXPECT_EQ(mock_->seen().lights, 0);
  const auto ends = [&](const std::function<void()>& spoil) {
    device_ = std::make_unique<FalconDevice>();
    ticks({2, 2, 2}, 0.05);
    spoil();
    ticks({2, 2, 2}, 0.1);
    const auto begin = Clock::now();
    device_.reset();
    EXPECT_LT(since(begin), 5.0);  // it does not hang: half a second, on a machine with time for it
  };
  ends([&] { mock_->set([](FalconFaults& f) { f.silent = true; }); });
  mock_->set([](FalconFaults& f) { f = {}; });
  ends([&] { mock_->set([](FalconFaults& f) { f.stalls_out = 1000000; }); });
  mock_->set([](FalconFaults& f) { f = {}; });
  ends([&] { mock_->unplug(); });
}

TEST_F(FalconUmockdev, OurOwnIsNoOtherPrograms) {
  open_homed();
  const auto found = find_falcon();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "falcon");
  EXPECT_EQ(found[0].info.serial, MockFalcon::serial());
  EXPECT_NE(found[0].problem.find("used by this program"), std::string::npos) << found[0].problem;
  expect_error({"used by this program"});
  EXPECT_TRUE(ticks_until({1, 0, 0}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
  device_.reset();
  write_file("falcon.bin", some_firmware());
  EXPECT_EQ(find_falcon().at(0).problem, "");
}

/// The window lists once a second, on a thread of its own, while a trial opens what it lists.
TEST_F(FalconUmockdev, ListingAndOpeningNeverMeet) {
  mock_ = std::make_unique<MockFalcon>(bed_, std::vector<std::uint8_t>());
  mock_->plug();
  std::atomic<bool> stop{false};
  std::atomic<int> lists{0}, strangers{0};
  std::thread listing([&] {
    for (; !stop; ++lists) {
      for (const FoundDevice& one : find_falcon())
        strangers += one.problem.find("another program holds") != std::string::npos;
    }
  });
  EXPECT_TRUE(wait_for([&] { return lists > 0; }));
  for (int i = 0; i < 30; ++i) EXPECT_EQ(opening_error(), "opened");
  stop = true;
  listing.join();
  EXPECT_EQ(strangers, 0);
}

TEST_F(FalconUmockdev, ATickAllocatesNothing) {
  open_homed();
  const long long before = testing::allocations();
  for (int i = 0; i < 1000; ++i) tick({1, 0, std::nan("")});
  EXPECT_EQ(testing::allocations(), before);
}

/// However long the servo's own thread works meanwhile: a driver that does not come round is told.
TEST_F(FalconUmockdev, ADriverThatStandsStillIsTold) {
  open_homed();
  mock_->set([](FalconFaults& f) { f.blocks_ms = 300; });
  EXPECT_TRUE(ticks_until({1, 0, 0}, [&] { return device_->fault() == DeviceFault::servo_late; }));
  EXPECT_FALSE(tick({1, 0, 0}).valid);
  mock_->set([](FalconFaults& f) { f.blocks_ms = 0; });
  EXPECT_TRUE(ticks_until({1, 0, 0}, [&] { return device_->fault() == DeviceFault::none; }));
}

}  // namespace
}  // namespace vallecula::device
