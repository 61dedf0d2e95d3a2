#include "device/factory.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

namespace vallecula::device {
namespace {

std::string error_of(const std::string& kind, const std::string& argument) {
  try {
    make_device(kind, argument);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Factory, MakesEveryKindItLists) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "vallecula-factory.csv";
  std::ofstream(file) << "0,0,0,0\n1,0,0,0.01\n";
  for (const DeviceKind& kind : device_kinds()) {
    EXPECT_FALSE(kind.description.empty());
    if (kind.hardware) continue;  // made with stand-ins by the tests of its driver
    const auto device = make_device(kind.kind, kind.argument.empty() ? "" : file.string());
    ASSERT_NE(device, nullptr);
    EXPECT_EQ(device->info().kind, kind.kind);
  }
  std::filesystem::remove(file);
}

TEST(Factory, WritesAKindAsAPersonWould) {
  EXPECT_EQ(form_of({"mouse", "", ""}), "mouse");
  EXPECT_EQ(form_of({"scripted", "FILE.csv", ""}), "scripted:FILE.csv");
  EXPECT_EQ(form_of({"touch", "[NAME]", ""}), "touch[:NAME]");
}

TEST(Factory, NamesTheKindsThereAre) {
  const std::string error = error_of("joystick", "");
  EXPECT_NE(error.find("'joystick'"), std::string::npos) << error;
  for (const DeviceKind& kind : device_kinds()) EXPECT_NE(error.find(kind.kind), std::string::npos) << error;
}

TEST(Factory, WritesAnArgumentAsAPersonDoes) {
  EXPECT_EQ(form_of({"mouse", "", ""}), "mouse");
  EXPECT_EQ(form_of({"scripted", "FILE.csv", ""}), "scripted:FILE.csv");
  EXPECT_EQ(form_of({"spacemouse", "[SERIAL]", ""}), "spacemouse[:SERIAL]");
}

TEST(Factory, SaysWhatIsWrongWithTheArgument) {
  EXPECT_NE(error_of("mouse", "left").find("no argument"), std::string::npos);
  EXPECT_NE(error_of("scripted", "").find("FILE.csv"), std::string::npos);
  EXPECT_NE(error_of("scripted", "/nowhere.csv").find("/nowhere.csv"), std::string::npos);
}

TEST(Faults, EachHasItsOwnSentence) {
  std::set<std::string> sentences;
  const auto faults = {DeviceFault::none,       DeviceFault::force_exceeded, DeviceFault::communication_lost,
                       DeviceFault::unplugged,  DeviceFault::motor_warm,     DeviceFault::non_finite_command,
                       DeviceFault::servo_late, DeviceFault::not_calibrated, DeviceFault::driver_error};
  for (const DeviceFault fault : faults) sentences.insert(describe(fault));
  EXPECT_EQ(sentences.size(), faults.size());
}

}  // namespace
}  // namespace vallecula::device
