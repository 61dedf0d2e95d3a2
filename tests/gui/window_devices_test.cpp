// The page that lists what is plugged in: what it shows, how it follows, and what is chosen on it.
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <thread>

#include "gui/pages/device_dialog.h"
#include "gui/pages/devices_page.h"
#include "gui/pages/main_window.h"
#include "gui/session/user_paths.h"
#include "tests/gui/program.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

using device::FoundDevice;

FoundDevice mouse() {
  FoundDevice one;
  one.name = "mouse";
  one.info.kind = "mouse";
  one.info.model = "mouse and keyboard";
  return one;
}

FoundDevice spacemouse(const std::string& serial) {
  FoundDevice one;
  one.name = "spacemouse:" + serial;
  one.info.kind = "spacemouse";
  one.info.model = "SpaceMouse Compact";
  one.info.serial = serial;
  one.info.driver = "hidapi";
  one.info.rate_hz = 125.0;
  one.info.workspace_m = {0.4, 0.4, 0.4};
  return one;
}

FoundDevice touch_not_calibrated() {
  FoundDevice one;
  one.name = "touch";
  one.info.kind = "touch";
  one.info.model = "Touch X";
  one.info.driver = "libHD.so";
  one.info.peak_force_n = 7.9;
  one.info.continuous_force_n = 1.75;
  one.info.workspace_m = {0.16, 0.12, 0.12};
  one.calibration = device::Calibration::needs_hand;
  return one;
}

FoundDevice falcon_not_permitted() {
  FoundDevice one;
  one.info.kind = "falcon";
  one.info.model = "Falcon";
  one.info.driver = "libusb";
  one.info.peak_force_n = 8.0;
  one.problem = "this user may not open it";
  one.mend = "copy packaging/60-vallecula.rules to /etc/udev/rules.d";
  return one;
}

/// A list that a test changes while the page asks for it.
class Bus {
 public:
  void set(std::vector<FoundDevice> devices) {
    const std::lock_guard<std::mutex> guard(lock_);
    devices_ = std::move(devices);
  }
  DevicesPage::Finder finder() {
    return [this] {
      const std::lock_guard<std::mutex> guard(lock_);
      ++asked_;
      if (std::this_thread::get_id() == window_) ++asked_by_window_;
      return devices_;
    };
  }
  int asked() const { return asked_; }
  int asked_by_window() const { return asked_by_window_; }

 private:
  std::mutex lock_;
  std::vector<FoundDevice> devices_;
  const std::thread::id window_ = std::this_thread::get_id();
  std::atomic<int> asked_{0}, asked_by_window_{0};
};

QPushButton* button(QWidget& page, const QString& text) {
  for (auto* one : page.findChildren<QPushButton*>())
    if (one->text() == text) return one;
  return nullptr;
}

std::string told(QWidget& page) {
  QString all;
  for (const auto* label : page.findChildren<QLabel*>()) all += label->text() + "\n";
  return all.toStdString();
}

class WindowDevices : public Screen {
 protected:
  WindowDevices() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  test::Sandbox box_;
};

TEST_F(WindowDevices, TheListFollowsWhatIsPluggedInAndKeepsTheChoice) {
  Bus bus;
  bus.set({mouse(), touch_not_calibrated(), falcon_not_permitted()});
  DevicesPage page(nullptr, bus.finder());
  page.resize(1280, 800);
  EXPECT_EQ(bus.asked(), 0) << "not asked while nobody looks";
  page.show();
  auto* table = page.findChild<QTableWidget*>();
  ASSERT_TRUE(wait_for([&] { return table->rowCount() == 3; }));
  auto* use = button(page, "Use this one");
  EXPECT_FALSE(use->isEnabled());
  table->selectRow(1);
  EXPECT_TRUE(use->isEnabled());
  EXPECT_NE(told(page).find("ink well"), std::string::npos) << told(page);
  keep_picture(page, "devices.png");
  EXPECT_EQ(table->item(0, table->columnCount() - 1)->text(), "nothing: ready");
  EXPECT_TRUE(table->item(2, table->columnCount() - 1)->text().startsWith("this user may not open it; copy "));
  table->selectRow(2);
  EXPECT_FALSE(use->isEnabled());
  EXPECT_NE(told(page).find("60-vallecula.rules"), std::string::npos) << told(page);

  bus.set({mouse(), spacemouse("A17"), touch_not_calibrated(), falcon_not_permitted()});
  ASSERT_TRUE(wait_for([&] { return table->rowCount() == 4; })) << "by itself, within a second or so";
  EXPECT_EQ(table->currentRow(), 3) << "the chosen one moved down and is still chosen";
  EXPECT_EQ(table->item(1, 1)->text(), "SpaceMouse Compact (A17)");
  bus.set({mouse()});
  ASSERT_TRUE(wait_for([&] { return table->rowCount() == 1; }));
  EXPECT_FALSE(use->isEnabled()) << "what was chosen is gone";
  EXPECT_EQ(bus.asked_by_window(), 0) << "asking may take a second: the window does not wait for it";
  page.hide();
  const int asked = bus.asked();
  wait_for([] { return false; }, 1500);
  EXPECT_EQ(bus.asked(), asked);
}

