// Distractions come at their time by the trial's clock, one answer counts, and all of it stands in the log.
#include "gui/session/dual_task.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "gui/commands/headless_application.h"
#include "gui/session/device_choice.h"
#include "gui/session/replay.h"
#include "gui/session/trial_session.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/busy_course.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

using curricula::Distraction;
using curricula::LogEvent;
using LogKind = LogEvent::Kind;

std::vector<Distraction> three() {
  Distraction question, alarm, talk;
  question.kind = Distraction::Kind::question;
  question.at_s = 1.0;
  question.answers = {"a", "b", "c"};
  question.right_answer = 2;
  question.time_allowed_s = 10.0;
  alarm.kind = Distraction::Kind::alarm;
  alarm.at_s = 2.0;
  alarm.time_allowed_s = 5.0;
  talk.at_s = 3.0;
  return {question, alarm, talk};
}

std::vector<int> open_of(const DualTask& task) {
  std::vector<int> open;
  for (const auto& one : task.open()) open.push_back(one.distraction);
  return open;
}

TEST(DualTask, EachComesAtItsTimeAndGoesAfterItsOwn) {
  DualTask task(three());
  EXPECT_TRUE(task.advance(0, 0.0).empty());
  EXPECT_TRUE(task.advance(999, 0.999).empty());
  const auto first = task.advance(1000, 1.0);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].tick, 1000);
  EXPECT_EQ(first[0].kind, LogKind::shown);
  EXPECT_EQ(first[0].distraction, 1);
  EXPECT_TRUE(task.advance(1001, 1.0).empty()) << "the trial's clock stands, and nothing is shown twice";
  EXPECT_NEAR(task.open().at(0).left_s, 10.0, 1e-12);
  EXPECT_EQ(task.advance(5000, 3.5).size(), 2u) << "what was due between";
  EXPECT_EQ(open_of(task), (std::vector<int>{1, 2, 3}));
  EXPECT_NEAR(task.open().at(0).left_s, 7.5, 1e-12);
  EXPECT_TRUE(task.advance(9000, 8.6).empty());
  EXPECT_EQ(open_of(task), (std::vector<int>{1, 3})) << "the alarm stops after its five seconds from 3.5 s on";
  EXPECT_TRUE(task.advance(11500, 11.1).empty());
  EXPECT_TRUE(task.open().empty());
}

TEST(DualTask, TheFirstAnswerCountsAndOnlyWhatFits) {
  DualTask task(three());
  task.answer(1, 2);  // not asked yet
  EXPECT_TRUE(task.advance(10, 0.01).empty());
  task.advance(3000, 3.0);
  task.answer(4, 1);
  task.answer(1, 4);
  task.answer(2, 1);
  task.silence(1);
  task.silence(3);
  EXPECT_TRUE(task.advance(3001, 3.001).empty()) << "none of these can be answered so";
  task.answer(1, 3);
  task.answer(1, 2);
  task.silence(2);
  EXPECT_EQ(open_of(task), (std::vector<int>{3})) << "gone at once for the eye";
  const auto events = task.advance(3005, 3.005);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].kind, LogKind::answered);
  EXPECT_EQ(events[0].distraction, 1);
  EXPECT_EQ(events[0].answer, 3);
  EXPECT_EQ(events[0].tick, 3005);
  EXPECT_EQ(events[1].kind, LogKind::silenced);
  task.begin(false);
  EXPECT_TRUE(task.open().empty());
  EXPECT_EQ(task.advance(1000, 1.0).size(), 1u) << "anew";
}

TEST(DualTask, AnAnswerToNothingOpenIsOfTheLastThatWasShown) {
  DualTask task(three());
  task.answer(0, 1);
  task.silence(0);
  EXPECT_TRUE(task.advance(10, 0.01).empty()) << "nothing was shown yet";
  task.advance(1000, 1.0);
  task.silence(0);
  task.answer(0, 9);
  const auto events = task.advance(1100, 1.1);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].kind, LogKind::silenced);
  EXPECT_EQ(events[0].distraction, 1);
  EXPECT_EQ(events[0].tick, 1100);
  EXPECT_EQ(events[1].kind, LogKind::answered);
  EXPECT_EQ(events[1].answer, 9);
  EXPECT_EQ(open_of(task), std::vector<int>{1}) << "the question waits for its answer as before";
  task.silence(0);
  task.begin(false);
  EXPECT_EQ(task.advance(1000, 1.0).size(), 1u) << "anew";
}

TEST(DualTask, AScriptAnswersRightlyInTime) {
  DualTask task(three());
  task.begin(true);
  std::vector<LogEvent> all;
  for (int tick = 0; tick <= 20000; ++tick)
    for (const LogEvent& event : task.advance(tick, 0.001 * tick)) all.push_back(event);
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const LogEvent& e) { return e.kind == LogKind::shown; }), 3);
  for (const LogEvent& event : all) {
    if (event.kind == LogKind::answered) {
      EXPECT_EQ(event.answer, 2);
      EXPECT_NEAR(event.tick, 4000, 1);
    }
    if (event.kind == LogKind::silenced) {
      EXPECT_NEAR(event.tick, 4000, 1);
    }
  }
  EXPECT_TRUE(answers_distractions("scripted:expert"));
  EXPECT_FALSE(answers_distractions("scripted:novice"));
  EXPECT_FALSE(answers_distractions("mouse"));
}

