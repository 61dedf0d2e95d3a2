// Whatever stands near whatever on a trial's charts: no word lies on another, none leaves the chart, and what is cut is
// kept whole for a tooltip. The words are those the painting really puts on its device.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "gui/commands/headless_application.h"
#include "gui/report/force_chart.h"
#include "gui/report/monitor_chart.h"
#include "gui/session/languages.h"
#include "tests/gui/accessible.h"
#include "tests/gui/painted_words.h"

namespace vallecula::gui::window_test {
namespace {

constexpr double kEndS = 40.0;

/// What the charts' words stand near: two limits close together, the first sight and a pause below their words.
struct Crowd {
  double limit_n = 7.9, target_n = 7.4, sight_s = 31.0, pause_s = 33.0, tongue_peak_s = 30.0, gum_peak_s = 31.5;
};

curricula::TrialLog crowded_log(const Crowd& crowd) {
  curricula::TrialLog log;
  log.header.device_kind = "mouse";  // of whose force more is to be said
  log.header.device_limit_n = crowd.limit_n;
  log.header.has_intubation = true;
  log.ticks.resize(400);
  for (std::size_t n = 0; n < log.ticks.size(); ++n) {
    curricula::LogTick& t = log.ticks[n];
    t.tick = static_cast<std::int64_t>(n);
    t.time_s = kEndS * static_cast<double>(n) / 399.0;
    t.has_sight = true;
    t.glottis_visible = t.time_s > crowd.sight_s ? 0.6 : 0.0;
    t.has_intubation = true;
    t.intubation.spo2 = t.intubation.sao2 = t.time_s > 20.0 ? 0.71 : 0.95;
    t.intubation.heart_per_min = t.time_s > 20.0 ? 99.0 : 150.0;
    t.intubation.detector_yellow = t.time_s > crowd.sight_s + 0.3;
  }
  return log;
}

curricula::Score crowded_score(const Crowd& crowd) {
  curricula::Score score;
  score.time_to_trachea_visible_s = 11.4;
  score.time_of_first_sight_s = crowd.sight_s;
  score.peak_tongue_force_n = crowd.limit_n;
  score.time_of_peak_tongue_force_s = crowd.tongue_peak_s;
  score.peak_gum_force_n = crowd.target_n;
  score.time_of_peak_gum_force_s = crowd.gum_peak_s;
  score.pauses = {{crowd.pause_s, 4.0, "communication_lost"}};
  curricula::IntubationScore& tube = score.intubation.emplace();
  curricula::Attempt attempt;
  attempt.start_s = 2.0;
  attempt.end_s = kEndS;
  attempt.view_at_s = crowd.sight_s;
  attempt.passed_cords_s = crowd.sight_s + 0.5;
  tube.attempts = {attempt};
  tube.lowest_spo2_percent = 71.0;
  tube.lowest_spo2_at_s = crowd.sight_s + 1.0;
  tube.lowest_heart_per_min = 99.0;
  tube.lowest_heart_at_s = crowd.sight_s + 1.0;
  return score;
}

curricula::Scenario crowded_scenario(const Crowd& crowd) {
  curricula::Scenario scenario;
  scenario.title = "Term infant, 3.2 kg, tube 3.5, with a title that is longer than a chart in a small window is wide";
  scenario.targets.tongue_force_n = crowd.target_n;
  scenario.intubation.emplace().pass.lowest_spo2_percent = 70;
  return scenario;
}

class ChartWords : public ::testing::TestWithParam<std::string> {
 protected:
  ChartWords() { EXPECT_TRUE(install_language(*QCoreApplication::instance(), QString::fromStdString(GetParam()))); }
  ~ChartWords() override { install_language(*QCoreApplication::instance(), "en"); }
  const HeadlessApplication application_;
};

TEST_P(ChartWords, LieBesideOneAnotherAndAreAsLargeAsAsked) {
  const std::vector<Crowd> crowds{{7.9, 7.4, 31.0, 33.0, 30.0, 31.5},
                                  {7.9, 5.0, 1.0, 2.0, 1.5, 39.0},      // at the left end
                                  {7.9, 7.9, 39.5, 35.9, 39.0, 39.8},   // at the right end, limits as one
                                  {3.3, 6.8, 20.0, 20.2, 20.1, 20.3}};  // a pause upon all of it
  int cut = 0, words = 0;
  for (const Crowd& crowd : crowds)
    for (const double em : {12.0, 16.0, 19.0})
      for (const int width : {450, 740, 1200})
        for (const bool titled : {false, true})
          for (const bool monitor : {false, true}) {
            const double least = monitor  ? titled ? kLeastMonitorChart : kLeastUntitledMonitorChart
                                 : titled ? kLeastForceChart
                                          : kLeastUntitledForceChart;
            const ChartForm form{width, static_cast<int>(std::ceil(least * em)), em, titled};
            std::vector<ChartLabel> labels;
            const auto painted = painted_words({form.width, form.height}, [&](QPainter& painter) {
              labels = (monitor ? paint_monitor_chart : paint_force_chart)(
                  painter, form, crowded_log(crowd), crowded_scenario(crowd), crowded_score(crowd));
            });
            const std::string which = std::to_string(width) + " px, letters of " + std::to_string(em) +
                                      (monitor ? ", monitor" : ", force") + ", first sight at " +
                                      std::to_string(crowd.sight_s);
            const auto trouble = trouble_of(painted, {form.width, form.height});
            EXPECT_EQ(trouble, std::vector<std::string>()) << which << lines(trouble);
            for (const PaintedWord& word : painted) EXPECT_GE(word.pixels, em) << which << word.text.toStdString();
            // All there is to be said is there, on the chart or for its tooltip.
            QStringList all;
            for (const ChartLabel& label : labels) {
              all << label.whole;
              ++words;
              cut += label.cut() ? 1 : 0;
              EXPECT_GT(label.box.width() * label.box.height(), 0.0) << label.whole.toStdString();
              if (label.shown.isEmpty()) continue;
              EXPECT_TRUE(std::any_of(painted.begin(), painted.end(), [&](const PaintedWord& word) {
                return word.text == label.shown;
              })) << label.shown.toStdString();
            }
            for (const char* said : monitor ? std::vector<const char*>{"view", "tube past the cords", "paused",
                                                                       "CO2: detector yellow", "heart"}
                                            : std::vector<const char*>{"paused", "tongue", "gum"})
              EXPECT_TRUE(all.contains(QCoreApplication::translate("Charts", said))) << which << ": " << said;
          }
  EXPECT_LT(cut, words / 10) << "most of it is read without a mouse";
}

TEST_P(ChartWords, OnPaperNothingOfAnOrdinaryTrialIsCut) {
  Crowd ordinary;
  ordinary.target_n = 5.0;
  ordinary.sight_s = 12.0;
  ordinary.tongue_peak_s = 14.0;
  ordinary.gum_peak_s = 25.0;
  ordinary.pause_s = 30.0;
  curricula::Scenario scenario = crowded_scenario(ordinary);
  scenario.title = "Term infant, 3.2 kg, tube 3.5";
  const ChartForm paper = picture_form(1600, 900);
  EXPECT_EQ(paper.em, 20.0);
  for (const Chart& chart : {make_force_chart(paper, crowded_log(ordinary), scenario, crowded_score(ordinary)),
                             make_monitor_chart(paper, crowded_log(ordinary), scenario, crowded_score(ordinary))}) {
    EXPECT_EQ(chart.picture.size(), QSize(1600, 900));
    for (const ChartLabel& label : chart.labels) EXPECT_FALSE(label.cut()) << label.whole.toStdString();
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, ChartWords, ::testing::Values("en", "de"),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace vallecula::gui::window_test
