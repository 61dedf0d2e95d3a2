// The SpaceMouse driver on mocked devices, through the real hidapi.
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

#include "device/drivers/spacemouse/spacemouse_device.h"
#include "device/factory.h"
#include "device/rotation.h"
#include "tests/device/drivers/hid_umockdev.h"

namespace vallecula::device {
namespace {

using namespace std::chrono_literals;

class SpaceMouseUmockdev : public HidUmockdev {
 protected:
  /// Until `done`, a second at most many times over what it takes: a loaded machine is no fault.
  static bool wait_for(const std::function<bool()>& done) {
    for (int i = 0; i < 4000; ++i) {
      if (done()) return true;
      std::this_thread::sleep_for(2ms);
    }
    return false;
  }
  static std::string error_of(const std::string& argument) {
    try {
      const SpaceMouseDevice device(argument);
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "opened";
  }
};

TEST_F(SpaceMouseUmockdev, TheRealLibraryListsOpensReadsAndLights) {
  plug_in({});
  const auto found = find_spacemouse();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "spacemouse");
  EXPECT_EQ(found[0].info.model, "SpaceMouse Compact");
  EXPECT_EQ(found[0].problem, "");
  SpaceMouseDevice device;
  EXPECT_EQ(device.fault(), DeviceFault::none);
  std::vector<std::uint8_t> lamp;
  ASSERT_TRUE(wait_for([&] { return !(lamp = written(0)).empty(); }));
  EXPECT_EQ(lamp, (std::vector<std::uint8_t>{4, 1}));
  report(0, {3, 2, 0});
  ASSERT_TRUE(wait_for([&] { return device.read(0.0).buttons == 2u; }));
}

TEST_F(SpaceMouseUmockdev, OfAReceiversInterfacesTheOneThatSteersIsTaken) {
  MockUsb receiver;
  receiver.product = 0xc652;
  receiver.interfaces = {{0, {{1, 2}}}, {1, {{1, 6}, {1, 2}}}, {2, {{1, 8}, {1, 2}}}};
  plug_in(receiver);
  MockUsb mouse;  // Logitech's own mice and keyboards carry the same vendor number
  mouse.port = 2;
  mouse.vendor = 0x046d;
  mouse.product = 0xc077;
  mouse.interfaces = {{3, {{1, 2}}}};
  plug_in(mouse);
  MockUsb joystick = mouse;
  joystick.port = 3;
  joystick.interfaces = {{4, {{1, 8}}}};
  plug_in(joystick);
  MockUsb old;
  old.port = 4;
  old.vendor = 0x046d;
  old.product = 0xc626;
  old.interfaces = {{5, {{1, 8}}}};
  plug_in(old);
  const auto all = list_spacemice();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].path, "/dev/hidraw2");
  EXPECT_EQ(all[0].model, "3Dconnexion Universal Receiver");
  EXPECT_EQ(all[1].path, "/dev/hidraw5");
  EXPECT_EQ(all[1].model, "SpaceNavigator");
}

