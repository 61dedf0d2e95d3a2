// What an intubation is judged by, limit for limit, and what of it stands in score.json.
#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "tests/curricula/score/hand_made_intubation.h"

namespace vallecula::curricula {
namespace {

using namespace testing;

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
       {"Saturation fell to 69 % at 21.00 s", "70 % asked for"}},
      {"heart",
       [](LogTick& t) {
         if (t.tick == 19000) t.intubation.heart_per_min = 99.0;
       },
       {"The heart fell to 99 per minute at 19.00 s", "100 per minute asked for"}},
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

/// The rubric's sentence of this criterion.
std::string sentence_of(const Score& score, const std::string& name) {
  for (const Criterion& c : score.criteria)
    if (c.name == name) return c.sentence;
  return "";
}

TEST(IntubationScore, ATubeThatWasNeverTakenHasKeptNoLimit) {
  const TrialLog log = log_of(testing::never_in([](LogTick& t) { t.proxy_pose.position_m = testing::kOutside; }), 4.0);
  Scenario all = scenario();
  all.intubation->pass.oesophagus_in_time = all.intubation->pass.no_severe_desaturation = true;
  for (const char* name : {"tube_force_n", "oesophagus_in_time", "no_severe_desaturation", "peak_tongue_force_n"})
    EXPECT_NE(sentence_of(score_of({}, all), name), "") << name;
  const Score nothing = score_trial(log, all);
  for (const char* name : {"tube_force_n", "oesophagus_in_time", "no_severe_desaturation", "peak_tongue_force_n"})
    EXPECT_EQ(sentence_of(nothing, name), "") << name;
  EXPECT_NE(sentence_of(nothing, "outcome"), "");
  // A tube pushed in without a blade was tried.
  TrialLog blind = log;
  blind.ticks[2000].intubation.loads_n[kTubeTongue] = 0.5;
  EXPECT_NE(sentence_of(score_trial(blind, all), "tube_force_n"), "");
}

TEST(IntubationScore, SoLowASaturationHasNoFigureForAPerson) {
  const auto lowest = [](double spo2) {
    return sentence_of(score_of([=](LogTick& t) {
                         if (t.time_s > 20.0) t.intubation.spo2 = spo2;
                       }),
                       "lowest_spo2_percent");
  };
  EXPECT_EQ(lowest(0.30), "Saturation fell to 30 % at 20.00 s, less than the 70 % asked for");
  EXPECT_EQ(lowest(0.04), "Saturation fell to below 30 % at 20.00 s, less than the 70 % asked for");
  Scenario all = scenario();
  all.intubation->pass.no_severe_desaturation = true;
  const Score low = score_of([](LogTick& t) { t.intubation.spo2 = t.time_s > 20.0 ? 0.04 : 0.95; }, all);
  EXPECT_NEAR(*low.intubation->lowest_spo2_percent, 4.0, 1e-9) << "files keep what the model has";
  EXPECT_NE(sentence_of(low, "no_severe_desaturation").find("from 95 to below 30 %"), std::string::npos)
      << sentence_of(low, "no_severe_desaturation");
}

TEST(IntubationScore, WhatNeverFellIsNotSaidToHaveFallen) {
  const auto all_through = [](double spo2, double heart) {
    return [=](LogTick& t) {
      t.intubation.spo2 = spo2;
      t.intubation.heart_per_min = heart;
    };
  };
  const Score steady = score_of(all_through(0.98, 140.0));
  EXPECT_EQ(sentence_of(steady, "lowest_spo2_percent"),
            "Saturation stayed at 98 % or above, at least the 70 % asked for");
  EXPECT_EQ(sentence_of(steady, "lowest_heart_per_min"),
            "The heart stayed at 140 per minute or above, at least the 100 per minute asked for");
  // The attempt begins at 5 s with 95 %, which is 80 % from 20 s on; 140 a minute are 110 from 18 s on.
  const Score fell = score_of();
  EXPECT_EQ(sentence_of(fell, "lowest_spo2_percent"),
            "Saturation fell to 80 % at 20.00 s, at least the 70 % asked for");
  EXPECT_EQ(sentence_of(fell, "lowest_heart_per_min"),
            "The heart fell to 110 per minute at 18.00 s, at least the 100 per minute asked for");
  const Score by_a_beat = score_of([](LogTick& t) { t.intubation.heart_per_min = t.time_s < 10 ? 140.4 : 139.6; });
  EXPECT_EQ(sentence_of(by_a_beat, "lowest_heart_per_min"),
            "The heart stayed at 140 per minute or above, at least the 100 per minute asked for")
      << "no monitor shows parts of a beat";
  const Score low = score_of(all_through(0.62, 90.0));
  EXPECT_EQ(sentence_of(low, "lowest_spo2_percent"),
            "Saturation began at 62 % and fell no further, less than the 70 % asked for");
  EXPECT_EQ(sentence_of(low, "lowest_heart_per_min"),
            "The heart began at 90 per minute and fell no further, less than the 100 per minute asked for");
  const Score before = score_of([](LogTick& t) {  // until the blade goes in
    if (t.time_s < 4.9) t.intubation.spo2 = 0.60;
  });
  EXPECT_EQ(sentence_of(before, "lowest_spo2_percent"), sentence_of(fell, "lowest_spo2_percent"));
}

TEST(IntubationScore, PercentsAndBeatsAreWholeUnlessThatWouldHideAMiss) {
  const auto heart = [](double lowest) {
    return sentence_of(score_of([=](LogTick& t) {
                         if (t.tick == 19000) t.intubation.heart_per_min = lowest;
                       }),
                       "lowest_heart_per_min");
  };
  EXPECT_EQ(heart(100.4), "The heart fell to 100 per minute at 19.00 s, at least the 100 per minute asked for");
  EXPECT_EQ(heart(99.6), "The heart fell to 99.6 per minute at 19.00 s, less than the 100 per minute asked for");
  EXPECT_EQ(heart(99.96), "The heart fell to 99.96 per minute at 19.00 s, less than the 100 per minute asked for");
}

TEST(IntubationScore, RoundedAFigureStaysOnItsSideOfALimitWithParts) {
  Scenario s = scenario();
  s.intubation->pass.lowest_heart_per_min = 90.4;
  const auto heart = [&](double lowest) {
    return sentence_of(score_of(
                           [=](LogTick& t) {
                             if (t.tick == 19000) t.intubation.heart_per_min = lowest;
                           },
                           s),
                       "lowest_heart_per_min");
  };
  EXPECT_EQ(heart(90.47), "The heart fell to 90.5 per minute at 19.00 s, at least the 90.4 per minute asked for")
      << "not to 90, which would be a miss";
  EXPECT_EQ(heart(92.3), "The heart fell to 92 per minute at 19.00 s, at least the 90.4 per minute asked for");
}

TEST(IntubationScore, TheHeadNeutralPutsTheTipDeeperAndIsJudgedWhereAskedFor) {
  Scenario s = scenario();
  TrialLog log = log_of();
  log.header.settings[kHeadExtension] = 25.0;
  EXPECT_NEAR(*score_trial(log, s).intubation->depth_neutral_m, 0.029, 1e-12);
  TrialLog held = log;  // by an assistant, 10 degrees further, until the end
  held.ticks.back().buttons |= kLoggedExtension;
  EXPECT_NEAR(*score_trial(held, s).intubation->depth_neutral_m, 0.031, 1e-12);
  held.ticks.front().buttons |= kLoggedExtension;
  held.ticks.back().buttons = 0;
  EXPECT_NEAR(*score_trial(held, s).intubation->depth_neutral_m, 0.029, 1e-12) << "no longer at the end";
  s.intubation->pass.depth_neutral = true;
  EXPECT_TRUE(score_trial(log, s).passed) << "29 of 48 mm";
  const auto at_depth = [&](double depth_m) {
    TrialLog other = log_of([=](LogTick& t) {
      if (t.time_s >= 16) t.intubation.past_cords_m = depth_m;
    });
    other.header.settings[kHeadExtension] = 25.0;
    return score_trial(other, s);
  };
  EXPECT_TRUE(at_depth(0.02699).passed);
  const Score deep = at_depth(0.028);
  EXPECT_EQ(deep.intubation->outcome, Outcome::good_depth) << "as it lies";
  ASSERT_EQ(deep.reasons.size(), 1u) << joined(deep.reasons);
  EXPECT_EQ(deep.reasons[0],
            "With the head neutral the tube's tip lies about 33.0 mm past the cords, 69 % of the way to the carina: to "
            "be drawn back");
  s.intubation->pass.depth_neutral = false;
  EXPECT_TRUE(at_depth(0.028).passed) << "told, not judged";
}

TEST(IntubationScore, ATubeLongInTheOesophagusFailsWhereAskedFor) {
  Scenario s = scenario();
  s.intubation->breaths_to_confirm = 5;
  s.intubation->pass.oesophagus_in_time = true;
  const auto until = [](double until_s) {  // breaths at 22, 23, ... s, from 14 s on in the oesophagus
    return [until_s](LogTick& t) {
      if (between(t, 14, until_s)) t.intubation.place = LoggedPlace::oesophagus;
      t.intubation.detector_yellow = t.time_s > until_s + 3;
    };
  };
  s.intubation->pass.time_to_pass_s.reset();  // of the second way in
  EXPECT_TRUE(score_of(until(26.5), s).passed) << joined(score_of(until(26.5), s).reasons);
  const Score late = score_of(until(27.5), s);
  ASSERT_EQ(late.reasons.size(), 1u) << joined(late.reasons);
  EXPECT_EQ(late.reasons[0],
            "The tube in the oesophagus was recognised late: more than 5 breaths in one stay at 27.00 s");
  EXPECT_NE(joined(score_of({}, s).reasons).find("never in the oesophagus"), std::string::npos);
  s.intubation->pass.oesophagus_in_time = false;
  EXPECT_TRUE(score_of(until(27.5), s).passed);
}

TEST(IntubationScore, ASevereDesaturationFailsWhereAskedFor) {
  Scenario s = scenario();
  s.intubation->pass.no_severe_desaturation = true;
  const auto lowest = [](double spo2) {
    return [spo2](LogTick& t) {
      if (between(t, 20, 28)) t.intubation.spo2 = spo2;
    };
  };
  EXPECT_TRUE(score_of(lowest(0.76), s).passed) << "by 19 points, from 95 %";
  const Score severe = score_of(lowest(0.75), s);
  ASSERT_EQ(severe.reasons.size(), 1u) << joined(severe.reasons);
  EXPECT_EQ(severe.reasons[0],
            "In attempt 1 of 1, begun at 5.00 s, saturation fell by 20 points or more, from 95 to 75 %");
  EXPECT_TRUE(score_of(lowest(0.75)).passed);
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
  EXPECT_TRUE(good["main_bronchus"].isNull());
  TrialLog deep = log_of([](LogTick& t) {
    if (t.time_s > 16) t.intubation.place = LoggedPlace::main_bronchus, t.intubation.side = 0;
  });
  EXPECT_EQ(json_of(deep)["intubation"].toObject()["main_bronchus"].toString(), "right");
  TrialLog extended = log_of();
  extended.header.settings[kHeadExtension] = 25.0;
  EXPECT_NEAR(json_of(extended)["intubation"].toObject()["depth_neutral_percent"].toDouble(), 100.0 * 29 / 48, 1e-9);
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
