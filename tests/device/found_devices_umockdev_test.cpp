#include <algorithm>

#include "device/found_devices.h"
#include "tests/device/testbed_umockdev.h"

namespace vallecula::device {
namespace {

class FoundDevicesUmockdev : public TestbedUmockdev {};

TEST_F(FoundDevicesUmockdev, TheMouseIsAlwaysThere) {
  const auto found = find_devices();
  EXPECT_EQ(std::count_if(found.begin(), found.end(), [](const FoundDevice& one) { return one.name == "mouse"; }), 1);
}

}  // namespace
}  // namespace vallecula::device
