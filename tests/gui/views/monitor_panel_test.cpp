// The bedside monitor: what it says and shows, judged on its picture.
#include "gui/views/monitor_panel.h"

#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

engine::Snapshot infant(double time_s, double spo2, double heart, int breaths = 0) {
  engine::Snapshot snapshot;
  snapshot.step = static_cast<std::int64_t>(1000.0 * time_s);
  snapshot.time_s = time_s;
  snapshot.has_intubation = true;
  snapshot.intubation.spo2 = spo2;
  snapshot.intubation.heart_per_min = heart;
  snapshot.intubation.breaths_given = breaths;
  return snapshot;
}

bool is_alarm_red(QRgb c, int, int) { return qRed(c) > 200 && qGreen(c) < 100 && qBlue(c) < 90; }

class Monitor : public Screen {};

TEST(Alarms, BeginWhereOneActsAndTheGravestComesFirst) {
  const auto of = [](double spo2, double heart) { return alarms_of(infant(1.0, spo2, heart).intubation).join("|"); };
  EXPECT_EQ(of(0.80, 100.0).toStdString(), "");
  EXPECT_EQ(of(0.79, 100.0).toStdString(), "SpO2 BELOW 80 %");
  EXPECT_EQ(of(0.80, 99.9).toStdString(), "HEART RATE BELOW 100: VENTILATE");
  EXPECT_EQ(of(0.60, 60.0).toStdString(), "HEART RATE BELOW 100: VENTILATE|SpO2 BELOW 80 %");
  EXPECT_EQ(of(0.60, 59.0).toStdString(), "HEART RATE BELOW 60: COMPRESSIONS|SpO2 BELOW 80 %");
}

TEST_F(Monitor, CountsFromTheLastBreathAndBeginsAnewWithTheTrial) {
  MonitorPanel panel;
  panel.show_snapshot(infant(0.0, 0.97, 150.0));
  panel.show_snapshot(infant(12.0, 0.93, 150.0));
  EXPECT_DOUBLE_EQ(panel.since_breath_s(), 12.0) << "none was given yet";
  panel.show_snapshot(infant(13.0, 0.92, 148.0, 1));
  EXPECT_DOUBLE_EQ(panel.since_breath_s(), 0.0);
  panel.show_snapshot(infant(16.5, 0.95, 150.0, 1));
  EXPECT_DOUBLE_EQ(panel.since_breath_s(), 3.5);
  engine::Snapshot held = infant(16.6, 0.95, 150.0, 1);
  held.faults = engine::kFaultDeviceInvalid;
  panel.show_snapshot(held);
  held.time_s = 60.0;
  panel.show_snapshot(held);
  EXPECT_DOUBLE_EQ(panel.since_breath_s(), 3.5) << "in a pause the infant's time stands";
  panel.show_snapshot(infant(61.0, 0.95, 150.0, 1));
  EXPECT_DOUBLE_EQ(panel.since_breath_s(), 4.5);
  panel.show_snapshot(infant(0.5, 0.97, 150.0));  // reset: the clock is back at the start
  EXPECT_DOUBLE_EQ(panel.since_breath_s(), 0.5);
  engine::Snapshot laryngoscopy_alone;
  laryngoscopy_alone.step = 4000;
  laryngoscopy_alone.time_s = 4.0;
  panel.show_snapshot(laryngoscopy_alone);
  EXPECT_DOUBLE_EQ(panel.since_breath_s(), 0.5) << "no infant in it, nothing to show";
}

TEST_F(Monitor, ShowsAlarmsInRedAndTheDetectorInItsColours) {
  MonitorPanel panel;
  panel.resize(790, 118);
  const auto run = [&](double from, double to, double heart_from, double heart_to, bool yellow, const char* name) {
    panel.clear();
    for (int i = 0; i <= 240; ++i) {
      const double t = i / 240.0;
      engine::Snapshot now =
          infant(60.0 * t, from + t * (to - from), heart_from + t * (heart_to - heart_from), i / 120);
      now.intubation.detector_yellow = yellow;
      now.intubation.given_per_min = yellow ? 42.0 : 0.0;
      panel.show_snapshot(now);
    }
    keep_picture(panel, name);
    return panel.grab().toImage();
  };
  const auto yellow = [](QRgb c, int x, int) { return x > 600 && qRed(c) > 220 && qGreen(c) > 190 && qBlue(c) < 100; };
  const auto purple = [](QRgb c, int x, int) { return x > 600 && qBlue(c) > 140 && qRed(c) > 100 && qGreen(c) < 90; };
  const QImage normal = run(0.97, 0.96, 152.0, 150.0, true, "monitor-normal.png");
  EXPECT_EQ(find_pixels(normal, is_alarm_red).pixels, 0);
  EXPECT_GT(find_pixels(normal, yellow).pixels, 2000);
  EXPECT_EQ(find_pixels(normal, purple).pixels, 0);
  const QImage low = run(0.97, 0.71, 152.0, 118.0, false, "monitor-desaturated.png");
  const Spot red = find_pixels(low, is_alarm_red);
  EXPECT_GT(red.pixels, 3000);
  EXPECT_LT(red.x, 200.0) << "the saturation's field, not the heart's";
  EXPECT_GT(find_pixels(low, purple).pixels, 2000);
  EXPECT_EQ(find_pixels(low, yellow).pixels, 0);
  const QImage slow = run(0.90, 0.45, 150.0, 52.0, false, "monitor-bradycardia.png");
  EXPECT_GT(find_pixels(slow, is_alarm_red).pixels, 1.7 * red.pixels) << "both fields";
  // The trend is the last minute's: a line that falls from left to right.
  const auto cyan = [](bool left) {
    return [left](QRgb c, int x, int y) {
      return y < 90 && x > 150 && x < 280 && (x < 215) == left && qBlue(c) > 180 && qGreen(c) > 150 && qRed(c) < 130;
    };
  };
  const Spot begins = find_pixels(slow, cyan(true)), ends = find_pixels(slow, cyan(false));
  ASSERT_GT(begins.pixels, 30);
  ASSERT_GT(ends.pixels, 30);
  EXPECT_GT(ends.y, begins.y + 15);
}

}  // namespace
}  // namespace vallecula::gui::window_test
