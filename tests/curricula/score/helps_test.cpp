// Helps and an instructor's changes: told, and what they do to the verdict.
#include "curricula/score/helps.h"

#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "curricula/score/points.h"
#include "tests/curricula/score/hand_made_intubation.h"

namespace vallecula::curricula {
namespace {

using testing::between;
using testing::joined;
using testing::log_of;
using testing::scenario;
using testing::score_of;

QJsonObject json_of(const TrialLog& log, const Score& score) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(score_to_json(score, log, scenario()))).object();
}

TEST(Helps, OwnHeadAndExtensionAreToldAndJudgeNothing) {
  const auto change = [](LogTick& t) {
    if (between(t, 8, 9)) t.buttons |= kLoggedEyeLeft;
    if (between(t, 8.5, 10)) t.buttons |= kLoggedEyeUp;  // half a second of both: the eye stood aside for 2 s
    if (between(t, 12, 12.25) || between(t, 13, 14)) t.buttons |= kLoggedExtension;
    if (between(t, 13.5, 14)) t.device_valid = false;  // nothing is asked for in a pause
  };
  const TrialLog log = log_of(change);
  const Score s = score_trial(log, scenario()), plain = score_of();
  EXPECT_EQ(s.eye_moves.times, 2) << "left, then up as well";
  EXPECT_NEAR(s.eye_moves.for_s, 2.0, 1e-9);
  EXPECT_NEAR(s.eye_moves.first_s, 8.0, 1e-9);
  EXPECT_EQ(s.extension.times, 2);
  EXPECT_NEAR(s.extension.for_s, 0.75, 1e-9);
  EXPECT_TRUE(s.set_aside.empty());
  EXPECT_TRUE(s.counts());
  EXPECT_EQ(s.passed, plain.passed);
  const QJsonObject o = json_of(log, s);
  EXPECT_EQ(o["eye_moves"].toObject()["times"].toInt(), 2);
  EXPECT_NEAR(o["head_extension"].toObject()["for_s"].toDouble(), 0.75, 1e-9);
  EXPECT_TRUE(o["set_aside"].toArray().isEmpty());
  EXPECT_TRUE(json_of(log_of(), plain)["eye_moves"].toObject()["first_s"].isNull());
}

TEST(Helps, AnExpertShownAndALineToldAreToldAndJudgeNothing) {
  const TrialLog log = log_of([](LogTick& t) {
    if (between(t, 8, 11)) t.buttons |= kLoggedAided, t.device_valid = false;  // the trial waits for the expert's loop
    if (between(t, 13, 14)) t.buttons |= kLoggedAided;                         // a line
  });
  TrialLog unaided = log;
  for (LogTick& t : unaided.ticks) t.buttons = 0;
  const Score s = score_trial(log, scenario()), plain = score_trial(unaided, scenario());
  EXPECT_EQ(s.aided.times, 2);
  EXPECT_NEAR(s.aided.for_s, 4.0, 1e-9) << "the pause as well";
  EXPECT_NEAR(s.aided.first_s, 8.0, 1e-9);
  EXPECT_TRUE(s.counts()) << "a help of practice, as the others are";
  EXPECT_EQ(s.passed, plain.passed);
  EXPECT_EQ(plain.aided.times, 0);
  EXPECT_EQ(json_of(log, s)["shown_or_told"].toObject()["times"].toInt(), 2);
}

TEST(Helps, WhatAnInstructorChangedCountsNeitherWay) {
  const struct {
    std::uint32_t bit;
    const char* said;
  } cases[] = {{1u << 26, "the infant's vital signs from 12.30 s"},
               {1u << 27, "the infant's vital signs from 12.30 s"},
               {1u << 28, "the infant's vital signs from 12.30 s"},
               {1u << 29, "the infant's vital signs from 12.30 s"},
               {1u << 30, "the vocal cords from 12.30 s"}};
  for (const auto& c : cases) {
    const TrialLog log = log_of([&](LogTick& t) {
      if (between(t, 12.3, 14)) t.buttons |= c.bit;
    });
    const Score s = score_trial(log, scenario());
    EXPECT_FALSE(s.counts());
    ASSERT_FALSE(s.reasons.empty());
    EXPECT_NE(s.reasons.front().find(c.said), std::string::npos) << joined(s.reasons);
    const QJsonObject o = json_of(log, s);
    EXPECT_EQ(o["set_aside"].toArray().size(), 1);
  }
  // The earlier of two; and of a trial without an infant nothing was changed.
  const auto both = [](LogTick& t) {
    if (between(t, 9, 10)) t.buttons |= 1u << 28;
    if (between(t, 7, 8)) t.buttons |= 1u << 26;
  };
  EXPECT_NE(joined(score_of(both).reasons).find("vital signs from 7.00 s"), std::string::npos);
  TrialLog blade = log_of(both);
  blade.header.has_intubation = false;
  for (LogTick& t : blade.ticks) t.has_intubation = false;
  Scenario s = scenario();
  s.intubation.reset();
  EXPECT_TRUE(score_trial(blade, s).counts());
}