TEST(DualTask, TwoThreadsLoseNoAnswer) {
  std::vector<Distraction> many(200, three()[0]);
  for (std::size_t i = 0; i < many.size(); ++i) many[i].at_s = 0.001 * static_cast<double>(i);
  DualTask task(many);
  std::atomic<bool> over{false};
  std::thread window([&] {
    while (!over)
      for (const auto& open : task.open()) task.answer(open.distraction, 1 + open.distraction % 3);
  });
  std::vector<LogEvent> answered;
  for (int tick = 0; answered.size() < many.size() && tick < 2000000; ++tick)
    for (const LogEvent& event : task.advance(tick, std::min(1.0, 0.001 * tick)))
      if (event.kind == LogKind::answered) answered.push_back(event);
  over = true;
  window.join();
  ASSERT_EQ(answered.size(), many.size());
  std::vector<bool> seen(many.size() + 1, false);
  for (const LogEvent& event : answered) {
    EXPECT_FALSE(seen[static_cast<std::size_t>(event.distraction)]);
    seen[static_cast<std::size_t>(event.distraction)] = true;
    EXPECT_EQ(event.answer, 1 + event.distraction % 3);
  }
}

class DualTaskTrial : public ::testing::Test {
 protected:
  DualTaskTrial() { ::setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  TrialSetup setup(const std::string& device, bool realtime = false) {
    TrialSetup setup;
    setup.patient = write_block_patient(box_.folder());
    setup.curriculum = write_busy_course(box_.folder());
    setup.scenario = "busy";
    setup.device = device;
    setup.out = box_ / "out";
    setup.realtime = realtime;
    return setup;
  }
  static curricula::TrialLog run(TrialSession& session, const std::function<void()>& meanwhile = {}) {
    session.start();
    for (int i = 0; i < 60000 && !session.finished(); ++i) {
      if (meanwhile) meanwhile();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return curricula::read_trial_log(session.finish("ended").log);
  }
  HeadlessApplication application_;
  Sandbox box_;
};

TEST_F(DualTaskTrial, HeadlessTheLogSaysWhatWasShownAndTheReplayIsTheSame) {
  TrialSession session(setup("scripted:" + write_press(box_.folder()).string()));
  const curricula::TrialLog log = run(session);
  EXPECT_TRUE(log.header.has_events);
  ASSERT_EQ(log.events.size(), 3u) << "a script of a file answers nothing";
  const std::int64_t due[3] = {300, 500, 600};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(log.events[i].kind, LogKind::shown);
    EXPECT_EQ(log.events[i].distraction, i + 1);
    EXPECT_NEAR(static_cast<double>(log.events[i].tick), static_cast<double>(due[i]), 1.0);
  }
  const RecordedScene scene = recorded_scene(log, box_ / "out", {});
  EXPECT_EQ(verify_trial(log, scene.description, {}).difference.field, "");
}

TEST_F(DualTaskTrial, ThePauseOfADeviceDelaysThem) {
  const std::string down = ",0,0.70710678118654752,-0.70710678118654752,0\n";
  write_text(box_ / "fails.csv",
             "# fault communication_lost 0.4 0.4\n0,0,0.005,0.02" + down + "2.5,0,0.005,0.02" + down);
  TrialSession session(setup("scripted:" + (box_ / "fails.csv").string()));
  const curricula::TrialLog log = run(session, [&] { session.confirm(); });
  ASSERT_EQ(log.events.size(), 3u);
  std::int64_t paused = 0;
  for (const curricula::LogTick& tick : log.ticks) {
    if (tick.tick > log.events[2].tick) break;
    paused += curricula::paused(tick) ? 1 : 0;
  }
  EXPECT_GE(paused, 399) << "the device was away for 0.4 s";
  EXPECT_NEAR(static_cast<double>(log.events[2].tick - paused), 600.0, 1.0);
  EXPECT_NEAR(static_cast<double>(log.events[0].tick), 300.0, 1.0);
}

class DualTaskTrialRealTime : public DualTaskTrial {};

TEST_F(DualTaskTrialRealTime, AnswersFromAnotherThreadStandAtTheTickTheyCame) {
  TrialSession session(setup("scripted:" + write_press(box_.folder()).string(), true));
  std::int64_t answered_about = 0;
  const curricula::TrialLog log = run(session, [&] {
    for (const auto& open : session.dual_task().open()) {
      if (open.distraction == 1 && answered_about == 0 && open.left_s < open.of_s - 0.15) {
        answered_about = session.latest().ticks;
        session.dual_task().answer(1, 3);
      }
      if (open.distraction == 2) session.dual_task().silence(2);
    }
  });
  ASSERT_EQ(log.events.size(), 5u);
  const auto of = [&](LogKind kind, int distraction) {
    return *std::find_if(log.events.begin(), log.events.end(),
                         [&](const LogEvent& e) { return e.kind == kind && e.distraction == distraction; });
  };
  EXPECT_EQ(of(LogKind::answered, 1).answer, 3);
  EXPECT_GE(of(LogKind::answered, 1).tick, of(LogKind::shown, 1).tick + 150);
  // How late the recorder's thread gets its turn is the machine's; the bound is a tenth of a second.
  EXPECT_NEAR(static_cast<double>(of(LogKind::answered, 1).tick), static_cast<double>(answered_about), 100.0);
  EXPECT_GE(of(LogKind::silenced, 2).tick, of(LogKind::shown, 2).tick);
  EXPECT_LT(of(LogKind::silenced, 2).tick, of(LogKind::shown, 2).tick + 100);
}

}  // namespace
}  // namespace vallecula::gui::test
