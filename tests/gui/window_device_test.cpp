// The device in the window: its pauses, its explanation, its settings.
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gui/pages/device_dialog.h"
#include "gui/pages/main_window.h"
#include "gui/pages/mouse_introduction.h"
#include "gui/pages/trial_page.h"
#include "gui/session/user_settings.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

class WindowDeviceRealTime : public Screen {
 protected:
  WindowDeviceRealTime() { ::setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  TrialSetup with(const std::string& device) {
    TrialSetup setup;
    setup.patient = test::write_block_patient(box_.folder());
    setup.curriculum = test::write_curriculum(box_.folder());
    setup.scenario = "plain";
    setup.device = device;
    setup.out = box_ / "out";
    return setup;
  }
  test::Sandbox box_;
};

TEST_F(WindowDeviceRealTime, AFaultOfTheDeviceIsToldAndEnterTakesHoldAgain) {
  MainWindow window;
  window.show();
  const std::string down = ",0,0.70710678118654752,-0.70710678118654752,0\n";
  test::write_text(box_ / "fails.csv", "# fault communication_lost 0.4 0.4\n0,0,0.005,0.006" + down +
                                           "0.3,0,0.005,0.006" + down + "0.7,0,0.005,0.03" + down + "30,0,0.005,0.03" +
                                           down);
  const TrialSetup setup = with("scripted:" + (box_ / "fails.csv").string());
  const auto shown = [&](const QString& words) {
    const auto labels = window.trial_page().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* label) { return label->text().contains(words); });
  };
  int finished = 0;
  QObject::connect(&window, &MainWindow::trial_finished, [&](const TrialOutcome&) { ++finished; });
  window.prepare(setup, true);
  EXPECT_TRUE(wait_for([&] { return shown("Paused. The device does not answer"); }));
  keep_picture(window, "pause-fault.png");
  ASSERT_TRUE(wait_for([&] { return shown("Paused. The device is back."); }));
  keep_picture(window, "pause-confirm.png");
  QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
  QApplication::sendEvent(&window.trial_page(), &enter);
  EXPECT_TRUE(wait_for([&] { return !shown("Paused."); }));
  window.trial_page().end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished > 0; }));
}

TEST_F(WindowDeviceRealTime, TheMouseIsExplainedUntilItIsKnown) {
  for (const bool said_before : {false, true}) {
    MainWindow window;
    window.show();
    bool ready = false;
    QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
    window.prepare(with("mouse"), false);
    ASSERT_TRUE(wait_for([&] { return ready; }));
    auto* introduction = window.trial_page().findChild<MouseIntroduction*>();
    ASSERT_NE(introduction, nullptr);
    EXPECT_EQ(introduction->isVisible(), !said_before);
    wait_for([] { return false; }, 500);
    keep_picture(window, said_before ? "introduced.png" : "introduction.png");
    if (said_before) break;
    introduction->findChild<QCheckBox*>()->setChecked(true);
    QKeyEvent plus(QEvent::KeyPress, Qt::Key_Plus, Qt::NoModifier);
    QApplication::sendEvent(&window.trial_page(), &plus);
    EXPECT_FALSE(introduction->isVisible()) << "any key sends it away";
    EXPECT_DOUBLE_EQ(mouse_gain(), 1.25) << "and does its own work, which is kept";
  }
}

TEST_F(WindowDeviceRealTime, EnterClosesTheIntroductionBeforeItStartsATrial) {
  MainWindow window;
  window.show();
  bool ready = false;
  QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
  window.prepare(with("mouse"), false);
  ASSERT_TRUE(wait_for([&] { return ready; }));
  auto* introduction = window.trial_page().findChild<MouseIntroduction*>();
  ASSERT_NE(introduction, nullptr);
  ASSERT_TRUE(introduction->isVisible());
  QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
  QApplication::sendEvent(&window.trial_page(), &enter);
  EXPECT_FALSE(introduction->isVisible());
  EXPECT_FALSE(window.trial_page().running()) << "the first Enter only closes it";
  QApplication::sendEvent(&window.trial_page(), &enter);
  EXPECT_TRUE(window.trial_page().running());
  // Its log goes to the disk first: a trial that is ended before its first tick has nothing to be finished.
  bool ticked = false;
  QObject::connect(&window.trial_page(), &TrialPage::frame, &window,
                   [&](const engine::Snapshot& shown) { ticked = ticked || shown.ticks > 0; });
  ASSERT_TRUE(wait_for([&] { return ticked; }));
  int finished = 0;
  QObject::connect(&window, &MainWindow::trial_finished, [&](const TrialOutcome&) { ++finished; });
  window.trial_page().end("ended by trainee");
  ASSERT_TRUE(wait_for([&] { return finished > 0; }));
}

TEST_F(WindowDeviceRealTime, DeviceSettingsAreShownAndKept) {
  device::DeviceInfo mouse;
  mouse.kind = "mouse";
  mouse.model = "mouse and keyboard";
  {
    DeviceDialog dialog(mouse);
    keep_picture(dialog, "settings-mouse.png");
    dialog.findChild<QDoubleSpinBox*>("gain")->setValue(2.0);
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  }
  EXPECT_EQ(mouse_gain(), 2.0);
  device::DeviceInfo pen;
  pen.kind = "pen";
  pen.model = "Pen 2000";
  pen.serial = "7";
  pen.own_axes = true;
  pen.peak_force_n = 3.3;
  {
    DeviceDialog dialog(pen);
    dialog.findChild<QDoubleSpinBox*>("motion_scale")->setValue(1.5);
    dialog.findChild<QDoubleSpinBox*>("turned")->setValue(30.0);
    dialog.findChild<QCheckBox*>("left_handed")->setChecked(true);
    dialog.findChild<QSpinBox*>("clutch_button")->setValue(3);
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  }
  const DeviceSettings kept = device_settings(pen);
  EXPECT_EQ(kept.map.motion_scale, 1.5);
  EXPECT_NEAR(kept.map.turned_rad, M_PI / 6.0, 1e-12);
  EXPECT_TRUE(kept.map.left_handed);
  EXPECT_EQ(kept.clutch_button, 4u);
  {
    DeviceDialog dialog(pen);
    keep_picture(dialog, "settings-device.png");
    EXPECT_EQ(dialog.findChild<QSpinBox*>("clutch_button")->value(), 3) << "shown again as it was kept";
    dialog.findChild<QDoubleSpinBox*>("motion_scale")->setValue(2.5);
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
  }
  EXPECT_EQ(device_settings(pen).map.motion_scale, 1.5);
  for (const double asked : {0.01, 0.19, 0.2, 0.5}) {
    DeviceDialog dialog(pen);
    auto* force = dialog.findChild<QDoubleSpinBox*>("force_scale");
    force->setValue(asked);
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    EXPECT_EQ(device_settings(pen).force_scale, std::max(asked, kLeastForceScale)) << "less than asked for is not more";
  }
  {
    DeviceDialog dialog(pen);
    dialog.findChild<QDoubleSpinBox*>("force_scale")->setValue(0.0);
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    EXPECT_EQ(device_settings(pen).force_scale, 0.0) << "as the device can";
  }
  device::DeviceInfo script;
  script.kind = "scripted";
  EXPECT_FALSE(DeviceDialog::has_settings(script));
}

}  // namespace
}  // namespace vallecula::gui::window_test
