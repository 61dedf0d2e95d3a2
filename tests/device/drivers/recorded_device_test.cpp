#include "device/drivers/recorded_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device/guarded_device.h"
#include "tests/device/allocation_guard.h"

namespace vallecula::device {
namespace {

std::vector<TimedReading> record() {
  std::vector<TimedReading> readings(2000);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    readings[i].time_s = static_cast<double>(i) * 0.001;
    readings[i].reading.position_m = {std::sin(0.01 * static_cast<double>(i)), 0.1, -0.2};
    readings[i].reading.buttons = i > 700 ? 2 : 0;
    readings[i].reading.valid = i < 500 || i >= 900;
  }
  return readings;
}

TEST(RecordedDevice, GivesBackEveryTickThroughTheGuardToTheBit) {
  const std::vector<TimedReading> readings = record();
  RecordedDevice device(readings, 7.9);
  GuardedDevice guard(device, guard_for(device.info()));
  const long long before = testing::allocations();
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const DeviceReading now = guard.read(0.001 * static_cast<double>(i));
    guard.see_tool({0, 0, 0}, {1, 0, 0, 0});
    const auto sent = guard.write({1, 1, 1});
    ASSERT_EQ(now.position_m, readings[i].reading.position_m);
    ASSERT_EQ(now.valid, readings[i].reading.valid) << i;
    ASSERT_EQ(now.buttons, readings[i].reading.buttons);
    if (!now.valid) {
      ASSERT_EQ(sent, (std::array<double, 3>{0, 0, 0}));
    }
  }
  EXPECT_EQ(testing::allocations(), before);
  EXPECT_FALSE(device.finished(1.999));
  EXPECT_TRUE(device.finished(2.0));
}

TEST(RecordedDevice, RefusesWhatIsNoRecord) {
  EXPECT_THROW(RecordedDevice({}, 7.9), DeviceError);
  EXPECT_THROW(RecordedDevice(std::vector<TimedReading>(2), 7.9), DeviceError);
  EXPECT_THROW(RecordedDevice(record(), -1.0), DeviceError);
  EXPECT_THROW(RecordedDevice(record(), std::numeric_limits<double>::quiet_NaN()), DeviceError);
}

}  // namespace
}  // namespace vallecula::device
