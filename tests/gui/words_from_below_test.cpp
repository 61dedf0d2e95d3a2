// What scores and reports put together of words and figures, in German: every sentence they can make is walked through.
// Judged by what German never has: the words English sentences are made of, and decimal points.
#include "gui/session/words_from_below.h"

#include <QRegularExpression>
#include <set>

#include "curricula/score/checklist.h"
#include "curricula/score/helps.h"
#include "curricula/score/points.h"
#include "curricula/score/rubric.h"
#include "device/haptic_device.h"
#include "gui/pages/module_words.h"
#include "gui/pages/result_figures.h"
#include "gui/records_pages/tables.h"
#include "gui/report/force_chart.h"
#include "gui/report/report.h"
#include "gui/session/fault_report.h"
#include "gui/session/languages.h"
#include "gui/session/replay_events.h"
#include "gui/session/user_paths.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

using curricula::Attempt;
using curricula::IntubationScore;
using curricula::Outcome;
using curricula::Scenario;
using curricula::Score;
using curricula::TrialLog;

constexpr double kNever = -1.0;

class WordsFromBelow : public Screen {
 protected:
  void SetUp() override { ASSERT_TRUE(install_language(*qApp, "de")); }
  ~WordsFromBelow() override { install_language(*qApp, "en"); }

  /// A word that English has and German never.
  static QRegularExpressionMatch english_in(const QString& text) {
    static const QRegularExpression english(
        "\\b(the|were|lies|with|than|within|allowed|asked|for|its|attempts?|blade|of|to|and|past|from|seconds|"
        "breaths?|"
        "times?|lowest|peak|force|given|never|seen|missed|good|deep|shallow|at|most|least|late|frozen|lost|motor "
        "warm|right|"
        "left|"
        "ends|begins|wrong|reached|trial|is|no|not|or)\\b",
        QRegularExpression::CaseInsensitiveOption);
    return english.match(text);
  }
  static void look_at(const std::string& said) {
    if (said.empty() || !seen_.insert(said).second) return;
    static const QRegularExpression point("\\d\\.\\d"), word("[A-Za-z]{4,}");
    const QString german = in_words(said);
    const auto left = english_in(german);
    EXPECT_FALSE(left.hasMatch()) << said << "\n  " << german.toStdString();
    EXPECT_FALSE(point.match(german).hasMatch()) << said << "\n  " << german.toStdString();
    if (word.match(QString::fromStdString(said)).hasMatch()) {
      EXPECT_NE(german.toStdString(), said);
    }
  }
  static void look_at(const std::vector<Row>& rows) {
    for (const Row& row : rows)
      for (const std::string& part : {row.name, row.value, row.limit, row.verdict}) look_at(part);
  }

