// The Falcon's driver on the real libusb, against a mocked bus with a chip, a processor and a hand.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <thread>

#include "device/drivers/falcon/falcon_device.h"
#include "device/factory.h"
#include "device/trajectory.h"
#include "tests/device/allocation_guard.h"
#include "tests/device/drivers/mock_falcon_umockdev.h"
#include "tests/device/testbed_umockdev.h"

namespace vallecula::device {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Strings = std::vector<std::string>;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

bool within(double seconds, const std::function<bool()>& condition) {
  const auto begin = Clock::now();
  while (!condition()) {
    if (since(begin) > seconds) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

std::vector<std::uint8_t> some_firmware(std::size_t size = 1500) {
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>((i * 2654435761u) >> 13);
  return bytes;
}

/// Counts for a place of the grip, from the inverse and the encoder's numbers (320 slots of four counts, drum 110 mm,
/// shaft 14.25 mm, 35 degrees at zero).
std::array<std::int16_t, 3> encoders_at(const Vector& position) {
  const auto angles = falcon::leg_angles(position);
  std::array<std::int16_t, 3> counts{};
  for (int leg = 0; leg < 3; ++leg) {
    const double turns = ((*angles)[leg] - 35.0 * M_PI / 180.0) / (2.0 * M_PI) * 0.110 / 0.01425;
    counts[leg] = static_cast<std::int16_t>(std::lround(turns * 1280.0));
  }
  return counts;
}

/// What the motors must be told for a force at a place: the force's work over a small way along each leg's angle, by
/// differences of the way back, over the torque of a unit.
std::array<double, 3> motors_for(const Vector& position, const Vector& force) {
  std::array<double, 3> motors{};
  const falcon::Angles angles = *falcon::leg_angles(position);
  for (int leg = 0; leg < 3; ++leg) {
    falcon::Angles more = angles, less = angles;
    more[leg] += 1e-6;
    less[leg] -= 1e-6;
    const Vector way = subtract(*falcon::position_of(more, position), *falcon::position_of(less, position));
    const double torque = (way[0] * force[0] + way[1] * force[1] + way[2] * force[2]) / 2e-6;
    motors[leg] = -torque / (1.9835e-5 * 0.110 / 0.01425);
  }
  return motors;
}

class FalconUmockdev : public TestbedUmockdev {
 protected:
  void SetUp() override {
    TestbedUmockdev::SetUp();
    if (IsSkipped()) return;
    folder_ = fs::path(::testing::TempDir()) / ("vallecula-falcon-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    ::setenv("VALLECULA_HOME", folder_.c_str(), 1);
    ::unsetenv("VALLECULA_FALCON_FIRMWARE");
  }
  void TearDown() override {
    device_.reset();
    mock_.reset();
    std::error_code none;
    if (!folder_.empty()) fs::remove_all(folder_, none);
    TestbedUmockdev::TearDown();
  }

  void write_file(const std::string& name, const std::vector<std::uint8_t>& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  /// Plugged in and running, opened.
  void open_running() {
    mock_ = std::make_unique<MockFalcon>(bed_, std::vector<std::uint8_t>());
    mock_->plug();
    device_ = std::make_unique<FalconDevice>();
  }
  void open_homed(const Vector& at = {0, 0, 0}) {
    open_running();
    mock_->put(encoders_at(at));
    mock_->home();
    ASSERT_TRUE(within(2.0, [&] { return tick({0, 0, 0}).valid; }));
  }

  /// One tick of the servo.
  DeviceReading tick(const Vector& force) {
    const DeviceReading reading = device_->read(since(begin_));
    device_->write(force);
    return reading;
  }
  DeviceReading ticks(const Vector& force, double seconds) {
    DeviceReading reading;
    for (const auto begin = Clock::now(); since(begin) < seconds;) {
      reading = tick(force);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return reading;
  }
  bool ticks_until(double seconds, const Vector& force, const std::function<bool()>& condition) {
    return within(seconds, [&] {
      tick(force);
      return condition();
    });
  }
  bool motors_zero() const { return mock_->seen().motors == std::array<int, 3>{}; }

  std::string opening_error(const std::string& argument = "") {
    try {
      FalconDevice falcon(argument);
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "opened";
  }
  void expect_error(const Strings& parts, double within_s, const std::string& argument = "") {
    const auto begin = Clock::now();
    const std::string error = opening_error(argument);
    for (const std::string& part : parts) EXPECT_NE(error.find(part), std::string::npos) << part << " in: " << error;
    EXPECT_EQ(error.find(folder_.string()), std::string::npos) << error;
    EXPECT_LT(since(begin), within_s) << error;
  }

  fs::path folder_;
  const Clock::time_point begin_ = Clock::now();
  std::unique_ptr<MockFalcon> mock_;
  std::unique_ptr<FalconDevice> device_;
};

TEST_F(FalconUmockdev, IsFoundAndWhatItLacksIsSaid) {
  EXPECT_TRUE(find_falcon().empty());
  MockFalcon mock(bed_, some_firmware());
  mock.plug();
  auto found = find_falcon();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "falcon");
  EXPECT_EQ(found[0].info.serial, MockFalcon::serial());
  EXPECT_EQ(found[0].info.driver, "libusb");
  EXPECT_EQ(found[0].info.sensed_dof, 3);
  EXPECT_EQ(found[0].calibration, Calibration::needs_hand);
  EXPECT_NE(found[0].problem.find("firmware"), std::string::npos);
  EXPECT_NE(found[0].mend.find("VALLECULA_FALCON_FIRMWARE"), std::string::npos);

  write_file("falcon.bin", some_firmware());
  found = find_falcon();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].problem, "");
  EXPECT_EQ(mock.seen().commands, 0);  // nothing was started

  mock.set([](FalconFaults& f) { f.held = true; });
  found = find_falcon();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].problem.find("another program"), std::string::npos);
  EXPECT_EQ(found[0].name, "");

  mock.unplug();
  EXPECT_TRUE(within(2.0, [] { return find_falcon().empty(); }));
}

TEST_F(FalconUmockdev, TheFactoryMakesIt) {
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
  mock_->plug();
  write_file("my.bin", some_firmware());
  const auto made = make_device("falcon", (folder_ / "my.bin").string());
  EXPECT_EQ(made->info().kind, "falcon");
  EXPECT_EQ(made->info().serial, MockFalcon::serial());
  EXPECT_TRUE(made->info().own_axes);
  EXPECT_EQ(made->info().peak_force_n, 8.0);
  EXPECT_EQ(mock_->seen().loads, 1);
}

/// The order of the requests is that of the notes on the device, written down here anew.
TEST_F(FalconUmockdev, StartsStepByStep) {
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
  mock_->plug();
  write_file("falcon.bin", some_firmware());
  device_ = std::make_unique<FalconDevice>();
  const auto seen = mock_->seen();
  const std::vector<std::pair<int, int>> expected{
      {9, 1},     {3, 0x2},    {0, 1},     {0, 2},   // does it answer packets already?
      {0, 1},     {0, 2},                            // purge
      {9, 16},    {3, 0x4138}, {4, 8},     {2, 0},   // latency, 9600 baud, 8N1, no flow control
      {1, 0x200}, {1, 0x100},  {1, 0x101},           // RTS low, DTR low then high; greeting
      {1, 0x100}, {3, 0x15},                         // DTR low, the loader's speed; firmware
      {9, 1},     {3, 0x2},    {0, 1},     {0, 2}};  // packets
  EXPECT_EQ(seen.requests, expected);
  ASSERT_EQ(seen.chunks.size(), (1500u + 61) / 62);
  for (std::size_t i = 0; i + 1 < seen.chunks.size(); ++i) EXPECT_EQ(seen.chunks[i], 62);
  EXPECT_EQ(seen.loads, 1);
  EXPECT_TRUE(within(1.0, [&] { return mock_->seen().homing; }));
}

TEST_F(FalconUmockdev, OneThatRunsIsNotLoadedAgain) {
  open_running();  // and no firmware file anywhere
  EXPECT_EQ(mock_->seen().loads, 0);
  EXPECT_EQ(mock_->seen().requests.size(), 4u);
  EXPECT_TRUE(ticks_until(1.0, {0, 0, 0}, [&] { return mock_->seen().commands > 20; }));
}

TEST_F(FalconUmockdev, FailuresToOpenAreNamed) {
  expect_error({"no Falcon is plugged in", "power supply"}, 1.0);
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
  mock_->plug();
  expect_error({"firmware", "~/.local/share/vallecula/falcon.bin", "falcon:FIRMWARE.bin"}, 3.0);
  expect_error({"named is not there"}, 1.0, (folder_ / "none.bin").string());
  expect_error({"named is not there"}, 1.0, folder_.string());
  write_file("small.bin", some_firmware(1000));
  expect_error({"1000 bytes", "1024"}, 1.0, (folder_ / "small.bin").string());
  write_file("large.bin", std::vector<std::uint8_t>(300000));
  expect_error({"300000 bytes"}, 1.0, (folder_ / "large.bin").string());
  ::setenv("VALLECULA_FALCON_FIRMWARE", (folder_ / "none.bin").c_str(), 1);
  expect_error({"VALLECULA_FALCON_FIRMWARE"}, 1.0);
  write_file("falcon.bin", some_firmware());
  ::unsetenv("VALLECULA_FALCON_FIRMWARE");
  mock_->set([](FalconFaults& f) { f.held = true; });
  expect_error({"another program"}, 1.0);
  mock_->set([](FalconFaults& f) { f = {}; });
  mock_->set([](FalconFaults& f) { f.stalls_out = 1000; });
  expect_error({"asking for a packet", "bus refused"}, 3.0);
}

TEST_F(FalconUmockdev, FailuresOfTheStartAreNamed) {
  write_file("falcon.bin", some_firmware());
  const auto with = [&](const std::function<void(FalconFaults&)>& fault, const Strings& parts) {
    mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
    mock_->set(fault);
    mock_->plug();
    expect_error(parts, 15.0);
    mock_->unplug();
    mock_.reset();
  };
  with([](FalconFaults& f) { f.deaf_to_hello = true; }, {"first greeting", "power supply"});
  with([](FalconFaults& f) { f.loader_dead = true; }, {"loader does not answer"});
  with([](FalconFaults& f) { f.wrong_echo_at = 700; }, {"echo", "from byte 682"});  // the eleventh chunk's begin
  with([](FalconFaults& f) { f.dies_of_firmware = true; }, {"took the firmware but does not answer"});
}

TEST_F(FalconUmockdev, TheStartEndsInTimeAndWhenItIsStopped) {
  const auto start_error = [&](std::atomic<bool>& stop, std::chrono::milliseconds longest) {
    falcon::FalconUsb usb;
    EXPECT_EQ(usb.open().what, "");
    try {
      falcon::start(usb, some_firmware(60000), stop, longest);
    } catch (const DeviceError& error) {
      return std::string(error.what());
    }
    return std::string("started");
  };
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware(60000));
  mock_->set([](FalconFaults& f) { f.late_ms = 60; });  // every echo: a minute for this firmware
  mock_->plug();
  std::atomic<bool> stop{false};
  auto begin = Clock::now();
  EXPECT_NE(start_error(stop, std::chrono::milliseconds(1500)).find("takes too long"), std::string::npos);
  EXPECT_LT(since(begin), 2.5);

  begin = Clock::now();
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    stop = true;
  });
  EXPECT_NE(start_error(stop, std::chrono::seconds(20)).find("given up"), std::string::npos);
  EXPECT_LT(since(begin), 1.7);
  other.join();
}

