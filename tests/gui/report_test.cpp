// The chart shows every peak where it belongs; the report holds everything and needs nothing else.
#include "gui/report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "gui/commands/headless_application.h"
#include "gui/commands/score_table.h"
#include "gui/report/force_chart.h"
#include "gui/report/monitor_chart.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTicks = 30000;

curricula::Scenario plain_scenario() {
  curricula::Scenario scenario;
  scenario.id = "plain";
  scenario.title = "A <b>bold</b> & plain case";
  scenario.debriefing = "Lift, \"do not\" lever.";
  scenario.pass = {6.8, 3.0, 50.0, 30.0, 3.0, 0.2};
  return scenario;
}

/// Half a minute in which the tongue gives `tongue_n` for `ticks` ticks from 10 s on.
curricula::TrialLog spike_log(double tongue_n, std::size_t ticks) {
  curricula::TrialLog log;
  log.header.package_name = "block";
  log.header.device_kind = "scripted";
  log.header.device_limit_n = 7.9;
  log.footer.complete = true;
  log.footer.ended = "finished";
  log.ticks.resize(kTicks);
  for (std::size_t i = 0; i < kTicks; ++i) {
    log.ticks[i].tick = static_cast<std::int64_t>(i);
    log.ticks[i].time_s = 0.001 * static_cast<double>(i);
    if (i >= 10000 && i < 10000 + ticks) log.ticks[i].loads[curricula::kTongue].force_n = {0.0, 0.0, tongue_n};
  }
  return log;
}

/// Rows of the picture that hold the tongue's green (009E73, drawn over white), topmost first.
std::pair<int, int> tongue_rows(const QImage& image, int from_row) {
  int top = -1, bottom = -1;
  for (int y = from_row; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor colour = image.pixelColor(x, y);
      if (std::abs(colour.red()) > 25 || std::abs(colour.green() - 0x9E) > 25 || std::abs(colour.blue() - 0x73) > 25)
        continue;
      if (top < 0) top = y;
      bottom = y;
      break;
    }
  }
  return {top, bottom};
}

TEST(ForceChart, OneTickOfForceIsNotLostAndItsHeightIsItsForce) {
  const HeadlessApplication application;
  const curricula::Scenario scenario = plain_scenario();
  const curricula::Score no_marks;  // no peaks, no sight: only the line itself is green
  const int below_legend = 90;
  std::vector<double> heights;
  for (const double force_n : {2.0, 4.0, 6.0}) {
    const QImage image = draw_force_chart(spike_log(force_n, 1), scenario, no_marks, 1600, 900);
    ASSERT_EQ(image.size(), QSize(1600, 900));
    const auto [top, bottom] = tongue_rows(image, below_legend);
    ASSERT_GE(top, 0);
    heights.push_back(bottom - top);
  }
  // The axis is the same (the device limit is the highest), so equal steps of force are equal steps of height; the line
  // is three pixels thick and its tip is rounded by smoothing.
  EXPECT_GT(heights[0], 50.0);
  EXPECT_NEAR(heights[1] - heights[0], heights[2] - heights[1], 6.0);
  EXPECT_NEAR(heights[2] - heights[0], 2.0 * heights[0], 12.0);
}

TEST(ForceChart, HasEveryLineThatTheTrialWasJudgedByAsTheBarsHaveIt) {
  const HeadlessApplication application;
  curricula::Scenario scenario = plain_scenario();
  scenario.targets = {5.0, 2.0};
  curricula::TrialLog log = spike_log(0.0, 1);  // nothing done, so nothing else is drawn at these heights
  const QImage with = draw_force_chart(log, scenario, {}, 1600, 900);
  // A level is a line across the panel, broken or not: the columns of one row that have its colour.
  const auto longest = [&](const QColor& colour) {
    int most = 0;
    for (int y = 0; y < with.height(); ++y) {
      int columns = 0;
      for (int x = 0; x < with.width(); ++x) {
        const QColor c = with.pixelColor(x, y);
        columns += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                       std::abs(c.blue() - colour.blue()) <
                   60;
      }
      most = std::max(most, columns);
    }
    return most;
  };
  // Of the window's light ground (gui/views/theme): what the bars are drawn with there.
  EXPECT_GT(longest(QColor(176, 66, 0)), 1200) << "the pass limit, unbroken";
  EXPECT_GT(longest(QColor(122, 104, 0)), 500) << "the target";
  EXPECT_GT(longest(QColor(0, 104, 158)), 500) << "the device limit";
  const Chart chart = make_force_chart(picture_form(1600, 900), log, scenario, {});
  for (const char* words : {"pass limit, tongue 6.8 N", "pass limit, gum 3.0 N", "target, tongue 5.0 N",
                            "target, gum 2.0 N", "device limit 7.9 N"})
    EXPECT_TRUE(std::any_of(chart.labels.begin(), chart.labels.end(), [&](const ChartLabel& label) {
      return label.whole == words;
    })) << words;
}

