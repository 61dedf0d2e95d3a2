#include "device/drivers/open_trouble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>

#include "device/drivers/spacemouse/spacemouse_models.h"

namespace vallecula::device {
namespace {

TEST(OpenTrouble, TellsPermissionHeldAndGoneApart) {
  EXPECT_NE(open_trouble(EACCES).mend.find("60-vallecula.rules"), std::string::npos);
  EXPECT_EQ(open_trouble(EPERM).problem, open_trouble(EACCES).problem);
  EXPECT_NE(open_trouble(EBUSY).problem.find("another program"), std::string::npos);
  EXPECT_EQ(open_trouble(EBUSY).mend.find("rules"), std::string::npos);
  std::set<std::string> said;
  for (const int error : {EACCES, EBUSY, ENOENT, EIO, EMFILE}) {
    said.insert(open_trouble(error).problem);
    EXPECT_FALSE(open_trouble(error).mend.empty());
  }
  EXPECT_EQ(said.size(), 5u);
}

/// What the drivers know must stand in the rule that lets a person at it, in the form udev matches.
TEST(UdevRule, LetsAPersonAtEveryDeviceTheDriversKnow) {
  std::ifstream in(std::string(VALLECULA_SOURCE_DIR) + "/packaging/60-vallecula.rules");
  ASSERT_TRUE(in);
  const std::string rules{std::istreambuf_iterator<char>(in), {}};
  const auto rule_with = [&rules](const std::string& a, const std::string& b) {
    for (std::size_t at = 0; at < rules.size();) {
      const std::size_t end = std::min(rules.find('\n', at), rules.size());
      const std::string line = rules.substr(at, end - at);
      at = end + 1;
      if (line.rfind('#', 0) != 0 && line.find(a) != std::string::npos && line.find(b) != std::string::npos &&
          line.find("TAG+=\"uaccess\"") != std::string::npos)
        return true;
    }
    return false;
  };
  char text[64];
  for (const SpaceMouseModel& model : spacemouse_models()) {
    // By cable the numbers are the USB device's; by Bluetooth only the HID node's name holds them, in capitals.
    std::snprintf(text, sizeof(text), "ATTRS{idVendor}==\"%04x\"", model.vendor);
    const std::string vendor = text;
    std::snprintf(text, sizeof(text), "ATTRS{idProduct}==\"%04x\"", model.product);
    const bool whole_vendor = model.vendor == k3DconnexionVendor;
    EXPECT_TRUE(rule_with("SUBSYSTEM==\"hidraw\", " + vendor, whole_vendor ? "" : text)) << model.name;
  }
  EXPECT_TRUE(rule_with("KERNELS==\"0005:256F:*\"", "SUBSYSTEM==\"hidraw\"")) << "by Bluetooth";
  EXPECT_TRUE(rule_with("SUBSYSTEM==\"usb\", ATTR{idVendor}==\"0403\"", "ATTR{idProduct}==\"cb48\"")) << "Falcon";
  EXPECT_TRUE(rule_with("SUBSYSTEM==\"hidraw\", ATTRS{idVendor}==\"2988\"", "")) << "Touch";
}

}  // namespace
}  // namespace vallecula::device
