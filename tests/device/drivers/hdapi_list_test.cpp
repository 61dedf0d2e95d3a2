// Touch devices are listed on one thread while another opens them.
#include "device/trajectory.h"
#include "tests/device/drivers/hdapi_fixture.h"

namespace vallecula::device::hdapi {
namespace {

class HdapiList : public HdapiTest {
 protected:
  static std::string opening_error(const std::string& name) {
    try {
      const HdDevice device(name);
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "opened";
  }
};

TEST_F(HdapiList, ListingAndOpeningNeverMeet) {
  setenv("GTDD_HOME", "/nowhere", 1);
  std::atomic<bool> stop{false};
  std::atomic<int> lists{0}, untold{0};
  std::thread listing([&] {
    for (; !stop; ++lists) {
      const auto found = ask_touch();
      untold += found.size() != 1 || found[0].name != "touch";
    }
  });
  EXPECT_TRUE(within(std::chrono::seconds(20), [&] { return lists > 0; }));
  for (int i = 0; i < 30; ++i) EXPECT_EQ(opening_error(""), "opened");
  stop = true;
  listing.join();
  unsetenv("GTDD_HOME");
  EXPECT_EQ(untold, 0);
}

TEST_F(HdapiList, OurOwnIsNoOtherPrograms) {
  const HdDevice device("Right Device");
  EXPECT_NE(opening_error("Right Device").find("used by this program"), std::string::npos);
  EXPECT_TRUE(hd.open(1));
}

}  // namespace
}  // namespace vallecula::device::hdapi
