#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <thread>

#include "device/found_devices.h"
#include "tests/device/drivers/hid_umockdev.h"

namespace vallecula::device {
namespace {

class FoundDevicesUmockdev : public HidUmockdev {
 protected:
  static long named(const std::string& name) {
    const auto found = find_devices();
    return std::count_if(found.begin(), found.end(), [&name](const FoundDevice& one) { return one.name == name; });
  }
  static long open_files() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator());
  }
  /// Files this process keeps: the mocked bus is served by a thread of this same process, whose end of a connection
  /// closes some time after ours, so the fewest over a while is counted.
  static long kept_files() {
    long fewest = open_files();
    for (int i = 0; i < 100; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      fewest = std::min(fewest, open_files());
    }
    return fewest;
  }
};

TEST_F(FoundDevicesUmockdev, TheMouseIsAlwaysThereAndOthersComeAndGo) {
  EXPECT_EQ(named("mouse"), 1);
  EXPECT_EQ(named("spacemouse"), 0);
  const MockUsb usb;
  plug_in(usb);
  EXPECT_EQ(named("mouse"), 1);
  EXPECT_EQ(named("spacemouse"), 1);
  unplug(usb);
  EXPECT_EQ(named("spacemouse"), 0);
}

/// The window asks once a second, for hours.
TEST_F(FoundDevicesUmockdev, AThousandCallsKeepNothing) {
  const MockUsb usb;
  plug_in(usb);
  for (int i = 0; i < 20; ++i) find_devices();
  const long files = kept_files();
  const std::size_t before = mallinfo2().uordblks;
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(named("spacemouse"), 1);
  EXPECT_EQ(kept_files(), files);
  EXPECT_LT(mallinfo2().uordblks, before + 100 * 1000) << "bytes in use grew by a hundred a call or more";
}

}  // namespace
}  // namespace vallecula::device