TEST_F(FalconUmockdev, NoForceBeforeItIsHomed) {
  open_running();
  mock_->put({500, 500, 500});
  ticks({3, -4, 5}, 0.2);
  EXPECT_TRUE(ticks_until(1.0, {3, -4, 5}, [&] { return device_->fault() == DeviceFault::not_calibrated; }));
  EXPECT_EQ(device_->calibration(), Calibration::needs_hand);
  EXPECT_FALSE(tick({3, -4, 5}).valid);
  EXPECT_EQ(mock_->seen().largest_motor_unhomed, 0);
  EXPECT_EQ(mock_->seen().lights, falcon::kRedLight);
  EXPECT_TRUE(mock_->seen().homing);

  mock_->home();
  EXPECT_TRUE(ticks_until(1.0, {3, -4, 5}, [&] { return tick({3, -4, 5}).valid; }));
  EXPECT_EQ(device_->calibration(), Calibration::good);
  EXPECT_TRUE(ticks_until(1.0, {3, -4, 5}, [&] { return !motors_zero(); }));
  EXPECT_EQ(mock_->seen().lights, falcon::kGreenLight);

  mock_->home(false);  // it lost its count
  EXPECT_TRUE(ticks_until(1.0, {3, -4, 5}, [&] { return device_->fault() == DeviceFault::not_calibrated; }));
  EXPECT_TRUE(ticks_until(1.0, {3, -4, 5}, [&] { return motors_zero(); }));
}