TEST(ForceChart, ADeviceThatShowsNoForceIsNotSaidToHaveShownOne) {
  const HeadlessApplication application;
  curricula::LogHeader header;
  const auto says_none = [&] { return displayed_words(header).contains("shows none"); };
  header.device_kind = "touch";
  EXPECT_FALSE(says_none());
  header.device_kind = "mouse+touch";  // the blade's hand is the first
  EXPECT_TRUE(says_none());
  header.device_kind = "spacemouse";
  EXPECT_TRUE(says_none());
  header.settings["device_peak_force_n"] = 3.3;  // where the log has it, that is so
  EXPECT_FALSE(says_none());
  header.device_kind = "newer than this test";
  header.settings["device_peak_force_n"] = 0.0;
  EXPECT_TRUE(says_none());
}

TEST(ForceChart, NoForceIsDrawnInAPause) {
  const HeadlessApplication application;
  curricula::TrialLog log = spike_log(4.0, 500);
  for (std::size_t i = 9900; i < 10600; ++i) log.ticks[i].device_valid = false;  // a line's width to either side
  curricula::Score score;
  const auto height = [&] {
    const auto [top, bottom] = tongue_rows(draw_force_chart(log, plain_scenario(), score, 1600, 900), 90);
    return bottom - top;
  };
  EXPECT_GT(height(), 100);
  score.pauses = {{9.9, 0.7, "communication_lost"}};
  EXPECT_LT(height(), 10) << "the base line alone";
}

TEST(Report, PausesAreToldWhereverAPersonReads) {
  const HeadlessApplication application;
  const Sandbox box;
  const curricula::TrialLog log = spike_log(4.0, 500);
  curricula::Score score;
  write_force_chart(box / "force.png", log, plain_scenario(), score);
  write_report(box.folder(), log, plain_scenario(), score);
  EXPECT_EQ(text_of(box / "report.html").find("Paused"), std::string::npos) << "there was none";
  score.paused_s = 7.5;
  score.pauses = {{10.0, 2.5, "communication_lost"}, {20.0, 3.0, ""}, {25.0, 2.0, "communication_lost"}};
  write_report(box.folder(), log, plain_scenario(), score);
  const std::string words = "3 times (communication lost, reason not recorded)";
  EXPECT_NE(text_of(box / "report.html").find("7.5 s</td><td>" + words), std::string::npos);
  std::ostringstream table;
  print_score(table, score, plain_scenario());
  EXPECT_NE(table.str().find("7.50 s, " + words), std::string::npos) << table.str();
  score.pauses.resize(1);
  EXPECT_EQ(pauses_in_words(score), "1 time (communication lost)");
}

/// A minute: blade in from 5 to 20 s and from 35 to 50 s, saturation 95 % and from 20 to 30 s 60 %, the tip in the
/// oesophagus from 12 to 18 s and past the cords from 42 s on, breaths every second from 22 to 34 s and from 51 s on.
curricula::TrialLog intubation_log() {
  curricula::TrialLog log = spike_log(3.0, 500);
  log.header.has_intubation = true;
  log.header.settings[curricula::kCordsToCarina] = 0.048;
  log.header.landmarks_m = {{"upper_gum_midline", {0, 0, 0}},
                            {"lower_gum_midline", {0, 0.0032, -0.0208}},
                            {"vallecula", {0, 0.0285, -0.0415}}};
  log.ticks.resize(60000);
  for (std::size_t n = 0; n < log.ticks.size(); ++n) {
    curricula::LogTick& t = log.ticks[n];
    t.tick = t.step_used = static_cast<std::int64_t>(n);
    t.time_s = 0.001 * static_cast<double>(n);
    const auto in = [n](std::size_t from_s, std::size_t to_s) { return n >= 1000 * from_s && n < 1000 * to_s; };
    t.proxy_pose.position_m = {0.0, in(5, 20) || in(35, 50) ? 0.02 : -0.1, -0.02};
    t.has_sight = n % 20 == 0;
    t.glottis_visible = in(8, 20) || in(38, 50) ? 0.7 : 0.0;
    t.has_intubation = true;
    curricula::LogIntubation& i = t.intubation;
    i.place = in(12, 18)   ? curricula::LoggedPlace::oesophagus
              : in(42, 61) ? curricula::LoggedPlace::trachea
                           : curricula::LoggedPlace::outside;
    i.past_cords_m = in(42, 61) ? 0.024 : 0.0;
    i.spo2 = in(20, 30) ? 0.60 : 0.95;
    i.sao2 = in(12, 22) ? 0.55 : 0.96;
    i.heart_per_min = in(18, 26) ? 90.0 : 150.0;
    i.breaths_given = static_cast<std::int32_t>(n < 22000 ? 0 : std::min<std::size_t>(12, (n - 21000) / 1000));
    if (n >= 51000) i.breaths_given += static_cast<std::int32_t>((n - 50000) / 1000);
    i.detector_yellow = in(53, 61);
    if (n == 42500)
      i.tip_load_n = 1.25, i.tip_against = curricula::kTubeCricoid, i.loads_n[curricula::kTubeCricoid] = 2.5;
  }
  return log;
}

