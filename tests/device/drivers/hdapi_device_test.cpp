// The Touch driver over the stand-in library: poses, forces, two devices, opening and closing.
#include <locale.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "device/factory.h"
#include "device/rotation.h"
#include "tests/device/allocation_guard.h"
#include "tests/device/drivers/hdapi_fixture.h"

namespace vallecula::device::hdapi {
namespace {

using namespace std::chrono_literals;

using HdapiDevice = HdapiTest;

TEST_F(HdapiDevice, TellsWhatItIs) {
  const HdDevice device("");
  const DeviceInfo info = device.info();
  EXPECT_EQ(info.kind, "touch");
  EXPECT_EQ(info.model, "Touch X");
  EXPECT_EQ(info.serial, "TX-0042");
  EXPECT_EQ(info.driver, "libHD.so");
  EXPECT_EQ(info.rate_hz, 1000.0);
  EXPECT_EQ(info.peak_force_n, 7.9);
  EXPECT_EQ(info.continuous_force_n, 1.75);
  EXPECT_EQ(info.max_stiffness_n_m, 2350.0);
  EXPECT_EQ(info.sensed_dof, 6);
  EXPECT_EQ(info.actuated_dof, 3);
  EXPECT_TRUE(info.own_axes);
  EXPECT_NEAR(info.workspace_m[0], 0.36, 1e-12);
  EXPECT_NEAR(info.workspace_m[1], 0.24, 1e-12);
  EXPECT_NEAR(info.workspace_m[2], 0.13, 1e-12);
  EXPECT_EQ(device.calibration(), Calibration::good);
  EXPECT_EQ(device.fault(), DeviceFault::none);
  EXPECT_NEAR(device.motor_warmth(), 0.1, 1e-12);
}

TEST_F(HdapiDevice, ThePoseIsTheStylusInTheDevicesAxesFromTheMiddleOfTheWorkspace) {
  const auto device = open_by_hand();
  hd.position_mm(0, 0, 15, -5);
  hd.turn(1);
  EXPECT_LT(length(device->read(0.0).position_m), 1e-15);
  hd.position_mm(0, 40, 15, -5);  // to the right
  hd.turn(1);
  EXPECT_LT(length(subtract(device->read(0.0).position_m, {0.04, 0, 0})), 1e-15);
  hd.position_mm(0, 0, 65, -5);  // up
  hd.turn(1);
  EXPECT_LT(length(subtract(device->read(0.0).position_m, {0, 0.05, 0})), 1e-15);
  hd.position_mm(0, 0, 15, 25);  // towards the person
  hd.turn(1);
  EXPECT_LT(length(subtract(device->read(0.0).position_m, {0, 0, 0.03})), 1e-15);

  // A quarter about the device's upward axis: the stylus's back end, +z, then points to the right.
  hd.transform(0, {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 15, -5, 1});
  hd.buttons(0, 2);
  hd.turn(1);
  const DeviceReading reading = device->read(0.0);
  EXPECT_TRUE(reading.valid);
  EXPECT_EQ(reading.buttons, 2U);
  EXPECT_LT(length(subtract(rotate(reading.rotation_wxyz, {0, 0, 1}), {1, 0, 0})), 1e-12);
  EXPECT_NEAR(angle_between(reading.rotation_wxyz, about_axis({0, 1, 0}, M_PI / 2)), 0.0, 1e-7);
}

TEST_F(HdapiDevice, ForcesArriveOnTheirAxesAndNeverAboveThePeak) {
  const auto device = open_by_hand();
  push(*device, {0, 0, 0}, 200);
  for (const Vector& force : {Vector{1.5, 0, 0}, Vector{0, -2.5, 0}, Vector{0, 0, 3.5}, Vector{1, 2, 3}}) {
    push(*device, force, 30);
    EXPECT_EQ(hd.given(0), force);
  }
  push(*device, {60, 0, -80}, 30);  // the peak, in the direction asked for
  EXPECT_NEAR(hd.given(0)[0], 0.6 * 7.9, 1e-12);
  EXPECT_NEAR(hd.given(0)[2], -0.8 * 7.9, 1e-12);
  EXPECT_LE(length(hd.given(0)), 7.9);
}

TEST_F(HdapiDevice, WithoutNewCommandsTheForceIsZeroAfterFiftyMillisecondsAndGrowsAgainFromZero) {
  const auto device = open_by_hand();
  push(*device, {0, 2.0, 0}, 200);
  EXPECT_EQ(hd.given(0)[1], 2.0);
  hd.turn(53);
  EXPECT_EQ(hd.given(0), (Vector{0, 0, 0}));
  EXPECT_EQ(device->fault(), DeviceFault::servo_late);
  int silent = 0;
  for (; silent < 1000 && hd.given(0)[1] == 0.0; ++silent) push(*device, {0, 2.0, 0}, 1);
  EXPECT_EQ(device->fault(), DeviceFault::none);
  EXPECT_LT(silent, 1000);
  double before = 0.0, largest_step = hd.given(0)[1];
  for (int i = 0; i < 200; ++i) {
    before = hd.given(0)[1];
    push(*device, {0, 2.0, 0}, 1);
    largest_step = std::max(largest_step, hd.given(0)[1] - before);
  }
  EXPECT_EQ(hd.given(0)[1], 2.0);
  EXPECT_LE(largest_step, 2.0 / 100 + 1e-12);  // a tenth of a second

  push(*device, {0, 0, 0}, 1);  // who leaves off with a zero is not late
  hd.turn(200);
  EXPECT_EQ(device->fault(), DeviceFault::none);
}

/// What a late turn or a burst of ticks brings at once reaches the hand over several turns; a stop is at once.
TEST_F(HdapiDevice, TheForceChangesNoFasterThanTheOutputChainLetsIt) {
  const auto device = open_by_hand();
  push(*device, {0, 1.0, 0}, 200);
  for (const Vector& to : {Vector{0, 6.0, 0}, Vector{3.0, -2.0, 1.0}, Vector{0, 1e-9, 0}}) {
    int turns = 0;
    for (; turns < 100 && hd.given(0) != to; ++turns) {
      const Vector before = hd.given(0);
      push(*device, to, 1);
      ASSERT_LE(length(subtract(hd.given(0), before)), 0.4 + 1e-12);
    }
    EXPECT_LT(turns, 25);
  }
  push(*device, {0, 5.0, 0}, 30);
  push(*device, {0, 0, 0}, 1);
  EXPECT_EQ(hd.given(0), (Vector{0, 0, 0}));
}

TEST_F(HdapiDevice, NeitherTheTickNorTheCallbackAllocates) {
  using vallecula::device::testing::allocations;
  const auto device = open_by_hand();
  push(*device, {0, 1, 0}, 10);
  const long long start = allocations();
  for (int i = 0; i < 1000; ++i) {
    device->read(0.001 * i);
    device->write({0, 1, 0});
    device->fault();
  }
  EXPECT_EQ(allocations(), start);
  // Asking the stand-in takes the test some; a thousand turns, with a fault among them, take no more than one.
  const long long before_one = allocations();
  hd.turn(1);
  const long long for_one = allocations() - before_one;
  hd.error(0, 0x201);
  const long long before_many = allocations();
  hd.turn(1000);
  EXPECT_EQ(allocations() - before_many, for_one);
}

TEST_F(HdapiDevice, TheLoopTurnsAThousandTimesASecondOfItsOwn) {
  HdDevice device("");
  hd.position_mm(0, 10, 15, -5);
  ASSERT_TRUE(within(2s, [&] {
    device.write({0, 1.25, 0});
    return length(subtract(device.read(0).position_m, {0.01, 0, 0})) < 1e-12 && hd.given(0)[1] == 1.25;
  }));
  EXPECT_TRUE(device.read(0).valid);
  EXPECT_TRUE(within(500ms, [&] { return hd.given(0) == Vector{0, 0, 0}; }));  // nobody writes any more
}

TEST_F(HdapiDevice, TwoDevicesShareOneLoopAndKeepApart) {
  auto left = open_by_hand();
  auto right = open_by_hand("Right Device");
  EXPECT_EQ(right->info().model, "Touch");
  EXPECT_EQ(hd.callbacks(), 1);
  hd.position_mm(0, 10, 15, -5);
  hd.position_mm(1, -20, 47.5, 22.5);
  for (int i = 0; i < 200; ++i) {
    left->write({0, 1, 0});
    right->write({0, 0, 9});
    hd.turn(1);
  }
  EXPECT_LT(length(subtract(left->read(0).position_m, {0.01, 0, 0})), 1e-15);
  EXPECT_LT(length(subtract(right->read(0).position_m, {-0.02, 0, 0})), 1e-15);
  EXPECT_EQ(hd.given(0), (Vector{0, 1, 0}));
  EXPECT_NEAR(hd.given(1)[2], 3.3, 1e-12);

  hd.error(1, 0x203);  // of the right one alone
  for (int i = 0; i < 2; ++i) {
    left->write({0, 1, 0});
    right->write({0, 0, 1});
    hd.turn(1);
  }
  EXPECT_EQ(hd.given(0), (Vector{0, 1, 0}));
  EXPECT_EQ(hd.given(1), (Vector{0, 0, 0}));
  EXPECT_EQ(left->fault(), DeviceFault::none);
  EXPECT_EQ(right->fault(), DeviceFault::force_exceeded);

  right.reset();
  EXPECT_TRUE(hd.running());
  EXPECT_FALSE(hd.open(1));
  for (int i = 0; i < 1000 && hd.given(0)[1] != 2.0; ++i) push(*left, {0, 2, 0}, 1);
  EXPECT_EQ(hd.given(0), (Vector{0, 2, 0}));
}

TEST_F(HdapiDevice, OpeningSaysWhatTheLibrarySays) {
  const auto error_of = [](const std::string& name) {
    try {
      HdDevice device(name);
    } catch (const DeviceError& error) {
      return std::string(error.what());
    }
    return std::string("opened");
  };
  EXPECT_NE(error_of("Nobody's Device").find("HD_COMM_CONFIG_ERROR"), std::string::npos);
  EXPECT_NE(error_of("Nobody's Device").find("'Nobody's Device'"), std::string::npos);
  hd.plugged(0, false);
  const std::string unplugged = error_of("");
  for (const char* part : {"'Default PHANToM': HD_COMM_ERROR", "communication error", "cable", "60-vallecula.rules"})
    EXPECT_NE(unplugged.find(part), std::string::npos) << unplugged;
  hd.plugged(0, true);
  hd.init_error(0, 0x600);
  EXPECT_NE(error_of("").find("licence"), std::string::npos) << error_of("");
  hd.init_error(0, 0x304);
  EXPECT_NE(error_of("").find("nother program"), std::string::npos) << error_of("");
  hd.init_error(0, 0);
  const HdDevice device("");
  EXPECT_NE(error_of("Default PHANToM").find("open already"), std::string::npos);
  EXPECT_TRUE(hd.running());
}

TEST_F(HdapiDevice, ALoopThatDoesNotStartIsSaidSoAndNothingStaysOpen) {
  for (const unsigned int code : {0x304U, 0x600U}) {
    hd.start_error(code);
    try {
      HdDevice device("");
      ADD_FAILURE() << std::hex << code;
    } catch (const DeviceError& error) {
      EXPECT_NE(std::string(error.what()).find(name_of(code)), std::string::npos) << error.what();
    }
    EXPECT_FALSE(hd.open(0));
  }
  hd.start_error(0);
  EXPECT_EQ(HdDevice("").fault(), DeviceFault::none);
}

TEST_F(HdapiDevice, TheLoopEndsWithTheLastDeviceInBoundedTimeEvenIfTheLibraryHangs) {
  auto device = std::make_unique<HdDevice>("");
  ASSERT_TRUE(within(2s, [&] {
    device->write({0, 1, 0});
    return hd.given(0)[1] == 1.0;
  }));
  hd.hang(true);
  std::thread writing([&] { EXPECT_TRUE(within(1s, [&] { return hd.given(0) == Vector{0, 0, 0}; })); });
  const auto begin = std::chrono::steady_clock::now();
  device.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 2 * Scheduler::kPatience + 1s);
  writing.join();
  try {  // the loop that nobody owns any more still turns: no second one beside it
    const HdDevice second("Right Device");
    ADD_FAILURE() << "opened";
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("does not answer"), std::string::npos) << error.what();
  }
  hd.hang(false);
  EXPECT_TRUE(within(2s, [&] { return !hd.open(0) && !hd.running() && hd.callbacks() == 0; }));
  EXPECT_EQ(HdDevice("Right Device").fault(), DeviceFault::none);
}

