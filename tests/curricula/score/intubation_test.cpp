// Outcomes, attempts and figures of hand-made intubations.
#include <gtest/gtest.h>

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "curricula/score/figures.h"
#include "tests/curricula/score/hand_made_intubation.h"

namespace vallecula::curricula {
namespace {

using namespace testing;

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
      {"drawn back from the cricoid, and given up", pushed(27, 30.5, kTubeCricoid, 0.8), Outcome::cricoid_too_narrow},
      {"drawn back from the cricoid, and then elsewhere", pushed(15, 29.9, kTubeCricoid, 0.8), Outcome::abandoned},
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
         t.intubation.tip_load_n = 2.0;
       },
       Outcome::too_shallow},
      {"its bevel reaches past the cricoid it stands in",
       [](LogTick& t) {
         t.intubation.past_cords_m = std::min(t.intubation.past_cords_m, 0.0095);
         if (t.time_s < 30) return;
         t.intubation.place = LoggedPlace::trachea;
         t.intubation.tip_against = t.time_s < 45 ? kTubeCricoid : kTubeTrachea;
         t.intubation.tip_load_n = t.time_s < 45 ? 2.5 : 1.0;
       },
       Outcome::cricoid_too_narrow},
      {"its bevel is wedged between closed cords",
       [](LogTick& t) {
         pushed(15, 50, kTubeCords, 0.0)(t);
         t.intubation.past_cords_m = 0.003;
       },
       Outcome::cords_closed},
      {"in by much more than its bevel, it presses on the trachea",
       [](LogTick& t) {
         if (t.time_s < 30) return;
         t.intubation.tip_against = t.time_s < 31 ? kTubeCricoid : kTubeTrachea;
         t.intubation.past_cords_m = t.time_s < 31 ? 0.010 : 0.025;
         t.intubation.tip_load_n = 2.0;
       },
       Outcome::good_depth},
      {"what a tube that fits takes at the cricoid is no stop",
       [](LogTick& t) {
         pushed(15, 38, kTubeCricoid, 0.8)(t);
         t.intubation.tip_load_n *= 0.75;  // 1.5 N (engine/README.md)
       },
       Outcome::abandoned},
      {"let go by cords that open, it knocks on the cricoid and lies there",
       [](LogTick& t) {
         pushed(15, 50, kTubeCricoid, 0.8)(t);
         if (!between(t, 35, 35.05)) t.intubation.tip_load_n = 1.5;
       },
       Outcome::too_shallow},
      {"a touch of the cricoid by a tube that then lies in the larynx",
       [](LogTick& t) {
         pushed(15, 50, kTubeCricoid, 0.8)(t);
         if (t.time_s > 29) t.intubation.tip_load_n = 0.0;
       },
       Outcome::too_shallow},
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
      EXPECT_NE(joined(s.reasons).find("; asked for: good depth"), std::string::npos) << c.name << joined(s.reasons);
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

TEST(IntubationScore, ATubePassedWithTheBladeOutIsTimedAllTheSame) {
  const auto passed_at = [](double at_s) {
    return [at_s](LogTick& t) {
      t.intubation.place = t.time_s < at_s - kTick / 2 ? LoggedPlace::mouth : LoggedPlace::trachea;
      t.intubation.past_cords_m = t.time_s < at_s - kTick / 2 ? 0.0 : 0.024;
      t.intubation.detector_yellow = t.time_s > at_s + 3;
    };
  };
  const Score soon = score_of(passed_at(24));
  EXPECT_NEAR(*soon.intubation->attempts[0].time_to_pass_s, 15.0, 1e-9) << "from the view at 9 s";
  EXPECT_TRUE(soon.passed) << joined(soon.reasons);
  EXPECT_NE(joined(soon.reasons).find("it took 15.00 s at 24.00 s, with the blade out already"), std::string::npos)
      << joined(soon.reasons);
  const Score late = score_of(passed_at(29.5));
  ASSERT_EQ(late.reasons.size(), 1u) << joined(late.reasons);
  EXPECT_NE(late.reasons[0].find("it took 20.50 s at 29.50 s"), std::string::npos) << late.reasons[0];
  // Before the blade: nothing can be timed, and it is not under sight.
  const Score before = score_of(passed_at(2));
  EXPECT_FALSE(before.intubation->attempts[0].time_to_pass_s);
  EXPECT_TRUE(before.intubation->passed_untimed());
  EXPECT_EQ(before.intubation->outcome, Outcome::good_depth);
  ASSERT_EQ(before.reasons.size(), 1u) << joined(before.reasons);
  EXPECT_EQ(before.reasons[0], "The cords were passed before the blade was in the mouth, so not under sight");
  EXPECT_FALSE(score_of(never_in()).intubation->passed_untimed());
  EXPECT_FALSE(soon.intubation->passed_untimed());
}

