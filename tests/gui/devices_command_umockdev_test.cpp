// `vallecula devices` as a person runs it, on mocked devices.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "tests/device/drivers/hid_umockdev.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

class DevicesCommandUmockdev : public device::HidUmockdev {
 protected:
  /// The list as JSON tells it.
  QJsonArray listed() {
    const Outcome outcome = box_.run({"devices", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return QJsonDocument::fromJson(QByteArray::fromStdString(outcome.out)).object()["devices"].toArray();
  }
  /// The one of this kind; empty if there is none.
  QJsonObject listed(const QString& kind) {
    for (const auto& value : listed())
      if (value.toObject()["kind"].toString() == kind) return value.toObject();
    return {};
  }
  const Sandbox box_;
};

TEST_F(DevicesCommandUmockdev, TellsWhatIsPluggedInAndWhatItCanDo) {
  for (const char* kind : {"spacemouse", "falcon"}) {
    const QJsonObject none = listed(kind);
    EXPECT_EQ(none["problem"].toString(), "none plugged in") << kind;
    EXPECT_TRUE(none["name"].isNull() && !none["usable"].toBool()) << kind;
    for (const char* figure : {"rate_hz", "peak_force_n", "continuous_force_n", "workspace_mm", "calibration"})
      EXPECT_TRUE(none.contains(figure) && none[figure].isNull()) << kind << ": " << figure << " is not known";
  }
  EXPECT_NE(box_.run({"devices"}).out.find("not known"), std::string::npos);
  device::MockUsb usb;
  usb.serial = "A17";
  plug_in(usb);
  const QJsonArray all = listed();
  const QJsonObject found = listed("spacemouse");
  EXPECT_EQ(found["name"].toString(), "spacemouse");
  EXPECT_EQ(std::count_if(all.begin(), all.end(),
                          [](const auto& one) { return one.toObject()["kind"].toString() == "spacemouse"; }),
            1);
  EXPECT_EQ(found["model"].toString(), "SpaceMouse Compact");
  EXPECT_EQ(found["serial"].toString(), "A17");
  EXPECT_EQ(found["driver"].toString(), "hidapi");
  EXPECT_TRUE(found["usable"].toBool());
  EXPECT_TRUE(found["problem"].isNull());
  EXPECT_EQ(found["peak_force_n"].toDouble(-1.0), 0.0);
  EXPECT_EQ(found["workspace_mm"].toArray().size(), 3);
  EXPECT_EQ(found["rate_hz"].toDouble(), 125.0);
  EXPECT_EQ(listed("mouse")["name"].toString(), "mouse");

  const Outcome table = box_.run({"devices"});
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_EQ(table.out.rfind("name ", 0), 0u) << table.out;
  EXPECT_NE(table.out.find("\nspacemouse  SpaceMouse Compact (A17)  hidapi "), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("400 x 400 x 400 mm"), std::string::npos) << table.out;
}

TEST_F(DevicesCommandUmockdev, SaysWhyOneCannotBeUsedAndExitsWithZero) {
  device::MockUsb usb;
  usb.driver = "usbfs";
  plug_in(usb);
  const QJsonObject found = listed("spacemouse");
  EXPECT_FALSE(found["usable"].toBool());
  EXPECT_TRUE(found["name"].isNull());
  EXPECT_NE(found["problem"].toString().indexOf("another program"), -1);
  EXPECT_FALSE(found["mend"].toString().isEmpty());
  const Outcome table = box_.run({"devices"});
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_NE(table.out.find("\n    another program holds it; close"), std::string::npos) << table.out;
}

TEST_F(DevicesCommandUmockdev, WrongUsageIsToldApart) {
  EXPECT_EQ(box_.run({"devices", "all"}).exit_code, 2);
  EXPECT_EQ(box_.run({"devices", "--all"}).exit_code, 2);
}

}  // namespace
}  // namespace vallecula::gui::test
