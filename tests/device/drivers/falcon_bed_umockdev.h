// What the tests of the Falcon's driver share: a mocked Falcon, the driver on it, and a servo's ticks.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "device/drivers/falcon/falcon_device.h"
#include "device/trajectory.h"
#include "tests/device/drivers/mock_falcon_umockdev.h"
#include "tests/device/testbed_umockdev.h"

namespace vallecula::device {

using Clock = std::chrono::steady_clock;

inline double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Until it holds: many times over what it takes, for a loaded machine is no fault.
inline bool wait_for(const std::function<bool()>& condition) {
  const auto begin = Clock::now();
  while (!condition()) {
    if (since(begin) > 20.0) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

inline std::vector<std::uint8_t> some_firmware(std::size_t size = 1500) {
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>((i * 2654435761u) >> 13);
  return bytes;
}

/// Counts for a place of the grip, from the inverse and the encoder's numbers (320 slots of four counts, drum 110 mm,
/// shaft 14.25 mm, 35 degrees at zero).
inline std::array<std::int16_t, 3> encoders_at(const Vector& position) {
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
inline std::array<double, 3> motors_for(const Vector& position, const Vector& force) {
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
    folder_ = std::filesystem::path(::testing::TempDir()) / ("vallecula-falcon-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    ::setenv("VALLECULA_HOME", folder_.c_str(), 1);
    ::unsetenv("VALLECULA_FALCON_FIRMWARE");
  }
  void TearDown() override {
    device_.reset();
    mock_.reset();
    std::error_code none;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, none);
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
    ASSERT_TRUE(wait_for([&] { return tick({0, 0, 0}).valid; }));
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
  bool ticks_until(const Vector& force, const std::function<bool()>& condition) {
    return wait_for([&] {
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
  /// And that it is said within the start's own limit of twenty seconds.
  void expect_error(const std::vector<std::string>& parts, const std::string& argument = "") {
    const auto begin = Clock::now();
    const std::string error = opening_error(argument);
    for (const std::string& part : parts) EXPECT_NE(error.find(part), std::string::npos) << part << " in: " << error;
    EXPECT_EQ(error.find(folder_.string()), std::string::npos) << error;
    EXPECT_LT(since(begin), 25.0) << error;
  }

  std::filesystem::path folder_;
  const Clock::time_point begin_ = Clock::now();
  std::unique_ptr<MockFalcon> mock_;
  std::unique_ptr<FalconDevice> device_;
};

}  // namespace vallecula::device
