// The bedside monitor: what it says and shows, judged on its picture.
#include "gui/views/monitor_panel.h"

#include <cmath>
#include <map>

#include "gui/session/languages.h"
#include "gui/views/theme.h"
#include "tests/gui/painted_words.h"
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

TEST_F(Monitor, SaysNoFigureOfASaturationThatNoOximeterIsBelievedOf) {
  const auto told = [](double spo2) { return spo2_digits(spo2).toStdString(); };
  EXPECT_EQ(told(0.87), "87");
  EXPECT_EQ(told(0.295), "30") << "as it is rounded";
  EXPECT_EQ(told(0.294), "< 30");
  EXPECT_EQ(told(0.0), "< 30");
  MonitorPanel panel;
  for (const int width : {480, 790, 1200}) {
    panel.resize(width, 118);
    panel.clear();
    panel.show_snapshot(infant(1.0, 0.04, 55.0));
    keep_picture(panel, "monitor-untold-" + std::to_string(width) + ".png");
    EXPECT_TRUE(panel.accessibleDescription().contains("saturation < 30 %"))
        << panel.accessibleDescription().toStdString();
  }
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

QStringList said_by(MonitorPanel& panel) {
  QStringList said;
  for (const PaintedWord& word : painted_words(panel)) said << word.text;
  return said;
}

bool is_orange(const QImage& picture) {
  const QColor over = theme::over();
  return find_pixels(picture, [&](QRgb c, int x, int) {
           return x > 540 && std::abs(qRed(c) - over.red()) + std::abs(qGreen(c) - over.green()) +
                                     std::abs(qBlue(c) - over.blue()) <
                                 12;
         }).pixels > 20;
}

TEST_F(Monitor, OfAnInfantThatBreathesByItselfItCountsNoTimeWithoutABreath) {
  MonitorPanel panel;
  panel.resize(790, 118);
  panel.set_breathes(true);
  const auto run = [&](double from_s, double to_s, double opening) {
    for (double t = from_s; t <= to_s; t += 0.25) {
      engine::Snapshot now = infant(t, 0.97, 150.0);
      // Cords that breathe stand between 0.45 and 1 (glottis.cpp); closed ones let nothing through.
      now.intubation.glottis_opening = opening > 0.0 ? opening + 0.25 * std::sin(8.0 * t) : 0.0;
      panel.show_snapshot(now);
    }
  };
  run(0.0, 153.0, 0.7);
  EXPECT_TRUE(said_by(panel).contains("by itself")) << said_by(panel).join(", ").toStdString();
  EXPECT_FALSE(said_by(panel).contains("153 s"));
  EXPECT_FALSE(is_orange(panel.grab().toImage()));
  EXPECT_TRUE(panel.accessibleDescription().contains("breathes by itself"));
  keep_picture(panel, "monitor-by-itself.png");
  // In a spasm it cannot.
  run(153.25, 163.0, 0.0);
  EXPECT_TRUE(said_by(panel).contains("Since breath") && said_by(panel).contains("10 s"))
      << said_by(panel).join(", ").toStdString();
  EXPECT_FALSE(is_orange(panel.grab().toImage()));
  run(163.25, 190.0, 0.0);
  EXPECT_TRUE(is_orange(panel.grab().toImage())) << "37 s without a breath";
  run(190.25, 191.0, 0.7);
  EXPECT_TRUE(said_by(panel).contains("by itself"));
  // One that does not breathe: as long as nobody gives a breath.
  panel.clear();
  panel.set_breathes(false);
  run(0.0, 40.0, 0.7);
  EXPECT_TRUE(said_by(panel).contains("40 s"));
  EXPECT_TRUE(is_orange(panel.grab().toImage()));
}

TEST_F(Monitor, ARateIsToldOfEnoughBreathsOnly) {
  MonitorPanel panel;
  panel.resize(790, 118);
  int breaths = 0;
  const auto breath = [&](double at_s) { panel.show_snapshot(infant(at_s, 0.97, 150.0, ++breaths)); };
  panel.show_snapshot(infant(0.0, 0.97, 150.0));
  // The first two are quickly given by anybody: 0.94 s apart, which as a rate would be 64.
  breath(4.0);
  breath(4.94);
  EXPECT_TRUE(said_by(panel).contains("2 given")) << said_by(panel).join(", ").toStdString();
  for (const double at_s : {6.44, 7.94}) breath(at_s);
  EXPECT_TRUE(said_by(panel).contains("4 given"));
  breath(9.44);
  EXPECT_NEAR(panel.given_per_min(), 60.0 * 4 / 5.44, 1e-9) << "four breaths' time in 5.44 s";
  for (const double at_s : {10.94, 12.44, 13.94, 15.44}) breath(at_s);
  EXPECT_NEAR(panel.given_per_min(), 40.0, 1e-9) << "the last five of them 1.5 s apart";
  EXPECT_TRUE(said_by(panel).contains("Given 40/min"));
  panel.show_snapshot(infant(21.44, 0.97, 150.0, breaths));
  EXPECT_NEAR(panel.given_per_min(), 10.0, 1e-9) << "6 s without one";
  panel.show_snapshot(infant(26.0, 0.97, 150.0, breaths));
  EXPECT_TRUE(said_by(panel).contains("9 given")) << "10 s without one: no rate";
  breath(27.0);
  EXPECT_TRUE(said_by(panel).contains("10 given")) << "and another series";
  MonitorPanel later;  // which has seen none of them
  later.show_snapshot(infant(28.0, 0.97, 150.0, 12));
  for (const double at_s : {29.0, 30.0, 31.0})
    later.show_snapshot(infant(at_s, 0.97, 150.0, 10 + static_cast<int>(at_s) - 26));
  EXPECT_EQ(later.given_per_min(), 0.0);
}

TEST_F(Monitor, ItsWordsFollowTheTextsSizeAndNoneIsCut) {
  const auto pixels = [](MonitorPanel& panel, const QString& text) {
    for (const PaintedWord& word : painted_words(panel))
      if (word.text == text) return word.pixels;
    return 0;
  };
  const char* const words[] = {"SpO2", "HR", "/min", "Since breath", "None given", "CO2 detector", "no CO2"};
  std::map<std::string, int> usual;
  for (const double scale : {1.0, 1.35}) {
    theme::apply(*qApp, {theme::Ground::dark, scale});
    MonitorPanel panel;
    panel.resize(801, panel.sizeHint().height());  // as wide as in a window of 1280
    panel.show_snapshot(infant(0.0, 0.75, 150.0));
    panel.show_snapshot(infant(12.0, 0.75, 80.0));
    for (const char* word : words) {
      const int high = pixels(panel, word);
      if (scale == 1.0)
        usual[word] = high;
      else
        EXPECT_NEAR(high, 1.35 * usual[word], 0.05 * 1.35 * usual[word] + 1.0) << word;
    }
    keep_picture(panel, scale == 1.0 ? "monitor-100.png" : "monitor-135.png");
  }
  for (const double scale : {0.8, 1.0, 1.35, 1.6})
    for (const char* language : {"en", "de"})
      for (const int wide : {480, 600, 801, 1240}) {
        theme::apply(*qApp, {theme::Ground::dark, scale});
        ASSERT_TRUE(install_language(*qApp, language));
        MonitorPanel panel;
        panel.resize(wide, wide == 480 ? panel.minimumSizeHint().height() : panel.sizeHint().height());
        panel.set_breathes(wide == 600);
        engine::Snapshot now = infant(0.0, 0.75, 150.0);
        now.intubation.glottis_opening = 0.5;
        panel.show_snapshot(now);
        now.time_s = 1.0;
        now.intubation.heart_per_min = 55.0;
        now.intubation.breaths_given = 24;
        panel.show_snapshot(now);
        const auto trouble = trouble_of(painted_words(panel), panel.size());
        std::string all;
        for (const std::string& one : trouble) all += one + "\n";
        EXPECT_TRUE(trouble.empty()) << language << " " << scale << " " << wide << "\n" << all;
      }
  install_language(*qApp, "en");
  theme::apply(*qApp, {});
}

TEST_F(Monitor, OnesOwnInfantWaitsInGreyAndSaysSo) {
  MonitorPanel panel;
  panel.resize(790, 118);
  panel.show_snapshot(infant(10.0, 0.75, 150.0));
  const QImage before = panel.grab().toImage();
  EXPECT_TRUE(said_by(panel).contains("SpO2 BELOW 80 %"));
  panel.set_waiting(true);
  EXPECT_TRUE(said_by(panel).contains("Your own infant: its time stands meanwhile"));
  EXPECT_EQ(find_pixels(panel.grab().toImage(), is_alarm_red).pixels, 0) << "an alarm of before is nobody's now";
  EXPECT_GT(find_pixels(before, is_alarm_red).pixels, 1000);
  keep_picture(panel, "monitor-waits.png");
  panel.show_snapshot(infant(10.1, 0.75, 150.0));
  EXPECT_TRUE(said_by(panel).contains("SpO2 BELOW 80 %"));
}

}  // namespace
}  // namespace vallecula::gui::window_test
