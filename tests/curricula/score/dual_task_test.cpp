#include "curricula/score/dual_task.h"

#include <gtest/gtest.h>

#include "tests/curricula/score/hand_made_intubation.h"

namespace vallecula::curricula {
namespace {

using namespace testing;
using Kind = LogEvent::Kind;
using Result = Reaction::Result;

/// 1: a question with three answers, the second right, 5 s. 2: an alarm, 4 s. 3: talk. 4: another question, 5 s.
Scenario asked() {
  Scenario s = scenario();
  Distraction question, alarm, talk;
  question.kind = Distraction::Kind::question;
  question.answers.resize(3);
  question.right_answer = 2;
  question.time_allowed_s = 5.0;
  alarm.kind = Distraction::Kind::alarm;
  alarm.time_allowed_s = 4.0;
  s.distractions = {question, alarm, talk, question};
  return s;
}

LogEvent event(double at_s, Kind kind, int distraction, int answer = 0) {
  return {static_cast<std::int64_t>(std::lround(at_s / kTick)), kind, distraction, answer};
}

DualTask of(std::vector<LogEvent> events, const Change& change = {}, double seconds = 40.0) {
  TrialLog log = log_of(change, seconds);
  log.header.has_events = true;
  log.events = std::move(events);
  return *score_trial(log, asked()).dual_task;
}

TEST(DualTask, RightWrongAndMissedEachWithItsReactionTime) {
  const DualTask d = of({event(6, Kind::shown, 1), event(8.5, Kind::answered, 1, 2), event(10, Kind::shown, 2),
                         event(11.5, Kind::silenced, 2), event(12, Kind::shown, 3), event(20, Kind::shown, 4),
                         event(23.0, Kind::answered, 4, 1)});
  ASSERT_EQ(d.reactions.size(), 3u) << "talk asks for nothing";
  EXPECT_EQ(d.reactions[0].result, Result::right);
  EXPECT_NEAR(*d.reactions[0].reaction_s, 2.5, 1e-9);
  EXPECT_NEAR(d.reactions[0].shown_at_s, 6.0, 1e-9);
  EXPECT_EQ(d.reactions[1].result, Result::right);
  EXPECT_NEAR(*d.reactions[1].reaction_s, 1.5, 1e-9);
  EXPECT_EQ(d.reactions[2].result, Result::wrong);
  EXPECT_EQ(d.right, 2);
  EXPECT_EQ(d.wrong, 1);
  EXPECT_EQ(d.missed, 0);
  EXPECT_EQ(d.errors(), 1);
  EXPECT_NEAR(*d.mean_reaction_s, (2.5 + 1.5 + 3.0) / 3, 1e-9);
}

TEST(DualTask, LateAndNeverAreMissed) {
  const DualTask d = of({event(6, Kind::shown, 1), event(10, Kind::shown, 2), event(11.001, Kind::answered, 1, 2)});
  EXPECT_EQ(d.missed, 2);
  EXPECT_EQ(d.right + d.wrong + d.false_answers, 0) << "late is missed, and no error on top";
  EXPECT_FALSE(d.mean_reaction_s);
  EXPECT_EQ(of({event(6, Kind::shown, 1), event(11.0, Kind::answered, 1, 2)}).right, 1) << "5 s to the tick are in time";
}

TEST(DualTask, APauseStopsTheReactionsClock) {
  const Change gone = [](LogTick& t) {
    if (between(t, 7, 17)) t.device_valid = false;
  };
  const DualTask d = of({event(6, Kind::shown, 1), event(18, Kind::answered, 1, 2)}, gone);
  EXPECT_EQ(d.right, 1);
  EXPECT_NEAR(*d.mean_reaction_s, 2.0, 1e-9);
}

TEST(DualTask, WhatTheTrialsEndCutsOffCountsForNothing) {
  const DualTask d = of({event(36, Kind::shown, 1)});
  ASSERT_EQ(d.reactions.size(), 1u);
  EXPECT_EQ(d.reactions[0].result, Result::open);
  EXPECT_EQ(d.missed, 0);
}

TEST(DualTask, OddEventsAreFalseAnswersAndSpoilNothing) {
  const auto with = [](const std::vector<LogEvent>& odd) {
    std::vector<LogEvent> events = {event(6, Kind::shown, 1), event(8, Kind::answered, 1, 2)};
    events.insert(events.end(), odd.begin(), odd.end());
    std::stable_sort(events.begin(), events.end(), [](const auto& a, const auto& b) { return a.tick < b.tick; });
    const DualTask d = of(events);
    EXPECT_EQ(d.right, 1);
    EXPECT_NEAR(*d.mean_reaction_s, 2.0, 1e-9);
    return d.false_answers;
  };
  EXPECT_EQ(with({}), 0);
  EXPECT_EQ(with({event(9, Kind::answered, 1, 1)}), 1) << "answered twice: the first counts";
  EXPECT_EQ(with({event(5, Kind::answered, 1, 2)}), 1) << "before it was shown";
  EXPECT_EQ(with({event(7, Kind::answered, 1, 9)}), 1) << "an answer it does not offer";
  EXPECT_EQ(with({event(7, Kind::answered, 1, 0)}), 1) << "no answer at all";
  EXPECT_EQ(with({event(7, Kind::silenced, 1)}), 1) << "a question cannot be silenced";
  EXPECT_EQ(with({event(7, Kind::silenced, 2)}), 1) << "an alarm that did not ring";
  EXPECT_EQ(with({event(7, Kind::shown, 3), event(7.5, Kind::answered, 3, 1)}), 1) << "talk";
  EXPECT_EQ(with({event(7, Kind::answered, 77, 1)}), 1) << "not in the scenario";
  EXPECT_EQ(with({event(7, Kind::shown, 77), event(7, Kind::shown, 1)}), 0) << "shown twice, or unknown: passed over";
}

TEST(DualTask, AScenarioWithoutDistractionsHasNone) {
  EXPECT_FALSE(score_of().dual_task);
  TrialLog log = log_of();
  EXPECT_FALSE(score_trial(log, asked()).dual_task) << "a log without events, of an older program";
}

}  // namespace
}  // namespace vallecula::curricula