/// de_DE writes 7,9: the library, which reads its set-up with the thread's locale, must not see it.
TEST_F(HdapiDevice, ADecimalCommaDoesNotBreakTheLibrary) {
  const auto folder = std::filesystem::temp_directory_path() / ("vallecula-locale-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string made = "localedef -i de_DE -f UTF-8 " + (folder / "de_DE.UTF-8").string() + " >/dev/null 2>&1";
  const bool have = std::system(made.c_str()) >= 0 && setenv("LOCPATH", folder.c_str(), 1) == 0 &&
                    setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  unsetenv("LOCPATH");
  if (have) {
    EXPECT_EQ(std::strtod("7.9", nullptr), 7.0);  // so the library would read it
    const HdDevice device("");
    EXPECT_EQ(device.info().peak_force_n, 7.9);
    EXPECT_EQ(std::strtod("7,9", nullptr), 7.9);  // the user's own is as it was
    setlocale(LC_ALL, "C");
  }
  std::filesystem::remove_all(folder);
  if (!have) GTEST_SKIP() << "no German locale can be made here (localedef)";
}

TEST_F(HdapiDevice, TheFactoryAndTheListKnowIt) {
  EXPECT_EQ(make_device("touch", "")->info().serial, "TX-0042");
  EXPECT_EQ(make_device("touch", "Right Device")->info().serial, "T-0007");
}

TEST_F(HdapiDevice, TheListTellsWhatCanBeUsedAndWhy) {
  setenv("GTDD_HOME", "/nowhere", 1);
  auto found = ask_touch();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "touch");
  EXPECT_EQ(found[0].problem, "");
  EXPECT_EQ(found[0].info.model, "Touch X");
  EXPECT_EQ(found[0].calibration, Calibration::good);
  EXPECT_FALSE(hd.open(0));

  hd.held_elsewhere(0, true);
  found = ask_touch();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].problem.find("another program"), std::string::npos) << found[0].problem;
  EXPECT_FALSE(found[0].mend.empty());
  hd.held_elsewhere(0, false);

  hd.plugged(0, false);
  found = ask_touch();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "");
  EXPECT_NE(found[0].problem.find("HD_COMM_ERROR"), std::string::npos) << found[0].problem;
  EXPECT_NE(found[0].mend.find("cable"), std::string::npos) << found[0].mend;
  hd.plugged(0, true);

  // What is open here is told as it is, and stays open.
  const HdDevice device("Right Device");
  found = ask_touch();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "touch:Right Device");
  EXPECT_TRUE(hd.open(1));
  unsetenv("GTDD_HOME");
}

TEST_F(HdapiDevice, TheListTakesTheNamesThatTheVendorsSetUpWrote) {
  const auto folder = std::filesystem::temp_directory_path() / ("vallecula-gtdd-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder / "config");
  for (const char* name : {"Right Device.config", "Default PHANToM.config", "notes.txt"})
    std::ofstream(folder / "config" / name) << "";
  setenv("GTDD_HOME", folder.c_str(), 1);
  const auto found = ask_touch();
  unsetenv("GTDD_HOME");
  std::filesystem::remove_all(folder);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "touch:Default PHANToM");
  EXPECT_EQ(found[1].name, "touch:Right Device");
  EXPECT_EQ(found[1].info.peak_force_n, 3.3);
}

}  // namespace
}  // namespace vallecula::device::hdapi