  static TrialLog log() {
    TrialLog log;
    log.header.device_limit_n = 3.3;
    log.header.landmarks_m = {
        {"upper_gum_midline", {0, 0, 0.004}}, {"lower_gum_midline", {0, 0, -0.004}}, {"vallecula", {0, 0.04, -0.01}}};
    log.footer.complete = true;
    for (int i = 0; i < 3; ++i) {
      log.ticks.emplace_back();
      log.ticks.back().tick = i;
      log.ticks.back().time_s = 12.345 + 0.001 * i;
    }
    return log;
  }
  static Scenario scenario() {
    Scenario one;
    one.blade = "miller-0";
    one.sight_percent = 25.0;
    one.targets = {};
    one.targets.tongue_force_n = 4.5;
    one.targets.gum_force_n = 1.5;
    one.pass.peak_tongue_force_n = 6.8;
    one.pass.peak_gum_force_n = 3.0;
    one.pass.glottis_visible_percent = 50.0;
    one.pass.attempt_time_s = 30.0;
    one.pass.time_over_target_s = 2.5;
    one.pass.time_over_device_limit_s = 0.5;
    return one;
  }
  static Score score(bool good) {
    Score one;
    one.complete = one.attempt_begun = one.blade_out = true;
    one.mouth_entries = 1;
    one.attempt_start_s = 1.25;
    one.attempt_time_s = good ? 20.5 : 40.5;
    one.glottis_visible_max_percent = good ? 62.5 : 12.5;
    one.time_of_glottis_max_s = 7.1;
    one.peak_tongue_force_n = one.peak_force_n[curricula::kTongue] = good ? 4.25 : 8.25;
    one.time_of_peak_tongue_force_s = 3.5;
    one.peak_gum_force_n = good ? 1.25 : 4.25;
    one.time_of_peak_gum_force_s = 3.51;
    one.time_over_target_s = one.time_over_force_limit_s = good ? 0.25 : 5.25;
    one.time_to_trachea_visible_s = good ? 4.5 : kNever;
    one.time_of_first_sight_s = good ? 5.75 : kNever;
    one.loop_rate_hz = good ? 1000.0 : 0.0;
    one.view.mean_percent = 33.5;
    if (good) one.view.time_to_stable_s = 6.5, one.view.stable_at_s = 7.5;
    one.blade.entry_left_m = good ? -0.0015 : 0.0055;
    one.blade.to_vallecula_m = 0.0045;
    one.blade.to_vallecula_at_s = 4.5;
    one.blade.left_m = good ? 0.0015 : -0.0015;
    one.blade.vallecula_reached = good;
    one.blade.past_vallecula_m = good ? 0.0 : 0.0035;
    one.blade.past_vallecula_at_s = 5.5;
    one.force.mean_tongue_n = 1.5;
    one.force.tongue_pressure_pa = curricula::Peak{4500.0, 3.5};
    one.force.lift_share = 0.75;
    one.force.levered_n = {2.5, 4.5};
    one.force.levered_over_target_at_s = good ? kNever : 4.25;
    return one;
  }
  static IntubationScore tube(Outcome outcome, bool good, int attempts) {
    IntubationScore one;
    one.outcome = outcome;
    one.cords_to_carina_m = 0.0405;
    if (outcome == Outcome::good_depth || outcome == Outcome::too_shallow || outcome == Outcome::too_deep) {
      one.depth_m = outcome == Outcome::good_depth ? 0.0205 : outcome == Outcome::too_deep ? 0.0355 : 0.0055;
      one.depth_neutral_m = *one.depth_m + (good ? 0.0005 : 0.0145);
    }
    for (int i = 0; i < attempts; ++i) {
      Attempt attempt;
      attempt.start_s = 1.25 + 50.0 * i;
      attempt.end_s = attempt.start_s + 25.5;
      attempt.time_s = good ? 20.5 + i : 40.5 + i;
      attempt.paused_s = i == 1 ? 1.5 : 0.0;
      attempt.breaths_before = good ? i : 0;
      attempt.time_to_view_s = 4.5;
      attempt.view_at_s = attempt.start_s + (good ? 4.5 : 24.5);
      attempt.time_to_pass_s = good ? 8.5 : 28.5;
      attempt.passed_cords_s = attempt.start_s + 12.5;
      attempt.highest_spo2_before_percent = 98.0;
      attempt.lowest_spo2_percent = good ? 92.0 : 61.0;
      attempt.lowest_heart_per_min = good ? 140.0 : 72.0;
      attempt.desaturated = attempt.bradycardia = !good;
      one.attempts.push_back(attempt);
    }
    one.lowest_spo2_percent = good ? 92.0 : 61.0;
    one.lowest_heart_per_min = good ? 140.0 : 72.0;
    one.lowest_spo2_at_s = one.lowest_heart_at_s = 20.5;
    one.co2_confirmed = good;
    if (good) one.co2_breaths = 3;
    one.breaths_in_place = good ? 5 : 1;
    one.breaths_given = 12;
    one.tip_load_n = {good ? 1.5 : 3.5, 15.5};
    one.secretions_start_ml = 1.5;
    one.secretions_end_ml = good ? 0.5 : 1.5;
    return one;
  }
  /// All that stands on the result page and in the report of this trial.
  static void look_at(const TrialLog& log, const Scenario& scenario, Score score,
                      const curricula::Moments& moments = {}) {
    curricula::judge(log, scenario, moments, score);
    for (const auto& criterion : score.criteria) look_at(criterion.sentence);
    for (const auto& points : curricula::points_of(score, scenario)) look_at(points.source);
    for (const auto& item : curricula::checklist_of(score, log, scenario)) {
      look_at(item.text);
      look_at(item.sentence);
    }
    if (score.intubation) look_at(curricula::outcome_in_words(*score.intubation));
    look_at(report_rows(score, log, scenario));
    TrialOutcome outcome;
    outcome.score = score;
    look_at(result_figures(outcome, scenario));
    for (const ReplayEvent& event : replay_events(log, scenario, score)) look_at(event.text);
  }