curricula::Scenario intubation_scenario() {
  curricula::Scenario scenario = plain_scenario();
  scenario.pass.peak_tongue_force_n = 6.8;
  scenario.max_attempt_s = 120;
  curricula::IntubationSpec& spec = scenario.intubation.emplace();
  spec.pass.lowest_spo2_percent = 70;
  spec.pass.attempts = 2;
  spec.pass.co2_confirmed = true;
  return scenario;
}

TEST(Report, TellsOfAnIntubationWhereverAPersonReads) {
  const HeadlessApplication application;
  const Sandbox box;
  const curricula::TrialLog log = intubation_log();
  const curricula::Scenario scenario = intubation_scenario();
  const curricula::Score score = curricula::score_trial(log, scenario);
  const std::string sentence = summary_sentence(score, scenario);
  EXPECT_NE(sentence.find("The tube's tip lies 24.0 mm past the cords, 50 % of the way to the carina: good depth. "
                          "2 attempts, the longest of 15.0 s, lowest saturation 60 %, lowest heart rate 90 per minute"),
            std::string::npos)
      << sentence;
  write_force_chart(box / "force.png", log, scenario, score);
  write_report(box.folder(), log, scenario, score);
  const std::string page = text_of(box / "report.html");
  for (const char* part :
       {"<td class=\"figure\">good depth</td><td>good depth</td><td class=\"met\">",
        "24.0 mm past the cords, 50 % of 48.0 mm to the carina",
        "60 %, at 20.0 s</td><td>at least 70 %</td><td "
        "class=\"missed\">",
        "2</td><td>at most 2</td><td class=\"met\">", "yellow with breath 3", "1.25 N, at 42.5 s (cricoid)",
        "cricoid 2.5 N", "95 %, 60 %: severe desaturation", "<h2>Points: ", "<h2>Checklist</h2>",
        "Ventilated between attempts</td><td class=\"met\">yes", "Handle in the left hand</td><td class=\"\">not seen",
        "Cormack-Lehane grade at best", "0.0 mm shallower", "Global rating, by a person:", "90 per minute: bradycardia",
        "1 time, 0 breaths given there", "<h2>The monitor</h2>"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  std::size_t pictures = 0;
  for (std::size_t at = page.find("data:image/png"); at != std::string::npos; at = page.find("data:image/png", at + 1))
    ++pictures;
  EXPECT_EQ(pictures, 2u);
  std::ostringstream table;
  print_score(table, score, scenario);
  for (const char* part : {"(missed: at least 70 %)",
                           "attempt 1: 5.0 to 20.0 s, 0 breaths before, saturation from 95 % "
                           "to 60 % (severe desaturation), heart to 90 (bradycardia)",
                           "attempt 2: 35.0 to 50.0 s, 12 "
                           "breaths before",
                           "yellow with breath 3 (met: yellow by breath 6)"}) {
    EXPECT_NE(table.str().find(part), std::string::npos) << part << " in\n" << table.str();
  }
  for (const char* part : {"of 100\n", "not seen Tip in the vallecula", "(no source given; not validated)"})
    EXPECT_NE(table.str().find(part), std::string::npos) << part << " in\n" << table.str();
  for (const char* hidden : {"remor", "moothness", "SPARC"}) {
    EXPECT_EQ(page.find(hidden), std::string::npos) << hidden << " is for researchers";
    EXPECT_EQ(table.str().find(hidden), std::string::npos) << hidden << " is for researchers";
  }
  EXPECT_EQ(text_of(box / "report.html").find("http"), std::string::npos) << "self-contained";
}

/// Whether the picture's column at `time_s` is filled with this colour: lines that blend with their ground are not.
bool has_colour(const QImage& image, double time_s, double end_s, const QColor& colour) {
  const double em = 20.0;  // of a picture of 1600 x 900
  const int x = static_cast<int>(std::lround(7.0 * em + (image.width() - 8.5 * em) * time_s / end_s));
  int rows = 0;
  for (int y = 0; y < image.height(); ++y) rows += image.pixelColor(x, y) == colour;
  return rows > 100;
}

TEST(MonitorChart, ADisplayThatSaysNoFigureHasNoneInTheChartWhileTheBloodHasItsOwn) {
  const HeadlessApplication application;
  curricula::TrialLog log = intubation_log();
  const curricula::Scenario scenario = intubation_scenario();
  const auto labels = [&] {
    const Chart chart =
        make_monitor_chart(picture_form(1600, 900), log, scenario, curricula::score_trial(log, scenario));
    if (const QByteArray folder = qgetenv("VALLECULA_PICTURES"); !folder.isEmpty())
      chart.picture.save(QString::fromUtf8(folder) + "/monitor-chart-low.png");
    std::string all;
    for (const ChartLabel& label : chart.labels) all += label.whole.toStdString() + "\n";
    return all;
  };
  EXPECT_NE(labels().find("lowest 60 %"), std::string::npos) << labels();
  EXPECT_EQ(labels().find("< 30"), std::string::npos);
  for (curricula::LogTick& tick : log.ticks)
    if (tick.intubation.spo2 < 0.7) tick.intubation.spo2 = tick.intubation.sao2 = 0.04;
  EXPECT_NE(labels().find("lowest: below 30 %"), std::string::npos) << labels();
  EXPECT_NE(labels().find("the display says < 30"), std::string::npos) << labels();
  EXPECT_EQ(labels().find("4 %"), std::string::npos) << labels();
  const Sandbox box;
  const curricula::Score score = curricula::score_trial(log, scenario);
  write_force_chart(box / "force.png", log, scenario, score);
  write_report(box.folder(), log, scenario, score);
  std::ostringstream table;
  print_score(table, score, scenario);
  for (const std::string& told : {text_of(box / "report.html"), table.str()}) {
    EXPECT_NE(told.find("below 30 %"), std::string::npos);
    EXPECT_EQ(told.find(" 4 %"), std::string::npos);
  }
}

TEST(MonitorChart, ShadesAttemptsAndOesophagusAndPutsTheSaturationWhereItWas) {
  const HeadlessApplication application;
  const curricula::TrialLog log = intubation_log();
  const curricula::Scenario scenario = intubation_scenario();
  const curricula::Score score = curricula::score_trial(log, scenario);
  const QImage image = draw_monitor_chart(log, scenario, score, 1600, 900);
  const QColor attempt(0xF6, 0xF4, 0xEC), oesophagus(0xF6, 0xD5, 0xC3);
  for (const double at_s : {7.3, 10.2, 19.1, 36.3, 49.2}) EXPECT_TRUE(has_colour(image, at_s, 60.0, attempt)) << at_s;
  for (const double at_s : {3.3, 21.1, 33.2, 51.2}) EXPECT_FALSE(has_colour(image, at_s, 60.0, attempt)) << at_s;
  for (const double at_s : {12.6, 17.4}) EXPECT_TRUE(has_colour(image, at_s, 60.0, oesophagus)) << at_s;
  for (const double at_s : {11.3, 18.6, 45.3}) EXPECT_FALSE(has_colour(image, at_s, 60.0, oesophagus)) << at_s;
  // The displayed saturation's blue: 35 points of the panel's 110 lower while it was at 60 %.
  const auto blue_row = [&](double at_s) {
    const int x = static_cast<int>(std::lround(140.0 + (1600 - 170.0) * at_s / 60.0));
    for (int y = 92; y < 430; ++y) {
      const QColor c = image.pixelColor(x, y);
      if (c.red() < 25 && std::abs(c.green() - 0x72) < 25 && std::abs(c.blue() - 0xB2) < 25) return y;
    }
    return -1;
  };
  ASSERT_GT(blue_row(10.4), 0);
  const double panel = 0.45 * (900 - 4.6 * 20 - 4.2 * 20 - 2 * 1.6 * 20);
  EXPECT_NEAR(blue_row(25.4) - blue_row(10.4), panel * 35.0 / 110.0, 3.0);
  EXPECT_FALSE(draw_monitor_chart(log, scenario, score, 640, 400).isNull());
  curricula::Score laryngoscopy;
  EXPECT_THROW(draw_monitor_chart(log, scenario, laryngoscopy), std::logic_error);
}

TEST(ForceChart, DrawsAnEmptyAndATinyTrial) {
  const HeadlessApplication application;
  curricula::TrialLog log;
  EXPECT_FALSE(draw_force_chart(log, plain_scenario(), {}, 640, 400).isNull());
  log.ticks.resize(1);
  EXPECT_FALSE(draw_force_chart(log, plain_scenario(), {}, 640, 400).isNull());
}

TEST(Report, HoldsReasonsFiguresChartAndPicturesAndNothingFromOutside) {
  const HeadlessApplication application;
  const Sandbox box;
  const curricula::Scenario scenario = plain_scenario();
  const curricula::TrialLog log = spike_log(7.25, 500);
  curricula::Score score;
  score.peak_tongue_force_n = 7.25;
  score.time_of_peak_tongue_force_s = 10.0;
  score.attempt_time_s = 12.0;
  score.overruns = 123;
  score.real_time_setup = "servo: ordinary priority";
  score.reasons = {"tongue force 7.25 N over 6.80 N at 10.0 s", "glottis <never> seen"};
  score.criteria = {{"peak_tongue_force_n", "N", 7.25, 6.8, 10.0, false, ""},
                    {"peak_gum_force_n", "N", 0.0, 3.0, -1.0, true, ""}};
  write_force_chart(box / "force.png", log, scenario, score);
  write_report(box.folder(), log, scenario, score);
  std::string page = text_of(box / "report.html");
  EXPECT_NE(page.find("Not passed"), std::string::npos);
  EXPECT_NE(page.find("tongue force 7.25 N over 6.80 N at 10.0 s"), std::string::npos);
  EXPECT_NE(page.find("glottis &lt;never&gt; seen"), std::string::npos);
  EXPECT_EQ(page.find("<b>bold"), std::string::npos) << "text is escaped";
  EXPECT_NE(page.find("7.25 N, at 10.0 s</td><td>at most 6.8 N</td><td class=\"missed\">"), std::string::npos);
  EXPECT_NE(page.find("0.00 N</td><td>at most 3 N</td><td class=\"met\">"), std::string::npos);
  EXPECT_NE(page.find("training tool, not a medical device"), std::string::npos);
  EXPECT_NE(page.find("servo: ordinary priority"), std::string::npos);
  EXPECT_NE(page.find("largest single tick"), std::string::npos) << "what a peak is";
  EXPECT_EQ(page.find("http"), std::string::npos) << "self-contained";
  std::ostringstream table;
  print_score(table, score, scenario);
  EXPECT_NE(table.str().find("simulation steps dropped                123 ("), std::string::npos) << table.str();
  EXPECT_NE(table.str().find("real-time set-up: servo: ordinary priority"), std::string::npos) << table.str();
  // An attempt that never began has no time that could be short enough.
  EXPECT_NE(page.find("no attempt</td><td>the blade did not enter the mouth; at most 30 s</td>"), std::string::npos);
  EXPECT_NE(table.str().find("attempt time                     no attempt\n"), std::string::npos) << table.str();
  EXPECT_EQ(page.find("operator-"), std::string::npos);

  const std::string marker = "data:image/png;base64,";
  const std::size_t begin = page.find(marker) + marker.size();
  const QByteArray chart =
      QByteArray::fromBase64(QByteArray::fromStdString(page.substr(begin, page.find('"', begin) - begin)));
  EXPECT_EQ(chart.toStdString(), text_of(box / "force.png"));

  write_text(box / "operator-1-sight.png", "picture");
  write_text(box / "sagittal-1-sight.png", "picture");
  write_text(box / "else.png", "picture");
  write_report(box.folder(), log, scenario, score);
  page = text_of(box / "report.html");
  EXPECT_NE(page.find("src=\"operator-1-sight.png\""), std::string::npos);
  EXPECT_NE(page.find("src=\"sagittal-1-sight.png\""), std::string::npos);
  EXPECT_EQ(page.find("else.png"), std::string::npos);
}

}  // namespace
}  // namespace vallecula::gui::test
