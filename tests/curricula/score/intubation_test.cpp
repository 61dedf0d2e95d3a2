// Hand-made intubations whose every figure is known beforehand.
#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <functional>

#include "curricula/score/score.h"

namespace vallecula::curricula {
namespace {

constexpr double kTick = 0.001;
constexpr std::array<double, 3> kOutside{0.0, -0.10, 0.10}, kInMouth{0.0, 0.02, -0.02};
using Change = std::function<void(LogTick&)>;

Scenario scenario() {
  Scenario s;
  s.id = "tube";
  s.title = "Tube";
  s.sight_percent = 25;
  s.max_attempt_s = 180;
  s.targets = {5.0, 2.0};
  s.pass = {6.8, 3.0, 50.0, 30.0, 3.0, 0.2};
  IntubationSpec& i = s.intubation.emplace();
  i.tube = "3.5";
  i.breaths_to_confirm = 6;
  i.pass.lowest_spo2_percent = 70;
  i.pass.lowest_heart_per_min = 100;
  i.pass.tube_force_n = 2;
  i.pass.time_to_pass_s = 20;
  i.pass.attempts = 2;
  i.pass.co2_confirmed = true;
  return s;
}

bool between(const LogTick& t, double from_s, double to_s) {
  return t.time_s > from_s - kTick / 2 && t.time_s < to_s - kTick / 2;
}

/// 40 s. Breaths by mask at 1, 2 and 3 s. Blade in from 5 to 20 s, 80 % of the glottis in sight from 9 s on. The tube's
/// tip is in the mouth from 11 s, in the larynx from 12 s, past the cords from 14 s, in the trachea from 14.5 s, and
/// from 16 s on 24 mm deep, of 48 mm to the carina. Breaths through it every second from 22 s; the third turns the
/// detector yellow. Saturation 95 % before, 80 % from 20 to 28 s, then 93 %; heart 140, from 18 to 26 s 110.
TrialLog log_of(const Change& change = {}, double seconds = 40.0) {
  TrialLog log;
  log.header.has_intubation = true;
  log.header.schema = 3;
  log.header.settings[kCordsToCarina] = 0.048;
  log.header.landmarks_m = {{"upper_gum_midline", {0, 0, 0}},
                            {"lower_gum_midline", {0, 0.0032, -0.0208}},
                            {"vallecula", {0, 0.0285, -0.0415}}};
  log.footer = {true, "finished", 0.0, 0, 0, "", {}};
  const int ticks = static_cast<int>(std::lround(seconds / kTick));
  for (int n = 0; n < ticks; ++n) {
    LogTick t;
    t.tick = t.step_fed = t.step_used = n;
    t.time_s = n * kTick;
    t.proxy_pose.position_m = between(t, 5, 20) ? kInMouth : kOutside;
    t.has_sight = n % 20 == 0;
    if (between(t, 9, 20) && t.has_sight) t.glottis_visible = 0.8;
    t.has_intubation = true;
    LogIntubation& i = t.intubation;
    i.place = t.time_s < 11 - kTick / 2     ? LoggedPlace::outside
              : t.time_s < 12 - kTick / 2   ? LoggedPlace::mouth
              : t.time_s < 14.5 - kTick / 2 ? LoggedPlace::larynx
                                            : LoggedPlace::trachea;
    if (t.time_s > 14 - kTick / 2) i.past_cords_m = std::min(0.024, 0.012 * (t.time_s - 14) + 1e-6);
    i.glottis_opening = 0.8;
    i.breaths_given = std::min(3, n / 1000) + std::max(0, (n - 21000) / 1000);
    i.detector_yellow = n >= 24000;
    i.sao2 = i.spo2 = between(t, 20, 28) ? 0.80 : t.time_s < 20 ? 0.95 : 0.93;
    i.heart_per_min = between(t, 18, 26) ? 110.0 : 140.0;
    if (t.tick == 14250) i.tip_load_n = 1.5, i.tip_against = kTubeCords, i.loads_n[kTubeCords] = 1.7;
    if (t.tick == 14600) i.loads_n[kTubeCricoid] = 2.5, i.model_force_n = {0.6, 0, 0.8};
    i.secretions_ml = n < 8000 ? 1.5 : 0.25;
    if (change) change(t);
    log.ticks.push_back(t);
  }
  return log;
}

Score score_of(const Change& change = {}, const Scenario& s = scenario()) { return score_trial(log_of(change), s); }

/// The tube's tip goes nowhere of itself: outside for the whole trial, until `change` puts it somewhere.
Change never_in(const Change& change = {}) {
  return [change](LogTick& t) {
    t.intubation.place = LoggedPlace::outside;
    t.intubation.past_cords_m = 0.0;
    t.intubation.detector_yellow = false;
    t.intubation.tip_load_n = 0.0;
    if (change) change(t);
  };
}

Change pushed(double from_s, double to_s, std::uint8_t against, double opening) {
  return never_in([=](LogTick& t) {
    if (!between(t, from_s, to_s)) return;
    t.intubation.place = LoggedPlace::larynx;
    t.intubation.past_cords_m = against == kTubeCricoid ? 0.008 : 0.0;
    t.intubation.tip_against = against;
    t.intubation.tip_load_n = 1.0;
    t.intubation.glottis_opening = opening;
  });
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& t : texts) all += t + "\n";
  return all;
}

TEST(IntubationScore, MeasuresAGoodOne) {
  const Score s = score_of();
  EXPECT_TRUE(s.passed) << joined(s.reasons);
  ASSERT_TRUE(s.intubation);
  const IntubationScore& i = *s.intubation;
  EXPECT_EQ(i.outcome, Outcome::good_depth);
  EXPECT_EQ(outcome_in_words(i),
            "The tube's tip lies 24.0 mm past the cords, 50 % of the way to the carina: good depth");
  ASSERT_EQ(i.attempts.size(), 1u);
  const Attempt& a = i.attempts[0];
  EXPECT_NEAR(a.start_s, 5.0, 1e-9);
  EXPECT_NEAR(a.end_s, 20.0, 1e-9);
  EXPECT_NEAR(a.time_s, 15.0, 1e-9);
  EXPECT_EQ(a.breaths_before, 3);
  EXPECT_NEAR(*a.time_to_view_s, 4.0, 1e-9);
  EXPECT_NEAR(*a.time_to_pass_s, 5.0, 1e-9);
  EXPECT_NEAR(*a.passed_cords_s, 14.0, 1e-9);
  EXPECT_NEAR(a.highest_spo2_before_percent, 95.0, 1e-9);
  EXPECT_NEAR(a.lowest_spo2_percent, 80.0, 1e-9) << "the display falls after the blade is out: still its doing";
  EXPECT_EQ(a.lowest_heart_per_min, 110.0);
  EXPECT_FALSE(a.desaturated);
  EXPECT_FALSE(a.bradycardia);
  EXPECT_NEAR(s.attempt_time_s, 15.0, 1e-9);
  EXPECT_NEAR(s.time_to_trachea_visible_s, 4.0, 1e-9);
  EXPECT_NEAR(s.time_of_first_sight_s, 9.0, 1e-9);
  EXPECT_NEAR(*i.depth_m, 0.024, 1e-12);
  EXPECT_NEAR(i.deepest_m, 0.024, 1e-12);
  EXPECT_FALSE(i.depth_neutral_m);
  EXPECT_NEAR(*i.lowest_spo2_percent, 80.0, 1e-9);
  EXPECT_NEAR(i.lowest_spo2_at_s, 20.0, 1e-9);
  EXPECT_EQ(*i.lowest_heart_per_min, 110.0);
  EXPECT_NEAR(i.lowest_heart_at_s, 18.0, 1e-9);
  EXPECT_EQ(i.breaths_given, 21);
  EXPECT_TRUE(i.co2_confirmed);
  EXPECT_EQ(*i.co2_breaths, 3);
  EXPECT_EQ(i.breaths_in_place, 18);
  EXPECT_EQ(i.oesophagus_entries, 0);
  EXPECT_FALSE(i.recognised_late);
  EXPECT_EQ(i.tip_load_n.value, 1.5);
  EXPECT_NEAR(i.tip_load_n.at_s, 14.25, 1e-9);
  EXPECT_EQ(i.tip_against, kTubeCords);
  EXPECT_EQ(i.loads_n[kTubeCords].value, 1.7);
  EXPECT_EQ(i.loads_n[kTubeCricoid].value, 2.5);
  EXPECT_EQ(i.loads_n[kTubeTrachea].at_s, -1.0);
  EXPECT_NEAR(i.hand_force_n.value, 1.0, 1e-12);
  EXPECT_EQ(i.secretions_start_ml, 1.5);
  EXPECT_EQ(i.secretions_end_ml, 0.25);
}

TEST(IntubationScore, EveryOutcomeIsWhereTheTipReallyIs) {
  const auto at_depth = [](double depth_m, LoggedPlace place = LoggedPlace::trachea) {
    return [=](LogTick& t) {
      if (t.time_s < 16) return;
      t.intubation.place = place;
      t.intubation.past_cords_m = depth_m;
    };
  };
  const auto oesophagus = [](LogTick& t) {
    if (t.time_s > 13.9995) t.intubation.place = LoggedPlace::oesophagus;
  };
  const auto spasm_at_the_end_of_the_attempt = never_in([](LogTick& t) { t.intubation.spasm = between(t, 18, 22); });
  const auto spasm_long_over = never_in([](LogTick& t) { t.intubation.spasm = between(t, 12, 18); });
  const struct {
    const char* name;
    Change change;
    Outcome outcome;
  } cases[] = {
      {"a third", at_depth(0.016), Outcome::good_depth},
      {"two thirds", at_depth(0.032), Outcome::good_depth},
      {"less than a third", at_depth(0.01599), Outcome::too_shallow},
      {"more than two thirds", at_depth(0.03201), Outcome::too_deep},
      {"in the larynx, past the cords", at_depth(0.004, LoggedPlace::larynx), Outcome::too_shallow},
      {"in the larynx, above the cords", at_depth(0.0, LoggedPlace::larynx), Outcome::abandoned},
      {"depth is not a number", at_depth(std::nan("")), Outcome::too_shallow},
      {"bronchus", at_depth(0.055, LoggedPlace::main_bronchus), Outcome::mainstem},
      {"oesophagus", oesophagus, Outcome::oesophagus},
      {"stands before the cricoid", pushed(15, 50, kTubeCricoid, 0.8), Outcome::cricoid_too_narrow},
      {"drawn back from the cricoid", pushed(15, 18, kTubeCricoid, 0.8), Outcome::cricoid_too_narrow},
      {"stands before closed cords", pushed(15, 50, kTubeCords, 0.24), Outcome::cords_closed},
      {"drawn back from closed cords", pushed(15, 18, kTubeCords, 0.0), Outcome::cords_closed},
      {"stopped beside open cords", pushed(15, 18, kTubeCords, 0.26), Outcome::abandoned},
      {"stopped by the tongue", pushed(15, 18, kTubeTongue, 0.0), Outcome::abandoned},
      {"spasm when the blade came out", spasm_at_the_end_of_the_attempt, Outcome::cords_closed},
      {"spasm that was over by then", spasm_long_over, Outcome::abandoned},
      {"never in", never_in(), Outcome::abandoned},
      {"out again",
       [](LogTick& t) {
         if (t.time_s > 30) t.intubation.place = LoggedPlace::outside;
       },
       Outcome::abandoned},
      {"the catheter is no tube", [](LogTick& t) { t.intubation.in_hand = LoggedInHand::catheter; },
       Outcome::abandoned},
      {"with its stylet", [](LogTick& t) { t.intubation.in_hand = LoggedInHand::tube_with_stylet; },
       Outcome::good_depth},
      {"once past the cricoid, which then stops it",
       [](LogTick& t) {
         if (t.time_s < 30) return;
         t.intubation.place = LoggedPlace::larynx;
         t.intubation.past_cords_m = 0.008;
         t.intubation.tip_against = kTubeCricoid;
         t.intubation.tip_load_n = 1.0;
       },
       Outcome::too_shallow},
      {"a light touch of the cricoid is no stop",
       [](LogTick& t) {
         pushed(15, 18, kTubeCricoid, 0.8)(t);
         t.intubation.tip_load_n *= 0.49;
       },
       Outcome::abandoned},
      {"a pause in which it seems elsewhere",
       [](LogTick& t) {
         if (t.time_s < 35) return;
         t.intubation.hand_valid = false;
         t.intubation.place = LoggedPlace::outside;
       },
       Outcome::good_depth},
  };
  for (const auto& c : cases) {
    const Score s = score_of(c.change);
    EXPECT_EQ(s.intubation->outcome, c.outcome) << c.name << ": " << name_of(s.intubation->outcome);
    EXPECT_EQ(s.passed, c.outcome == Outcome::good_depth) << c.name << joined(s.reasons);
    EXPECT_NE(outcome_in_words(*s.intubation), "") << c.name;
    if (!s.passed) {
      EXPECT_NE(joined(s.reasons).find("; asked for: good-depth"), std::string::npos) << c.name << joined(s.reasons);
    }
  }
}

TEST(IntubationScore, TimeRunsOutUnlessTheTubeStandsBeforeWhatStopsIt) {
  Scenario s = scenario();
  s.max_attempt_s = 40.0;
  EXPECT_EQ(score_of(never_in(), s).intubation->outcome, Outcome::out_of_time);
  EXPECT_EQ(score_of(pushed(15, 18, kTubeCords, 0.0), s).intubation->outcome, Outcome::out_of_time);
  EXPECT_EQ(score_of(pushed(15, 50, kTubeCords, 0.0), s).intubation->outcome, Outcome::cords_closed);
  EXPECT_EQ(score_of(pushed(15, 50, kTubeCricoid, 0.8), s).intubation->outcome, Outcome::cricoid_too_narrow);
  EXPECT_EQ(score_of({}, s).intubation->outcome, Outcome::good_depth) << "who is in is in";
  s.max_attempt_s = 40.1;
  EXPECT_EQ(score_of(never_in(), s).intubation->outcome, Outcome::abandoned);
  s.max_attempt_s = 40.0;
  const auto with_pause = never_in([](LogTick& t) { t.device_valid = !between(t, 1, 2); });
  EXPECT_EQ(score_of(with_pause, s).intubation->outcome, Outcome::abandoned) << "a pause is no time of the trial";
}

TEST(IntubationScore, AnotherOutcomeMayBeAskedFor) {
  Scenario s = scenario();
  s.intubation->pass.outcomes = {Outcome::good_depth, Outcome::cords_closed};
  const Score score = score_of(pushed(15, 18, kTubeCords, 0.0), s);
  EXPECT_TRUE(score.passed) << joined(score.reasons)
                            << "no detector is asked about a tube that was wisely never passed";
}

TEST(IntubationScore, AttemptsHaveTheirOwnTimesAndLows) {
  // 5 to 15 s without a tube, 70 s of breaths between, 22 to 38 s with it.
  const Score s = score_of([](LogTick& t) {
    t.proxy_pose.position_m = between(t, 5, 15) || between(t, 22, 38) ? kInMouth : kOutside;
    t.glottis_visible = t.has_sight && (between(t, 8, 15) || between(t, 30, 38)) ? 0.6 : 0.0;
    LogIntubation& i = t.intubation;
    i.place = t.time_s > 33.9995 ? LoggedPlace::trachea : LoggedPlace::outside;
    i.past_cords_m = t.time_s > 33.9995 ? 0.024 : 0.0;
    i.detector_yellow = t.time_s > 39.0;
    i.tip_load_n = 0.0;
    i.breaths_given = std::min(3, static_cast<int>(t.tick / 1000));
    if (t.tick >= 16000) i.breaths_given = 3 + std::min(4, static_cast<int>((t.tick - 15000) / 1000));
    if (t.tick >= 38500) i.breaths_given = 8;
    i.spo2 = t.time_s < 12 ? 0.96 : t.time_s < 19.9995 ? 0.77 : t.time_s < 23.9995 ? 0.90 : 0.70;
    i.heart_per_min = between(t, 16, 17) ? 99.9 : between(t, 33, 34) ? 100.0 : 150.0;
  });
  const IntubationScore& i = *s.intubation;
  ASSERT_EQ(i.attempts.size(), 2u);
  EXPECT_EQ(i.outcome, Outcome::good_depth);
  const Attempt &a = i.attempts[0], &b = i.attempts[1];
  EXPECT_NEAR(a.time_s, 10.0, 1e-9);
  EXPECT_NEAR(*a.time_to_view_s, 3.0, 1e-9);
  EXPECT_FALSE(a.time_to_pass_s);
  EXPECT_NEAR(a.highest_spo2_before_percent, 96.0, 1e-9);
  EXPECT_NEAR(a.lowest_spo2_percent, 77.0, 1e-9);
  EXPECT_FALSE(a.desaturated) << "by 19 points";
  EXPECT_TRUE(a.bradycardia) << "after the blade was out, before the next attempt";
  EXPECT_EQ(a.breaths_before, 3);
  EXPECT_NEAR(b.time_s, 16.0, 1e-9);
  EXPECT_EQ(b.breaths_before, 4);
  EXPECT_NEAR(*b.time_to_view_s, 8.0, 1e-9);
  EXPECT_NEAR(*b.time_to_pass_s, 4.0, 1e-9);
  EXPECT_NEAR(b.highest_spo2_before_percent, 96.0 - 6.0, 1e-9) << "since the attempt before";
  EXPECT_NEAR(b.lowest_spo2_percent, 70.0, 1e-9);
  EXPECT_TRUE(b.desaturated) << "by 20 points";
  EXPECT_FALSE(b.bradycardia) << "100 is not below 100";
  EXPECT_EQ(i.decisive(), &b);
  EXPECT_EQ(i.longest(), &b);
  EXPECT_NEAR(s.attempt_start_s, 22.0, 1e-9);
  EXPECT_NEAR(s.attempt_time_s, 16.0, 1e-9) << "the limit holds for each, so for the longest";
  EXPECT_NEAR(s.time_to_trachea_visible_s, 3.0, 1e-9);
  EXPECT_NEAR(s.time_of_first_sight_s, 8.0, 1e-9);
  EXPECT_EQ(s.mouth_entries, 2);
  EXPECT_EQ(*i.co2_breaths, 1);
  for (const Criterion& c : s.criteria) {
    if (c.name == "attempt_time_s") {
      EXPECT_EQ(c.sentence, "Attempt 2 of 2, the longest, took 16.00 s (22.00 s to 38.00 s), within the 30 s allowed");
    }
  }
}

TEST(IntubationScore, ATubePassedBlindlyIsTimedFromTheBlade) {
  const Score never_seen = score_of([](LogTick& t) { t.glottis_visible = 0.0; });
  EXPECT_FALSE(never_seen.intubation->attempts[0].time_to_view_s);
  EXPECT_NEAR(*never_seen.intubation->attempts[0].time_to_pass_s, 9.0, 1e-9);
  EXPECT_LT(never_seen.time_to_trachea_visible_s, 0.0);
  const Score seen_after =
      score_of([](LogTick& t) { t.glottis_visible = between(t, 17, 19) && t.has_sight ? 0.8 : 0; });
  EXPECT_NEAR(*seen_after.intubation->attempts[0].time_to_view_s, 12.0, 1e-9);
  EXPECT_NEAR(*seen_after.intubation->attempts[0].time_to_pass_s, 9.0, 1e-9);
  EXPECT_NE(joined(seen_after.reasons).find("without a view, it took 9.00 s at 14.00 s"), std::string::npos)
      << joined(seen_after.reasons);
}

TEST(IntubationScore, APauseCountsForNothing) {
  const Score s = score_of([](LogTick& t) {
    if (!between(t, 10, 12.5)) return;
    t.intubation.hand_valid = false;
    t.intubation.spo2 = 0.1;
    t.intubation.heart_per_min = 10.0;
    t.intubation.tip_load_n = 7.0;
    t.intubation.place = LoggedPlace::oesophagus;
  });
  EXPECT_TRUE(s.passed) << joined(s.reasons);
  EXPECT_NEAR(s.intubation->attempts[0].time_s, 12.5, 1e-9);
  EXPECT_NEAR(s.intubation->attempts[0].paused_s, 2.5, 1e-9);
  EXPECT_NEAR(*s.intubation->attempts[0].time_to_pass_s, 2.5, 1e-9);
  EXPECT_NEAR(s.paused_s, 2.5, 1e-9);
  EXPECT_EQ(s.intubation->oesophagus_entries, 0);
}

TEST(IntubationScore, TheOesophagusIsCountedAndRecognisedLateOrNot) {
  // In it from 14 to 26 s, with a breath at 22 (the first through the tube), 23, 24, 25 s; then the trachea.
  const auto there = [](double until_s) {
    return [until_s](LogTick& t) {
      if (between(t, 14, until_s)) t.intubation.place = LoggedPlace::oesophagus;
      t.intubation.detector_yellow = t.time_s > until_s + 3;
    };
  };
  Scenario s = scenario();
  s.intubation->breaths_to_confirm = 4;
  const Score in_time = score_of(there(26), s);
  EXPECT_EQ(in_time.intubation->oesophagus_entries, 1);
  EXPECT_EQ(in_time.intubation->oesophagus_breaths, 4);
  EXPECT_NEAR(in_time.intubation->oesophagus_s, 4.0, 1e-9);
  EXPECT_FALSE(in_time.intubation->recognised_late);
  EXPECT_EQ(in_time.intubation->outcome, Outcome::good_depth);
  EXPECT_EQ(*in_time.intubation->co2_breaths, 4) << "counted from where the tube came to lie: at 26, 27, 28, 29 s";
  const Score late = score_of(there(26.5), s);
  EXPECT_EQ(late.intubation->oesophagus_breaths, 5);
  EXPECT_TRUE(late.intubation->recognised_late);
  const Score to_the_end = score_of(there(50), s);
  EXPECT_NEAR(to_the_end.intubation->oesophagus_s, 18.0, 1e-9);
  EXPECT_EQ(to_the_end.intubation->outcome, Outcome::oesophagus);
  EXPECT_FALSE(to_the_end.intubation->depth_m);
}

TEST(IntubationScore, AYellowDetectorOfAnEarlierPlaceConfirmsNothing) {
  const Score s = score_of([](LogTick& t) {
    t.intubation.detector_yellow = between(t, 23, 30);
    if (between(t, 30, 30.5)) t.intubation.place = LoggedPlace::mouth;
  });
  EXPECT_EQ(s.intubation->outcome, Outcome::good_depth);
  EXPECT_FALSE(s.intubation->co2_confirmed);
  EXPECT_EQ(s.intubation->breaths_in_place, 9);
  EXPECT_NE(joined(s.reasons).find("did not turn yellow with 9 breaths through it"), std::string::npos)
      << joined(s.reasons);
}

TEST(IntubationScore, TheHeadNeutralPutsTheTipDeeper) {
  TrialLog log = log_of();
  log.header.settings[kHeadExtension] = 25.0;
  EXPECT_NEAR(*score_trial(log, scenario()).intubation->depth_neutral_m, 0.029, 1e-12);
  EXPECT_EQ(score_trial(log, scenario()).intubation->outcome, Outcome::good_depth) << "told, not judged";
}

TEST(IntubationScore, EachLimitFailsAloneForItsOwnReasonWithFigureLimitAndSecond) {
  const struct {
    const char* name;
    Change change;
    std::vector<std::string> says;
  } cases[] = {
      {"saturation",
       [](LogTick& t) {
         if (t.tick == 21000) t.intubation.spo2 = 0.69;
       },
       {"Saturation fell to 69.00 % at 21.00 s", "70 % asked for"}},
      {"heart",
       [](LogTick& t) {
         if (t.tick == 19000) t.intubation.heart_per_min = 99.0;
       },
       {"The heart fell to 99.00 per minute at 19.00 s", "100 per minute asked for"}},
      {"force",
       [](LogTick& t) {
         if (t.tick == 14700) t.intubation.tip_load_n = 2.5, t.intubation.tip_against = kTubeTrachea;
       },
       {"(trachea) with 2.50 N at 14.70 s", "2 N allowed"}},
      {"time to pass",
       [](LogTick& t) {
         const bool late = t.time_s < 30.4995;
         t.proxy_pose.position_m = between(t, 5, 31) ? kInMouth : kOutside;
         t.intubation.place = late ? LoggedPlace::larynx : LoggedPlace::trachea;
         t.intubation.past_cords_m = late ? 0.0 : 0.024;
         t.intubation.detector_yellow = t.time_s > 33;
       },
       {"From the view to the cords passed it took 21.50 s at 30.50 s", "20 s allowed"}},
      {"attempts",
       [](LogTick& t) {
         t.proxy_pose.position_m = between(t, 1, 2) || between(t, 3.5, 4) || between(t, 6, 20) ? kInMouth : kOutside;
       },
       {"3 attempts, more than the 2 allowed"}},
      {"an attempt's time",
       [](LogTick& t) { t.proxy_pose.position_m = between(t, 5, 36) ? kInMouth : kOutside; },
       {"The attempt took 31.00 s (5.00 s to 36.00 s)", "30 s allowed"}},
      {"the detector's colour too late",
       [](LogTick& t) { t.intubation.detector_yellow = t.time_s > 27.9995; },
       {"yellow with breath 7, more than the 6 breaths allowed"}},
      {"a force that is no number",
       [](LogTick& t) {
         if (t.tick == 30000) t.intubation.loads_n[kTubeBlade] = std::nan("");
       },
       {"not a number at 30.00 s"}},
  };
  for (const auto& c : cases) {
    const Score s = score_of(c.change);
    EXPECT_FALSE(s.passed) << c.name;
    EXPECT_EQ(s.reasons.size(), 1u) << c.name << "\n" << joined(s.reasons);
    for (const std::string& part : c.says)
      EXPECT_NE(joined(s.reasons).find(part), std::string::npos) << c.name << ": " << joined(s.reasons);
  }
  EXPECT_TRUE(score_of([](LogTick& t) {  // exactly at the limits
                if (t.tick == 21000) t.intubation.spo2 = 0.70, t.intubation.heart_per_min = 100.0;
                if (t.tick == 14700) t.intubation.tip_load_n = 2.0;
                t.intubation.detector_yellow = t.time_s > 26.9995;
              })
                  .passed);
}

TEST(IntubationScore, WhatIsNotAskedForIsNotJudged) {
  Scenario s = scenario();
  s.intubation->pass = IntubationPass{};
  const Score score = score_of(
      [](LogTick& t) {
        t.intubation.spo2 = 0.2;
        t.intubation.heart_per_min = 40.0;
        t.intubation.tip_load_n = 7.0;
        t.intubation.detector_yellow = false;
      },
      s);
  EXPECT_TRUE(score.passed) << joined(score.reasons);
}

TEST(IntubationScore, ATrialThatNeverBeganHasNoAttempts) {
  const Score s = score_of(never_in([](LogTick& t) { t.proxy_pose.position_m = kOutside; }));
  EXPECT_FALSE(s.passed);
  EXPECT_TRUE(s.intubation->attempts.empty());
  EXPECT_EQ(s.intubation->decisive(), nullptr);
  EXPECT_FALSE(s.intubation->lowest_spo2_percent);
  TrialLog empty = log_of({}, 0.0);
  EXPECT_EQ(score_trial(empty, scenario()).intubation->outcome, Outcome::abandoned);
}

TEST(IntubationScoreJson, HasItsKeysAndNullWhereThereIsNothing) {
  const auto json_of = [](const TrialLog& log) {
    return QJsonDocument::fromJson(
               QByteArray::fromStdString(score_to_json(score_trial(log, scenario()), log, scenario())))
        .object();
  };
  const QJsonObject whole = json_of(log_of()), good = whole["intubation"].toObject();
  EXPECT_EQ(good["outcome"].toString(), "good-depth");
  EXPECT_NEAR(good["depth_percent"].toDouble(), 50.0, 1e-9);
  EXPECT_NEAR(good["time_to_view_s"].toDouble(), 4.0, 1e-9);
  EXPECT_NEAR(good["time_to_pass_s"].toDouble(), 5.0, 1e-9);
  EXPECT_NEAR(good["lowest_spo2_percent"].toDouble(), 80.0, 1e-9);
  EXPECT_EQ(good["attempts"].toArray().size(), 1);
  EXPECT_NEAR(good["attempts"].toArray()[0].toObject()["time_s"].toDouble(), 15.0, 1e-9);
  EXPECT_EQ(good["co2_breaths"].toInt(), 3);
  EXPECT_EQ(good["tip_against"].toString(), "cords");
  EXPECT_EQ(good["peak_loads_n"].toObject()["cricoid"].toObject()["value"].toDouble(), 2.5);
  EXPECT_TRUE(good["peak_loads_n"].toObject()["blade"].toObject()["at_s"].isNull());
  EXPECT_TRUE(good["depth_neutral_m"].isNull());
  EXPECT_EQ(whole["criteria"].toArray().size(), 15);

  const QJsonObject nothing =
      json_of(log_of(never_in([](LogTick& t) { t.proxy_pose.position_m = kOutside; })))["intubation"].toObject();
  for (const char* key :
       {"depth_m", "depth_percent", "depth_neutral_m", "time_to_view_s", "time_to_pass_s", "tip_against",
        "lowest_spo2_percent", "lowest_spo2_at_s", "lowest_heart_per_min", "co2_breaths"}) {
    EXPECT_TRUE(nothing.contains(key) && nothing[key].isNull()) << key;
  }
  EXPECT_EQ(nothing["outcome"].toString(), "abandoned");
  EXPECT_TRUE(nothing["attempts"].toArray().isEmpty());

  TrialLog laryngoscopy = log_of();
  laryngoscopy.header.has_intubation = false;
  for (LogTick& tick : laryngoscopy.ticks) tick.has_intubation = false;
  EXPECT_FALSE(json_of(laryngoscopy).contains("intubation"));
}

}  // namespace
}  // namespace vallecula::curricula