  static inline std::set<std::string> seen_;
};

TEST_F(WordsFromBelow, EverySentenceOfALaryngoscopysScoreIsGerman) {
  for (const bool good : {true, false})
    for (const double pause_s : {0.0, 2.5})
      for (const int entries : {1, 3})
        for (const bool out : {true, false}) {
          Score one = score(good);
          one.attempt_paused_s = pause_s;
          one.mouth_entries = entries;
          one.blade_out = out;
          curricula::Moments moments;
          moments.over_target_s = moments.longest_off_tracking_s = out ? 4.25 : kNever;
          moments.not_finite_s = out ? kNever : 9.25;
          look_at(log(), scenario(), one, moments);
        }
  Score nothing;
  nothing.time_of_glottis_max_s = kNever;
  look_at(log(), scenario(), nothing);
  TrialLog no_landmarks = log();
  no_landmarks.header.landmarks_m.clear();
  look_at(no_landmarks, scenario(), nothing);
  for (const char* ended : {"", "interrupted", "reset", "finished", "the scenario's time was over",
                            "the device did not come back", "no picture came any more",
                            "ended by trainee"}) {
    TrialLog cut = log();
    cut.footer.ended = ended;
    Score one = score(true);
    one.complete = false;
    look_at(cut, scenario(), one);
  }
  EXPECT_GT(seen_.size(), 100u);
}

TEST_F(WordsFromBelow, EverySentenceOfAnIntubationsScoreIsGerman) {
  const std::size_t before = seen_.size();
  for (int outcome = 0; outcome < curricula::kOutcomes; ++outcome)
    for (int accepted = 0; accepted < curricula::kOutcomes; ++accepted)
      for (const bool good : {true, false})
        for (const int attempts : {0, 1, 2}) {
          Scenario asked = scenario();
          asked.intubation.emplace();
          asked.intubation->tube = "3.5";
          asked.intubation->stylet = true;
          asked.intubation->breaths_to_confirm = 6;
          curricula::IntubationPass& pass = asked.intubation->pass;
          pass.outcomes = {static_cast<Outcome>(accepted)};
          if (accepted % 2 == 1) pass.outcomes.push_back(Outcome::good_depth);
          pass.lowest_spo2_percent = 85.0;
          pass.lowest_heart_per_min = 100.0;
          pass.tube_force_n = 2.5;
          pass.time_to_pass_s = 15.0;
          pass.attempts = 1;
          pass.co2_confirmed = pass.depth_neutral = pass.oesophagus_in_time = pass.no_severe_desaturation = true;
          asked.attempt.right_blade = good ? "miller-0" : "miller-1";
          asked.attempt.right_tube = good ? "3.5" : "3.0";
          Score one = score(good);
          one.attempt_begun = attempts > 0;
          one.intubation = tube(static_cast<Outcome>(outcome), good, attempts);
          IntubationScore& done = *one.intubation;
          done.bronchus_side = static_cast<std::int8_t>(accepted % 3 - 1);
          done.tip_against = accepted % 2 == 0
                                 ? curricula::kNothingAgainstTip
                                 : static_cast<std::uint8_t>((accepted + 2 * outcome) % curricula::kTubeLoads);
          if (accepted == 2) done.tip_load_n.at_s = done.lowest_spo2_at_s = done.lowest_heart_at_s = kNever;
          for (std::size_t part = 0; part < done.loads_n.size(); ++part)
            done.loads_n[part].value = part % 3 == static_cast<std::size_t>(accepted % 3) ? 1.25 : 0.0;
          if (accepted % 3 == 1) {
            done.oesophagus_entries = good ? 1 : 2;
            done.oesophagus_breaths = good ? 2 : 8;
            done.oesophagus_s = 4.5;
            done.recognised_late = !good;
            done.recognised_late_at_s = good ? kNever : 22.5;
          }
          if (accepted == 4 && attempts > 0) {
            done.attempts.back().view_at_s.reset();
            done.attempts.back().time_to_view_s.reset();
          }
          if (accepted == 5 && attempts > 0) done.attempts.back().passed_cords_s = done.attempts.back().end_s + 1.5;
          if (accepted == 6) one.blade_out = false;
          if (accepted == 7) one.force.lift_share.reset();
          if (accepted == 8) one.blade = {};
          if (accepted == 1) done.first_spo2_percent = 97.0, done.first_heart_per_min = 150.0;
          if (accepted == 2) done.first_spo2_percent = *done.lowest_spo2_percent;
          if (accepted == 2) done.first_heart_per_min = *done.lowest_heart_per_min;
          one.at_vallecula = accepted == 0;
          TrialLog trial = log();
          for (auto& tick : trial.ticks) tick.has_intubation = true;
          if (accepted == 3)
            for (auto& tick : trial.ticks) {
              tick.time_s = 13.0;
              tick.has_sight = true;
              tick.glottis_visible = 0.25;
              tick.intubation.place = curricula::LoggedPlace::trachea;
              tick.intubation.in_hand =
                  good ? curricula::LoggedInHand::tube : curricula::LoggedInHand::tube_with_stylet;
              tick.intubation.breaths_given = 1;
            }
          look_at(trial, asked, one);
        }
  EXPECT_GT(seen_.size(), before + 150);
}