/// A Falcon that may still run the firmware another program gave it works, or says at its start what it lacks.
TEST_F(WindowDevices, OneThatLacksSomethingCanBeUsedAndSaysSo) {
  FoundDevice falcon = falcon_not_permitted();
  falcon.name = "falcon";
  falcon.problem = "no firmware file was found";
  falcon.mend = "name one";
  DevicesPage page(nullptr, [falcon] { return std::vector<FoundDevice>{falcon}; });
  page.show();
  auto* table = page.findChild<QTableWidget*>();
  ASSERT_TRUE(wait_for([&] { return table->rowCount() == 1; }));
  table->selectRow(0);
  EXPECT_TRUE(button(page, "Use this one")->isEnabled());
  EXPECT_NE(told(page).find("no firmware file was found; name one"), std::string::npos) << told(page);
}

TEST_F(WindowDevices, ClosedWhileItAsksItWaitsForTheAnswerAndIsGone) {
  std::atomic<bool> asking{false}, answered{false};
  {
    DevicesPage page(nullptr, [&] {
      asking = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      answered = true;
      return std::vector<FoundDevice>{mouse()};
    });
    page.show();
    ASSERT_TRUE(wait_for([&] { return asking.load(); }));
  }
  EXPECT_TRUE(answered);
}

TEST_F(WindowDevices, AFailureToListIsSaid) {
  DevicesPage page(nullptr, []() -> std::vector<FoundDevice> { throw std::runtime_error("the bus is closed"); });
  page.show();
  EXPECT_TRUE(wait_for([&] { return told(page).find("the bus is closed") != std::string::npos; }));
}

TEST_F(WindowDevices, TheChosenOneIsPractisedWithAndRemembered) {
  const auto device_of = [](MainWindow& window) { return window.start_page().choice().device.toStdString(); };
  const auto curriculum = curricula::load_curriculum(default_curriculum());
  {
    MainWindow window;
    window.show_start({curriculum});
    window.show();
    EXPECT_EQ(device_of(window), "mouse");
    open_course_page(window);
    button(window.start_page(), "Devices ...")->click();
    EXPECT_EQ(window.page_name(), "devices");
    keep_picture(window, "devices-window.png");
    button(window.devices_page(), "Back")->click();
    EXPECT_EQ(window.page_name(), "start");
    EXPECT_EQ(button(window.devices_page(), "Back")->shortcut(), QKeySequence(Qt::Key_Escape));
    button(window.start_page(), "Devices ...")->click();
    emit window.devices_page().chosen(spacemouse("A17"));
    EXPECT_EQ(window.page_name(), "start");
    EXPECT_EQ(device_of(window), "spacemouse:A17");
    keep_picture(window, "devices-start.png");
  }
  MainWindow window;
  window.show_start({curriculum});
  EXPECT_EQ(device_of(window), "spacemouse:A17") << "though it is not plugged in now: a trial will say so";
  emit window.devices_page().found({mouse(), spacemouse("A17"), spacemouse("B18"), falcon_not_permitted()});
  const auto* combo = window.start_page().findChild<QComboBox*>("device");
  const auto offered = [combo] {
    std::vector<std::string> texts;
    for (int i = 0; i < combo->count(); ++i) texts.push_back(combo->itemText(i).toStdString());
    return texts;
  };
  const auto has = [&](const std::string& text) {
    const auto all = offered();
    return std::find(all.begin(), all.end(), text) != all.end();
  };
  EXPECT_EQ(combo->currentText(), "SpaceMouse Compact (A17)") << "found, it is told by its model";
  EXPECT_TRUE(has("SpaceMouse Compact (B18)"));
  EXPECT_FALSE(has("Falcon")) << "what cannot be used is not offered";
  emit window.devices_page().found({mouse()});
  EXPECT_FALSE(has("SpaceMouse Compact (B18)"));
  EXPECT_TRUE(has("SpaceMouse Compact (A17)")) << "the chosen one stays";
  EXPECT_EQ(device_of(window), "spacemouse:A17");
}

/// Settings are those of the device as the list told it: nothing is asked on the window's thread.
TEST_F(WindowDevices, SettingsAreOfTheLastListAndOfTheMouseBeforeAny) {
  StartPage page;
  const auto heading_of_dialog = [&] {
    QString heading;
    QTimer::singleShot(0, [&] {
      auto* dialog = qobject_cast<DeviceDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      heading = dialog->findChild<QLabel*>("heading")->text();
      dialog->reject();
    });
    button(page, "Device settings ...")->click();
    QApplication::processEvents();
    return heading.toStdString();
  };
  EXPECT_EQ(heading_of_dialog(), "Mouse and keyboard");
  page.choose_device("pen:7", "Pen (used last)");
  EXPECT_EQ(heading_of_dialog(), "");
  EXPECT_NE(told(page).find("was not found"), std::string::npos) << told(page);
  FoundDevice pen;
  pen.name = "pen:7";
  pen.info.kind = "pen";
  pen.info.model = "Pen 2000";
  pen.info.own_axes = true;
  page.set_found_devices({mouse(), pen});
  EXPECT_EQ(heading_of_dialog(), "Pen 2000");
  EXPECT_EQ(told(page).find("was not found"), std::string::npos) << told(page);
}

}  // namespace
}  // namespace vallecula::gui::window_test