/// The blade follows at the stated gain and stands still once the hand is off. Reports take their time through the
/// mocked node: until one is seen to work the ticks are a microsecond long.
TEST_F(SpaceMouseUmockdev, ACapThatIsHeldSteersAndLetGoStandsStill) {
  plug_in({});
  RateSettings settings;
  settings.silence_s = 60.0;  // one report here stands for a cap that is held
  SpaceMouseDevice device("", settings);
  double time_s = 0.0;
  const auto step_of = [&](double tick_s) {
    const double before = device.read(time_s).position_m[0];
    return device.read(time_s += tick_s).position_m[0] - before;
  };
  EXPECT_EQ(step_of(0.001), 0.0);
  report(0, {1, 0x5e, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});  // 350 to the right, six axes
  ASSERT_TRUE(wait_for([&] { return step_of(1e-6) > 0.0; }));
  for (int i = 0; i < 300; ++i) step_of(0.001);
  EXPECT_NEAR(step_of(0.001), 0.001 * settings.max_speed_m_s, 1e-6 * settings.max_speed_m_s);
  report(0, {1, 0, 0});  // cut short: as if it had not come
  std::this_thread::sleep_for(100ms);
  EXPECT_NEAR(step_of(0.001), 0.001 * settings.max_speed_m_s, 1e-6 * settings.max_speed_m_s);
  const DeviceReading held = device.read(time_s);
  EXPECT_EQ(held.position_m[1], 0.0);
  EXPECT_EQ(held.position_m[2], 0.0);
  report(0, std::vector<std::uint8_t>{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  ASSERT_TRUE(wait_for([&] { return step_of(1e-6) < 0.999e-6 * settings.max_speed_m_s; }));
  for (int i = 0; i < 300; ++i) step_of(0.001);
  const DeviceReading rest = device.read(time_s);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(device.read(time_s += 0.001).position_m, rest.position_m) << "to the bit";
}

TEST_F(SpaceMouseUmockdev, UnpluggedItFreezesAndPluggedInAgainItGoesOn) {
  MockUsb usb;
  usb.serial = "A17";
  plug_in(usb);
  SpaceMouseDevice device("A17");
  report(0, {1, 0, 0, 0x5e, 1, 0, 0});
  double time_s = 0.0;
  ASSERT_TRUE(wait_for([&] { return device.read(time_s += 0.001).position_m[2] > 1e-4; })) << "pulled: towards us";
  unplug(usb);
  ASSERT_TRUE(wait_for([&] { return device.fault() == DeviceFault::unplugged; }));
  DeviceReading last;
  ASSERT_TRUE(wait_for([&] { return !(last = device.read(time_s += 0.001)).valid; }));
  EXPECT_EQ(last.buttons, 0u);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(device.read(time_s += 0.001).position_m, last.position_m);
  EXPECT_TRUE(find_spacemouse().empty());

  MockUsb other = usb;  // another one of the same model is not the one we know
  other.serial = "B18";
  other.port = 3;
  other.interfaces = {{7}};
  plug_in(other);
  MockUsb back = usb;  // the kernel may well give it another node
  back.port = 2;
  back.interfaces = {{4}};
  plug_in(back);
  ASSERT_TRUE(wait_for([&] { return device.fault() == DeviceFault::none; }));
  std::vector<std::uint8_t> lamp;
  ASSERT_TRUE(wait_for([&] { return !(lamp = written(4)).empty(); }));
  EXPECT_EQ(lamp, (std::vector<std::uint8_t>{4, 1}));
  EXPECT_TRUE(written(7).empty());
  for (int i = 0; i < 100; ++i) {
    const DeviceReading reading = device.read(time_s += 0.001);
    EXPECT_TRUE(reading.valid);
    EXPECT_EQ(reading.position_m, last.position_m) << "no jump, and no rate left over from before";
  }
  report(4, {1, 0, 0, 0xa2, 0xfe, 0, 0});
  EXPECT_TRUE(wait_for([&] { return device.read(time_s += 0.001).position_m[2] < last.position_m[2] - 1e-5; }));
}

TEST_F(SpaceMouseUmockdev, TwoAtOnceAreToldApartAndNeitherIsTakenTwice) {
  MockUsb left, right;
  left.serial = "L1";
  right.port = 2;
  right.interfaces = {{1}};
  plug_in(left);
  plug_in(right);
  const auto found = find_spacemouse();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "spacemouse:L1");
  EXPECT_EQ(found[1].name, "spacemouse:2") << "without a serial number: its number in the list";
  SpaceMouseDevice first("L1");
  EXPECT_NE(error_of("L1").find("used by this program"), std::string::npos) << error_of("L1");
  EXPECT_NE(error_of("3").find("no '3' among the 2"), std::string::npos) << error_of("3");
  SpaceMouseDevice second;
  EXPECT_EQ(first.info().serial, "L1");
  EXPECT_EQ(second.info().serial, "");
  EXPECT_NE(error_of("").find("every one"), std::string::npos) << error_of("");
  report(1, {3, 1});
  double time_s = 0.0;
  ASSERT_TRUE(wait_for([&] { return second.read(time_s += 0.001).buttons == 1u; }));
  EXPECT_EQ(first.read(0.001).buttons, 0u);
}

TEST_F(SpaceMouseUmockdev, SaysWhyItCannotBeUsed) {
  EXPECT_NE(error_of("").find("none is plugged in"), std::string::npos);
  MockUsb taken;
  taken.driver = "usbfs";
  plug_in(taken);
  auto found = find_spacemouse();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "");
  EXPECT_EQ(found[0].info.model, "SpaceMouse Compact");
  EXPECT_NE(found[0].problem.find("another program"), std::string::npos) << found[0].problem;
  EXPECT_NE(error_of("").find("another program"), std::string::npos) << error_of("");
  unplug(taken);

  plug_in({});
  ASSERT_EQ(find_spacemouse()[0].problem, "");
  if (geteuid() != 0) GTEST_SKIP() << "the permission cannot be taken from a node's owner";
  gchar* root = umockdev_testbed_get_root_dir(bed_);
  ASSERT_EQ(chmod(root, 0755), 0);
  // umockdev asks its own socket before it lets the open fail.
  ASSERT_EQ(chmod((std::string(root) + "/ioctl/dev/hidraw0").c_str(), 0777), 0);
  g_free(root);
  ASSERT_EQ(chmod(real_path(0).c_str(), 0600), 0);
  ASSERT_EQ(seteuid(65534), 0);  // as a person who is not root
  found = find_spacemouse();
  const std::string error = error_of("");
  ASSERT_EQ(seteuid(0), 0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "");
  EXPECT_NE(found[0].problem.find("may not open"), std::string::npos) << found[0].problem;
  EXPECT_NE(found[0].mend.find("60-vallecula.rules"), std::string::npos);
  EXPECT_NE(error.find("60-vallecula.rules"), std::string::npos) << error;
}

TEST_F(SpaceMouseUmockdev, EndsInTimeWhetherItIsThereOrNot) {
  const MockUsb usb;
  plug_in(usb);
  for (const bool gone : {false, true}) {
    auto device = std::make_unique<SpaceMouseDevice>();
    if (gone) {
      unplug(usb);
      ASSERT_TRUE(wait_for([&] { return device->fault() == DeviceFault::unplugged; }));
    }
    const auto begin = std::chrono::steady_clock::now();
    device.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 1s);
  }
}

}  // namespace
}  // namespace vallecula::device