TEST_F(WordsFromBelow, PausesHelpsAndDistractionsAreGerman) {
  Score one = score(true);
  for (int fault = 0; fault <= static_cast<int>(device::DeviceFault::frozen); ++fault) {
    const std::string name = device::name_of(static_cast<device::DeviceFault>(fault));
    if (name == "none") continue;
    one.pauses = {{3.5, 1.5, name}};
    look_at(pauses_in_words(one));
    look_at(log(), scenario(), one);
    one.pauses.push_back({6.5, 1.5, ""});
    look_at(pauses_in_words(one));
  }
  one.pauses.clear();
  for (const int times : {1, 2}) {
    one.eye_moves = one.extension = one.aided = {times, 2.5, 3.5};
    look_at(log(), scenario(), one);
  }
  one.dual_task.emplace();
  one.dual_task->right = 2;
  one.dual_task->false_answers = 1;
  one.dual_task->mean_reaction_s = 1.5;
  look_at(log(), scenario(), one);
  for (const std::uint32_t bits :
       {curricula::kLoggedSaturationDriven, curricula::kLoggedHeartDriven, curricula::kLoggedSpasm}) {
    TrialLog driven = log();
    driven.header.has_intubation = true;
    driven.ticks[1].buttons = bits;
    for (const bool led : {false, true}) {
      Score told;
      curricula::measure_helps(driven, scenario(), led, told);
      ASSERT_FALSE(told.set_aside.empty());
      for (const std::string& why : told.set_aside) look_at(why);
    }
  }
  // As they once stood in the German window.
  EXPECT_EQ(
      in_words("The tube is not in the trachea: the intubation was given up; asked for: good-depth").toStdString(),
      u8"Der Tubus ist nicht in der Trachea: Die Intubation wurde aufgegeben; verlangt: gute Tiefe");
  EXPECT_EQ(in_words("1 time (frozen)").toStdString(), "1-mal (eingefroren)");
  for (const auto state : {device::GuardState::paused, device::GuardState::confirming})
    for (int fault = 0; fault <= static_cast<int>(device::DeviceFault::frozen); ++fault) {
      const std::string pause = pause_words(state, static_cast<device::DeviceFault>(fault), false);
      if (!pause.empty()) look_at("The tube's hand: " + pause);
    }
  for (const char* column : {"At", "Why", "Points", "Limit by", "Item", "Done"})
    EXPECT_NE(in_words(column).toStdString(), column);
}

TEST_F(WordsFromBelow, AReportsTablesAreGermanToTheirColumns) {
  const test::Sandbox box;
  TrialLog trial = log();
  trial.header.has_intubation = true;
  for (auto& tick : trial.ticks) tick.has_intubation = true;
  Scenario asked = scenario();
  asked.title = "Term infant, 3.2 kg, tube 3.5";
  asked.intubation.emplace().pass.time_to_pass_s = 20.0;
  Score one = score(true);
  one.intubation = tube(Outcome::good_depth, true, 2);
  curricula::judge(trial, asked, {}, one);
  one.checklist = curricula::checklist_of(one, trial, asked);
  draw_force_chart(trial, asked, one).save(QString::fromStdString((box / "force.png").string()));
  write_report(box.folder(), trial, asked, one);
  const QString page = QString::fromStdString(test::text_of(box / "report.html"));
  const int end = page.lastIndexOf("<h2>");  // how it was recorded: names of builds and devices
  static const QRegularExpression cell("<(?:th|td|h1|h2)[^>]*>([^<]+)<"), point("\\d\\.\\d");
  int cells = 0;
  for (auto found = cell.globalMatch(page.left(end)); found.hasNext(); ++cells) {
    const QString text = found.next().captured(1);
    EXPECT_FALSE(english_in(text).hasMatch()) << text.toStdString();
    EXPECT_FALSE(point.match(text).hasMatch()) << text.toStdString();
  }
  EXPECT_GT(cells, 150);
  EXPECT_TRUE(page.contains("<h1>Reifgeborenes, 3,2 kg, Tubus 3,5</h1>"));
}