TEST_F(FalconUmockdev, ReadsPlaceAndButtons) {
  open_homed();
  for (const Vector& place : {Vector{0.02, 0.01, -0.01}, Vector{-0.03, 0.02, 0.02}, Vector{0.0, -0.04, 0.0}}) {
    mock_->put(encoders_at(place), 5);
    DeviceReading reading;
    EXPECT_TRUE(ticks_until(1.0, {0, 0, 0}, [&] {
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
    ASSERT_TRUE(ticks_until(1.0, {0, 0, 0}, [&] {
      return length(subtract(tick({0, 0, 0}).position_m, place)) < 6e-5;
    }));
    const Vector read = tick({0, 0, 0}).position_m;
    for (const Vector& force : {Vector{1, 0, 0}, Vector{0, -2, 0}, Vector{0, 0, 2.5}, Vector{1.5, -1, 2}}) {
      const auto expected = motors_for(read, force);
      const auto right = [&] {
        const auto motors = mock_->seen().motors;
        bool all = true;
        for (int leg = 0; leg < 3; ++leg) all = all && std::abs(motors[leg] - expected[leg]) < 0.51;  // rounding
        return all;
      };
      EXPECT_TRUE(ticks_until(1.0, force, right))
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
    EXPECT_TRUE(ticks_until(1.0, force, along)) << force[0];
  }
}

TEST_F(FalconUmockdev, WhatIsNotANumberIsNoForce) {
  open_homed();
  for (int axis = 0; axis < 3; ++axis) {
    ASSERT_TRUE(ticks_until(1.0, {1, 1, 1}, [&] { return !motors_zero(); }));
    Vector bad{1, 1, 1};
    bad[axis] = axis == 1 ? HUGE_VAL : std::nan("");
    EXPECT_TRUE(ticks_until(1.0, bad, [&] { return motors_zero(); }));
    EXPECT_TRUE(ticks_until(1.0, bad, [&] { return device_->fault() == DeviceFault::non_finite_command; }));
    EXPECT_TRUE(ticks_until(1.0, {1, 1, 1}, [&] { return device_->fault() == DeviceFault::none; }));
  }
}

TEST_F(FalconUmockdev, AServoThatStopsIsNoForce) {
  open_homed();
  ASSERT_TRUE(ticks_until(1.0, {2, 2, 2}, [&] { return !motors_zero(); }));
  const auto stopped = Clock::now();
  EXPECT_TRUE(within(1.0, [&] { return motors_zero(); }));
  EXPECT_GT(since(stopped), 0.03);  // it holds for 50 ms from the last command
  EXPECT_TRUE(ticks_until(1.0, {2, 2, 2}, [&] { return !motors_zero(); }));
}

TEST_F(FalconUmockdev, UnpluggedAndPluggedInAgain) {
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
  mock_->plug();
  write_file("falcon.bin", some_firmware());
  device_ = std::make_unique<FalconDevice>();
  mock_->put(encoders_at({0.01, 0.01, 0.01}));
  mock_->home();
  ASSERT_TRUE(ticks_until(2.0, {1, 1, 1}, [&] { return !motors_zero(); }));
  for (int time = 1; time <= 3; ++time) {
    const DeviceReading before = tick({1, 1, 1});
    mock_->unplug();
    ASSERT_TRUE(ticks_until(1.0, {1, 1, 1}, [&] { return device_->fault() == DeviceFault::unplugged; }));
    DeviceReading reading = ticks({1, 1, 1}, 0.6);  // and is looked for meanwhile
    EXPECT_FALSE(reading.valid);
    EXPECT_LT(length(subtract(reading.position_m, before.position_m)), 1e-9);  // Newton's last bits
    EXPECT_EQ(device_->fault(), DeviceFault::unplugged);
    EXPECT_EQ(device_->calibration(), Calibration::needs_hand);

    const long commands = mock_->seen().commands;
    mock_->plug();
    ASSERT_TRUE(ticks_until(8.0, {1, 1, 1}, [&] { return device_->fault() == DeviceFault::not_calibrated; }));
    EXPECT_EQ(mock_->seen().loads, 1 + time);
    EXPECT_GT(mock_->seen().commands, commands);
    EXPECT_TRUE(motors_zero());
    mock_->home();
    ASSERT_TRUE(ticks_until(2.0, {1, 1, 1}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
  }
  EXPECT_EQ(mock_->seen().largest_motor_unhomed, 0);
}

TEST_F(FalconUmockdev, SilenceIsAFaultAndNoForce) {
  open_homed();
  ASSERT_TRUE(ticks_until(1.0, {2, 2, 2}, [&] { return !motors_zero(); }));
  mock_->set([](FalconFaults& f) { f.silent = true; });
  const auto begin = Clock::now();
  ASSERT_TRUE(ticks_until(1.0, {2, 2, 2}, [&] { return device_->fault() == DeviceFault::communication_lost; }));
  EXPECT_LT(since(begin), 0.3);
  EXPECT_TRUE(motors_zero());
  EXPECT_FALSE(tick({2, 2, 2}).valid);
  mock_->set([](FalconFaults& f) { f.silent = false; });
  EXPECT_TRUE(ticks_until(4.0, {2, 2, 2}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
  // Longer than it waits: opened anew.
  mock_->set([](FalconFaults& f) { f.silent = true; });
  const std::size_t requests = mock_->seen().requests.size();
  ASSERT_TRUE(ticks_until(6.0, {2, 2, 2}, [&] { return mock_->seen().requests.size() > requests; }));
  mock_->set([](FalconFaults& f) { f.silent = false; });
  EXPECT_TRUE(ticks_until(8.0, {2, 2, 2}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
}

TEST_F(FalconUmockdev, StallsPassAndLongOnesAreAFault) {
  open_homed();
  mock_->set([](FalconFaults& f) { f.stalls_out = 2, f.stalls_in = 2; });
  EXPECT_TRUE(ticks_until(1.0, {2, 2, 2}, [&] {
    bool over = false;
    mock_->set([&](FalconFaults& f) { over = f.stalls_out == 0 && f.stalls_in == 0; });
    return over && device_->fault() == DeviceFault::none && !motors_zero();
  }));
  mock_->set([](FalconFaults& f) { f.stalls_out = 1000000; });
  EXPECT_TRUE(ticks_until(1.0, {2, 2, 2}, [&] { return device_->fault() == DeviceFault::communication_lost; }));
  mock_->set([](FalconFaults& f) { f.stalls_out = 0; });
  EXPECT_TRUE(ticks_until(4.0, {2, 2, 2}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
}

TEST_F(FalconUmockdev, BrokenFlippedLateAndRepeatedAnswers) {
  const Vector place{0.01, -0.01, 0.02};
  open_homed(place);
  const auto stays = [&] {
    return ticks_until(1.0, {0, 0, 1}, [&] { return device_->fault() == DeviceFault::none; }) &&
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
  EXPECT_TRUE(ticks_until(2.0, {0, 0, 1}, [&] { return stays(); }));
  const Vector next{0.0, 0.0, 0.0};  // not one answer behind
  mock_->put(encoders_at(next));
  EXPECT_TRUE(ticks_until(1.0, {0, 0, 0}, [&] { return length(subtract(tick({0, 0, 0}).position_m, next)) < 6e-5; }));
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
  EXPECT_TRUE(ticks_until(8.0, {1, 1, 1}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
}

TEST_F(FalconUmockdev, ItEndsWithoutForceWhateverHappens) {
  open_homed();
  ASSERT_TRUE(ticks_until(1.0, {2, 2, 2}, [&] { return !motors_zero(); }));
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
    EXPECT_LT(since(begin), 1.0);
  };
  ends([&] { mock_->set([](FalconFaults& f) { f.silent = true; }); });
  mock_->set([](FalconFaults& f) { f = {}; });
  ends([&] { mock_->set([](FalconFaults& f) { f.stalls_out = 1000000; }); });
  mock_->set([](FalconFaults& f) { f = {}; });
  ends([&] { mock_->unplug(); });
}

TEST_F(FalconUmockdev, ASecondOneIsToldThatItIsTaken) {
  open_homed();
  const auto found = find_falcon();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].problem.find("another program"), std::string::npos);
  expect_error({"another program"}, 1.0);
  EXPECT_TRUE(ticks_until(1.0, {1, 0, 0}, [&] { return device_->fault() == DeviceFault::none && !motors_zero(); }));
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
  EXPECT_TRUE(ticks_until(2.0, {1, 0, 0}, [&] { return device_->fault() == DeviceFault::servo_late; }));
  EXPECT_FALSE(tick({1, 0, 0}).valid);
  mock_->set([](FalconFaults& f) { f.blocks_ms = 0; });
  EXPECT_TRUE(ticks_until(4.0, {1, 0, 0}, [&] { return device_->fault() == DeviceFault::none; }));
}

/// A figure, not a verdict: how often the mocked bus lets the driver ask.
TEST_F(FalconUmockdev, HowOftenItAsks) {
  open_homed();
  const long before = mock_->seen().commands;
  const auto begin = Clock::now();
  ticks({1, 0, 0}, 1.0);
  const double rate = static_cast<double>(mock_->seen().commands - before) / since(begin);
  std::printf("the mocked Falcon was asked %.0f times a second\n", rate);
  EXPECT_GT(rate, 50.0);
}

}  // namespace
}  // namespace vallecula::device