TEST(Helps, BegunAtTheValleculaIsScoredFromWhereTheHandTookOver) {
  TrialLog log = log_of([](LogTick& t) {
    if (between(t, 6, 6.5)) t.loads[kTongue].force_n = {0, 9, 0};    // the plan's doing
    if (between(t, 10, 10.5)) t.loads[kTongue].force_n = {0, 4, 0};  // the hand's
    if (between(t, 2, 3)) t.device_valid = false;                    // a pause leads nobody anywhere
  });
  log.header.settings[kLeadInTicks] = 7000;  // from 0 to 8 s, of which one is a pause
  log.footer.pause_faults = {"unplugged"};
  const Score s = score_trial(log, scenario());
  EXPECT_TRUE(s.at_vallecula);
  EXPECT_FALSE(s.counts());
  EXPECT_NEAR(s.attempt_start_s, 8.0, 1e-9);
  EXPECT_EQ(s.peak_tongue_force_n, 4.0);
  ASSERT_EQ(s.pauses.size(), 1u);
  EXPECT_EQ(s.pauses[0].fault, "unplugged");
  EXPECT_NE(s.reasons.front().find("Begun at the vallecula"), std::string::npos);
  for (const Criterion& c : s.criteria) {
    EXPECT_NE(c.name, "attempt_time_s");
    EXPECT_NE(c.name, "time_to_pass_s");
  }
  EXPECT_TRUE(points_of(s, scenario()).empty()) << "half of the way has no whole score";
  EXPECT_FALSE(points_of(score_of(), scenario()).empty());
  EXPECT_TRUE(json_of(log, s)["at_vallecula"].toBool());
  // Ended while it was still led: nothing to judge, and no fall over the end.
  log.header.settings[kLeadInTicks] = 1e9;
  EXPECT_EQ(score_trial(log, scenario()).ticks, 1);
}

/// Nothing entered the mouth, and the trial was ended so.
TrialLog never_begun(const char* ended) {
  TrialLog log = log_of(testing::never_in([](LogTick& t) { t.proxy_pose.position_m = testing::kOutside; }), 4.0);
  log.footer.ended = ended;
  return log;
}

TEST(Helps, AStartWithoutAnAttemptCountsNeitherWay) {
  for (const char* ended : {"reset", "ended by trainee"}) {
    const TrialLog log = never_begun(ended);
    const Score s = score_trial(log, scenario());
    EXPECT_TRUE(s.no_attempt) << ended;
    EXPECT_FALSE(s.counts()) << ended;
    ASSERT_EQ(s.set_aside.size(), 1u);
    EXPECT_EQ(s.reasons.front(), s.set_aside.front());
    EXPECT_NE(s.set_aside.front().find("Neither blade nor tube entered the mouth: no attempt"), std::string::npos);
    EXPECT_TRUE(json_of(log, s)["no_attempt"].toBool());
  }
  // What was let run until its time was over, or by a script, is judged: nobody drew back from it.
  for (const char* ended : {"the scenario's time was over", "finished"}) {
    const Score s = score_trial(never_begun(ended), scenario());
    EXPECT_FALSE(s.no_attempt) << ended;
    EXPECT_TRUE(s.counts()) << ended;
    EXPECT_FALSE(s.passed) << ended;
  }
}

TEST(Helps, ATipInTheMouthAnAssessmentOrAMouthThatIsNotKnownCounts) {
  TrialLog blade = never_begun("reset"), tube = blade, unknown = blade;
  blade.ticks[2000].proxy_pose.position_m = testing::kInMouth;
  EXPECT_TRUE(score_trial(blade, scenario()).counts()) << "a tick in the mouth is an attempt";
  tube.ticks[2000].intubation.place = LoggedPlace::mouth;
  EXPECT_TRUE(score_trial(tube, scenario()).counts());
  Scenario assessment = scenario();
  assessment.attempt.mode = Mode::assessment;
  EXPECT_TRUE(score_trial(never_begun("ended by trainee"), assessment).counts()) << "what was begun as one counts";
  unknown.header.landmarks_m.erase("vallecula");
  const Score s = score_trial(unknown, scenario());
  EXPECT_TRUE(s.counts()) << "as before";
  EXPECT_TRUE(s.mouth_unknown);
  TrialLog harm = never_begun("ended by trainee");
  harm.ticks[2000].loads[kGum].force_n = {0.0, 0.0, scenario().pass.peak_gum_force_n + 1.0};
  EXPECT_TRUE(score_trial(harm, scenario()).counts()) << "a gum that was pressed from outside is not made undone";
  TrialLog long_press = never_begun("ended by trainee");
  const double over_n = 0.5 * (scenario().targets.tongue_force_n + scenario().pass.peak_tongue_force_n);
  for (LogTick& tick : long_press.ticks) tick.loads[kTongue].force_n = {0.0, 0.0, over_n};
  const Score pressed = score_trial(long_press, scenario());
  ASSERT_LT(over_n, scenario().pass.peak_tongue_force_n);
  ASSERT_GT(pressed.time_over_target_s, scenario().pass.time_over_target_s);
  EXPECT_TRUE(pressed.counts()) << "nor is the time over the target";
  TrialLog cut_off = never_begun("ended by trainee");
  cut_off.footer.complete = false;
  EXPECT_FALSE(score_trial(cut_off, scenario()).no_attempt) << "that is interrupted";
}

}  // namespace
}  // namespace vallecula::curricula