TEST_F(WordsFromBelow, TheShippedCoursesAreTitledInGermanAndNobodysOwnIs) {
  std::size_t told = 0;
  const auto in_german = [&](const std::string& english) {
    EXPECT_NE(course_words(english).toStdString(), english);
    ++told;
  };
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(VALLECULA_SOURCE_DIR) / "curricula/courses")) {
    const curricula::Curriculum course = curricula::load_curriculum(file.path());
    in_german(course.title);
    for (const curricula::Text& goal : course.goals) in_german(goal.in("en"));
    for (const curricula::Module& module : course.modules) {
      in_german(module.title);
      in_german(module.goal.in("en"));
    }
    for (const Scenario& one : course.scenarios) {
      in_german(one.title);
      in_german(one.briefing.in("en"));
      in_german(one.debriefing.in("en"));
      for (const curricula::Distraction& asked : one.distractions) in_german(asked.text.in("en"));
    }
  }
  EXPECT_GT(told, 90u);
  EXPECT_EQ(course_words("Preterm infant, 1.2 kg").toStdString(), u8"Fr\u00fchgeborenes, 1,2 kg");
  for (const char* own : {"Term infant, 3.4 kg", "finished", "2 trials", "Our ward's first steps"})
    EXPECT_EQ(course_words(own).toStdString(), own);
}

TEST_F(WordsFromBelow, TheRecordsTellMomentsHandsAndSourcesInGerman) {
  const char* before = std::getenv("TZ");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TZ", "XYZ-5:30", 1);  // 5 h 30 min before UTC's
  tzset();
  EXPECT_EQ(for_people("2026-05-03T20:00:00Z").toStdString(), "04.05.2026 01:30");
  EXPECT_EQ(local_day("2026-05-03T20:00:00Z"), QDate(2026, 5, 4)) << "which the calendar goes by, in any language";
  before == nullptr ? unsetenv("TZ") : setenv("TZ", kept.c_str(), 1);
  tzset();
  EXPECT_EQ(hands_in_words("mouse").toStdString(), "Maus");
  EXPECT_EQ(hands_in_words("touch+mouse").toStdString(), "touch+Maus") << "a product's name stays";
  int rules = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(VALLECULA_SOURCE_DIR) / "curricula/courses"))
    for (const curricula::Module& module : curricula::load_curriculum(file.path()).modules) {
      const QString rule = mastery_rule(module);
      EXPECT_FALSE(english_in(rule).hasMatch() || rule.contains("assumed")) << rule.toStdString();
      EXPECT_EQ(rule.contains("PMC8290971"), module.mastery.source.find("PMC8290971") != std::string::npos)
          << "a citation stays";
      ++rules;
    }
  EXPECT_GE(rules, 7);
}

TEST_F(WordsFromBelow, WhatNobodyListedStaysAsItIs) {
  for (const char* unknown : {"12 unknown things in 3 places", "/data/3.2kg.patient: no file", "term-3.2kg.patient",
                              "an unknown thing; asked again", "miller-0"})
    EXPECT_EQ(in_words(unknown).toStdString(), unknown);
  EXPECT_EQ(in_words("4.20 N").toStdString(), "4,20 N");
  EXPECT_EQ(decimal(1234.5, 1).toStdString(), "1234,5");
  EXPECT_EQ(short_decimal(0.25, 3).toStdString(), "0,25");
  ASSERT_TRUE(install_language(*qApp, "en"));
  EXPECT_EQ(in_words("4.20 N").toStdString(), "4.20 N");
  EXPECT_EQ(decimal(1234.5, 1).toStdString(), "1234.5");
}

}  // namespace
}  // namespace vallecula::gui::window_test
