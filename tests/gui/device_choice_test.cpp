// Whatever the device factory makes can be named, chosen and used.
#include "gui/session/device_choice.h"

#include <gtest/gtest.h>

#include "device/drivers/scripted_device.h"
#include "device/factory.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

TEST(DeviceChoice, TakesEveryKindOfTheFactory) {
  const Sandbox box;
  const std::string csv = write_press(box.folder()).string();
  const pipeline::PatientPackage patient = block_patient();
  for (const device::DeviceKind& kind : device::device_kinds()) {
    const bool optional = !kind.argument.empty() && kind.argument.front() == '[';
    const std::string name = kind.kind + (kind.argument.empty() || optional ? "" : ":" + csv);
    EXPECT_NO_THROW(check_device_name(name)) << name;
    EXPECT_NE(device_names().find(device::form_of(kind)), std::string::npos);
    EXPECT_THROW(check_device_name(kind.kind + (optional ? ":" : kind.argument.empty() ? ":x" : "")), UnknownDevice);
    if (optional) {
      EXPECT_NO_THROW(check_device_name(kind.kind + ":x"));
    }
    if (kind.hardware) continue;  // made by the tests of its driver
    EXPECT_EQ(make_device(name, {patient, {}, nullptr})->info().kind, kind.kind);
  }
  for (const std::string hand : {"scripted:expert", "scripted:novice"}) {
    EXPECT_TRUE(is_scripted(hand));
    EXPECT_EQ(make_device(hand, {patient, {}, nullptr})->info().kind, "scripted");
  }
  EXPECT_FALSE(is_scripted("mouse"));
}

TEST(DeviceChoice, AnUnknownNameIsAnsweredWithAllThereAre) {
  for (const std::string name :
       {"joystick", "", "mouse:left", "scripted", "scripted:", "scripted:.csv", "scripted:a.txt"}) {
    try {
      check_device_name(name);
      FAIL() << name;
    } catch (const UnknownDevice& error) {
      for (const std::string part : {"mouse", "scripted:expert", "scripted:press", "scripted:FILE.csv"})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

TEST(DeviceChoice, ARecordIsAFileOrTheFolderOfATrial) {
  const Sandbox box;
  EXPECT_NO_THROW(check_device_name("recorded:" + box.folder().string()));
  EXPECT_NO_THROW(check_device_name("recorded:" + (box / "trial.vtrial").string()));
  for (const std::string& name :
       {std::string("recorded:"), "recorded:" + (box / "t1").string(), std::string("recorded:hand.csv")}) {
    try {
      check_device_name(name);
      FAIL() << name;
    } catch (const UnknownDevice& error) {
      EXPECT_NE(std::string(error.what()).find("no .vtrial file and no folder"), std::string::npos) << error.what();
    }
  }
}

/// A planned hand and a hand from a file yield alike: 1 N moves either by the same third of a millimetre.
TEST(DeviceChoice, EveryScriptedHandIsEquallyFirm) {
  const Sandbox box;
  const pipeline::PatientPackage patient = block_patient();
  for (const std::string& name : {"scripted:" + write_press(box.folder()).string(), std::string("scripted:expert")}) {
    const auto pushed = make_device(name, {patient, {}, nullptr}), free = make_device(name, {patient, {}, nullptr});
    device::DeviceReading a, b;
    for (int i = 0; i < 200; ++i) {
      a = pushed->read(0.001 * i);
      b = free->read(0.001 * i);
      pushed->write({1.0, 0.0, 0.0});
      free->write({0.0, 0.0, 0.0});
    }
    EXPECT_NEAR(a.position_m[0] - b.position_m[0], 1.0 / device::firm_hand().stiffness_n_m, 1e-9) << name;
  }
}

}  // namespace
}  // namespace vallecula::gui::test