TEST(IntubationScore, TellsWhichMainBronchusTheTubeIsIn) {
  for (const int side : {0, 1, -1}) {
    const TrialLog log = log_of([side](LogTick& t) {
      if (t.time_s < 16) return;
      t.intubation.place = LoggedPlace::main_bronchus;
      t.intubation.side = static_cast<std::int8_t>(side);
    });
    const IntubationScore i = *score_trial(log, scenario()).intubation;
    EXPECT_EQ(i.outcome, Outcome::mainstem);
    EXPECT_EQ(i.bronchus_side, side);
    EXPECT_EQ(outcome_in_words(i), std::string("The tube's tip lies in ") +
                                       (side == 0   ? "the right main bronchus"
                                        : side == 1 ? "the left main bronchus"
                                                    : "a main bronchus") +
                                       ": only one lung gets air");
  }
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
  EXPECT_NEAR(late.intubation->recognised_late_at_s, 26.0, 1e-9);
  const Score to_the_end = score_of(there(50), s);
  EXPECT_NEAR(to_the_end.intubation->oesophagus_s, 18.0, 1e-9);
  EXPECT_EQ(to_the_end.intubation->outcome, Outcome::oesophagus);
  EXPECT_FALSE(to_the_end.intubation->oesophagus_in_time());
  EXPECT_FALSE(late.intubation->oesophagus_in_time());
  EXPECT_TRUE(in_time.intubation->oesophagus_in_time());
  s.intubation->breaths_to_confirm = 1000;
  const Score never_drawn = score_of(there(50), s);
  EXPECT_FALSE(never_drawn.intubation->recognised_late) << "few breaths for what was allowed";
  EXPECT_FALSE(never_drawn.intubation->oesophagus_in_time()) << "and yet nobody has recognised it";
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

TEST(IntubationScore, TheMarkAtTheLipsIsTheTubesAtTheEndAndItsRuleIsTheWeightAndSix) {
  const auto at_end = [](LoggedInHand held, double mark_m) {
    return score_of([=](LogTick& t) {
      t.intubation.at_mouth_m = t.time_s < 39.0 ? 0.11 : mark_m;
      t.intubation.in_hand = held;
    });
  };
  const Score s = at_end(LoggedInHand::tube, 0.091);
  ASSERT_TRUE(s.intubation->at_lips_m);
  EXPECT_DOUBLE_EQ(*s.intubation->at_lips_m, 0.091);
  EXPECT_NEAR(s.intubation->lips_rule_m, 0.092, 1e-12) << "3.2 kg";
  Scenario small = scenario();
  small.manikin.weight_kg = 1.2;
  EXPECT_NEAR(score_of({}, small).intubation->lips_rule_m, 0.072, 1e-12);
  EXPECT_FALSE(at_end(LoggedInHand::catheter, 0.091).intubation->at_lips_m) << "that is no tube";
  EXPECT_FALSE(at_end(LoggedInHand::tube, 0.0).intubation->at_lips_m) << "it is out";
  TrialLog old = log_of([](LogTick& t) { t.intubation.at_mouth_m = 0.091; });
  old.header.settings.erase(kLipsBeforeGums);
  EXPECT_FALSE(score_trial(old, scenario()).intubation->at_lips_m) << "it was read at the gums then";
  const auto json = QJsonDocument::fromJson(QByteArray::fromStdString(score_to_json(s, log_of(), scenario())))
                        .object()["intubation"]
                        .toObject();
  EXPECT_DOUBLE_EQ(json["at_lips_m"].toDouble(), 0.091);
  EXPECT_NEAR(json["at_lips_by_weight_m"].toDouble(), 0.092, 1e-12);
  EXPECT_NEAR(find_figure("tube_at_lips_cm")->value(s).value(), 9.1, 1e-9);
}

TEST(IntubationScore, ATrialThatNeverBeganHasNoAttempts) {
  const Score s = score_of(never_in([](LogTick& t) { t.proxy_pose.position_m = kOutside; }));
  EXPECT_FALSE(s.passed);
  EXPECT_TRUE(s.intubation->attempts.empty());
  // What was not begun has kept no limit of attempts: beside "the attempt never began" there is no line that is met.
  EXPECT_TRUE(std::none_of(s.criteria.begin(), s.criteria.end(), [](const Criterion& c) {
    return c.name == "attempts";
  })) << joined(s.reasons);
  EXPECT_EQ(s.intubation->decisive(), nullptr);
  EXPECT_FALSE(s.intubation->lowest_spo2_percent);
  TrialLog empty = log_of({}, 0.0);
  EXPECT_EQ(score_trial(empty, scenario()).intubation->outcome, Outcome::abandoned);
}

}  // namespace
}  // namespace vallecula::curricula
