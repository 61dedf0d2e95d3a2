// A trial computed anew for the eye: the film of it, what happened when, and how it is opened.
#include "gui/session/replay_film.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "engine/haptics/runner.h"
#include "gui/commands/headless_application.h"
#include "gui/session/log_conversion.h"
#include "gui/session/replay.h"
#include "gui/session/replay_events.h"
#include "gui/session/replay_trial.h"
#include "gui/session/trial_session.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;
using Kind = ReplayEvent::Kind;

TEST(FilmPlan, GivesThirtyFramesASecondOrAsManyAsFit) {
  const FilmPlan plan = plan_film(10000, 0.001, 1000, std::size_t{1} << 30);
  EXPECT_EQ(plan.every_ticks, 33);
  EXPECT_EQ(plan.frames, 304u) << "ticks 0, 33, ... 9999";
  EXPECT_EQ(plan.bytes, 304000u);
  // Ten minutes of a patient of 60 kB a frame within half a gigabyte: fewer frames, never more memory.
  const FilmPlan tight = plan_film(600000, 0.001, 60000, kFilmBytes);
  EXPECT_LE(tight.bytes, kFilmBytes);
  EXPECT_GT(tight.bytes, kFilmBytes - kFilmBytes / 20) << "what is allowed is used";
  EXPECT_EQ(tight.frames, (600000u - 1) / static_cast<std::size_t>(tight.every_ticks) + 1);
  EXPECT_LT(tight.every_ticks, 70) << "still 14 frames a second";
  EXPECT_EQ(plan_film(1, 0.001, 60000, 1).frames, 1u);
  EXPECT_EQ(plan_film(0, 0.001, 60000, kFilmBytes).frames, 0u);
}

/// A trial of 1.2 s on the block, as fast as it goes: one for all.
class ReplayedTrial : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    application_ = std::make_unique<HeadlessApplication>();
    box_ = std::make_unique<Sandbox>();
    ::setenv("VALLECULA_HOME", box_->home().c_str(), 1);
    TrialSetup setup;
    setup.patient = write_block_patient(box_->folder());
    setup.curriculum = write_curriculum(box_->folder());
    setup.scenario = "plain";
    setup.device = "scripted:" + write_press(box_->folder()).string();
    setup.out = folder();
    setup.realtime = false;
    TrialSession session(setup);
    session.start();
    for (int i = 0; i < 6000 && !session.finished(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    session.finish("ended");
    log_ = std::make_shared<const curricula::TrialLog>(curricula::read_trial_log(folder()));
  }
  static void TearDownTestSuite() {
    log_.reset();
    box_.reset();
    application_.reset();
  }
  static fs::path folder() { return *box_ / "out"; }
  static engine::SceneDescription scene() { return recorded_scene(*log_, folder(), {}).description; }
  static bool wait(const ReplayFilm& film) {
    for (int i = 0; i < 3000 && !film.finished(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return film.finished();
  }

  static inline std::unique_ptr<HeadlessApplication> application_;
  static inline std::unique_ptr<Sandbox> box_;
  static inline std::shared_ptr<const curricula::TrialLog> log_;
};

TEST_F(ReplayedTrial, ShowsWhatWasRecordedAndTheShapesThatAReplayGives) {
  const ReplayFilm film(log_, scene());
  ASSERT_TRUE(wait(film));
  EXPECT_EQ(film.remark(), "") << "bit-identical throughout";
  ASSERT_EQ(film.computed(), film.plan().frames);
  EXPECT_EQ(film.plan().frames, (log_->ticks.size() - 1) / 33 + 1);
  engine::Replayer again(engine::build_scene(scene()));
  double sight = 0.0, deepest = 1.0;
  for (std::size_t i = 0; i < log_->ticks.size(); ++i) {
    const curricula::LogTick& tick = log_->ticks[i];
    again.replay(from_log(tick));
    if (tick.has_sight) sight = tick.glottis_visible;
    if (i % 33 != 0) continue;
    const engine::Snapshot& frame = *film.frame(i / 33);
    EXPECT_EQ(film.time_s(i / 33), tick.time_s);
    EXPECT_EQ(film.frame_at(tick.time_s), i / 33);
    EXPECT_EQ(frame.time_s, tick.time_s);
    EXPECT_EQ(frame.glottis_visible, sight);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(frame.model_force_n[axis], tick.model_force_n[axis]);
      EXPECT_EQ(frame.displayed_force_n[axis], tick.displayed_force_n[axis]);
      EXPECT_EQ(frame.proxy_pose.position[axis], tick.proxy_pose.position_m[axis]);
      for (std::size_t s = 0; s < frame.loads.size(); ++s)
        EXPECT_EQ(frame.loads[s].force_n[axis], tick.loads[s].force_n[axis]);
    }
    EXPECT_EQ(frame.soft_points, again.snapshot().soft_points);
    for (std::size_t k = 2; k < frame.soft_points.size(); k += 3)
      deepest = std::min(deepest, static_cast<double>(frame.soft_points[k] - film.frame(0)->soft_points[k]));
  }
  EXPECT_LT(deepest, -0.0015) << "the press of 2.5 mm is seen in the tissue";
  EXPECT_EQ(film.frame_at(-1.0), 0u);
  EXPECT_EQ(film.frame_at(1e9), film.plan().frames - 1);
  EXPECT_EQ(film.frame(film.plan().frames), nullptr);
}

TEST_F(ReplayedTrial, OfLittleMemoryHasFewerFramesAndSaysWhere) {
  const ReplayFilm film(log_, scene(), std::size_t{64} << 10);
  ASSERT_TRUE(wait(film));
  EXPECT_LE(film.plan().bytes, std::size_t{64} << 10);
  EXPECT_LT(film.plan().frames, log_->ticks.size() / 40);
  for (std::size_t i = 0; i < film.plan().frames; ++i) {
    EXPECT_EQ(film.frame(i)->time_s, film.time_s(i));
    EXPECT_EQ(film.frame_at(film.time_s(i)), i);
    EXPECT_NEAR(film.time_s(i), static_cast<double>(i) * film.frame_s(), 1e-9);
  }
}

TEST_F(ReplayedTrial, IsStoppedAtOnceAndKeepsWhatThereIs) {
  ReplayFilm film(log_, scene());
  while (film.computed() < 2) std::this_thread::yield();
  film.stop();
  ASSERT_TRUE(wait(film));
  ASSERT_GE(film.computed(), 2u);
  ASSERT_LT(film.computed(), film.plan().frames);
  EXPECT_NE(film.frame(film.computed() - 1), nullptr);
  EXPECT_EQ(film.frame(film.computed()), nullptr);
  EXPECT_EQ(film.remark(), "stopped before its end");
}

TEST_F(ReplayedTrial, OfALogThatWasChangedSaysFromWhereItDiffers) {
  auto changed = std::make_shared<curricula::TrialLog>(*log_);
  changed->ticks[700].model_force_n[2] += 0.25;
  const ReplayFilm film(changed, scene());
  ASSERT_TRUE(wait(film));
  EXPECT_NE(film.remark().find("0.7 s"), std::string::npos) << film.remark();
  EXPECT_NE(film.remark().find("model_force"), std::string::npos) << film.remark();
  EXPECT_EQ(film.computed(), film.plan().frames) << "it is shown all the same";
}

// In real time the first tick is written before any step is done: it knows no tool, and must not show one at the
// origin.
TEST_F(ReplayedTrial, TheFirstTickOfATrialInRealTimeShowsTheBladeWhereTheHandHasIt) {
  auto first = std::make_shared<curricula::TrialLog>(*log_);
  first->ticks[0].step_used = -1;
  first->ticks[0].proxy_pose = {};
  const ReplayFilm film(first, scene());
  ASSERT_TRUE(wait(film));
  const auto& device = first->ticks[0].device_pose.position_m;
  EXPECT_GT(std::abs(device[0]) + std::abs(device[1]) + std::abs(device[2]), 0.01);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(film.frame(0)->proxy_pose.position[axis], device[static_cast<std::size_t>(axis)], 1e-4);
}

TEST_F(ReplayedTrial, IsOpenedWithEverythingThatLeadsToASecond) {
  std::vector<double> shares;
  const auto opened = open_replay(folder(), {}, [&](const std::string&, double share) { shares.push_back(share); });
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
  EXPECT_EQ(opened->log_file, folder() / "trial.vtrial");
  EXPECT_NEAR(opened->end_s(), 1.2, 0.01);
  EXPECT_EQ(opened->tick_at(0.5).tick, 500);
  EXPECT_EQ(opened->tick_at(99.0).tick, opened->log->ticks.back().tick);
  EXPECT_EQ(opened->path.time_s.size(), (opened->log->ticks.size() - 1) / 20 + 1);
  EXPECT_NEAR(opened->peaks.back().tongue_n, opened->score.peak_tongue_force_n, 1e-6);
  const auto peak = std::find_if(opened->events.begin(), opened->events.end(), [](const ReplayEvent& event) {
    return event.text.find("on the tongue") != std::string::npos;
  });
  ASSERT_NE(peak, opened->events.end());
  EXPECT_EQ(peak->at_s, opened->score.time_of_peak_tongue_force_s);
}

TEST_F(ReplayedTrial, OfAMissingPatientIsRefusedInOneSentence) {
  const auto none = [](const std::string&, double) {};
  fs::rename(*box_ / "block.patient", *box_ / "elsewhere");
  try {
    open_replay(folder(), {}, none);
    FAIL() << "without its package";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("block.patient"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("--patient"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(open_replay(folder(), *box_ / "elsewhere", none));
  fs::rename(*box_ / "elsewhere", *box_ / "block.patient");
}

TEST(ReplayRefusal, IsOfAssessmentsAlone) {
  curricula::Scenario scenario;
  EXPECT_EQ(replay_refusal(scenario), "");
  scenario.attempt.mode = curricula::Mode::assessment;
  EXPECT_NE(replay_refusal(scenario).find("assessment"), std::string::npos);
  EXPECT_EQ(replay_refusal(scenario, true), "") << "to an instructor";
}

/// Ten seconds in which nothing happens, to write events into.
curricula::TrialLog quiet_log() {
  curricula::TrialLog log;
  log.header.has_intubation = true;
  log.ticks.resize(10000);
  for (std::size_t i = 0; i < log.ticks.size(); ++i) {
    curricula::LogTick& tick = log.ticks[i];
    tick.tick = static_cast<std::int64_t>(i);
    tick.time_s = 0.001 * static_cast<double>(i);
    tick.has_intubation = true;
    tick.intubation.spo2 = 0.96;
    tick.intubation.heart_per_min = 150.0;
  }
  return log;
}

struct Expected {
  double at_s, to_s;
  Kind kind;
};

TEST(ReplayEvents, StandAtTheirSeconds) {
  curricula::TrialLog log = quiet_log();
  const auto during = [&](double from_s, double to_s, const auto& change) {
    for (long i = std::lround(1e3 * from_s); i <= std::lround(1e3 * to_s); ++i)
      change(log.ticks[static_cast<std::size_t>(i)]);
  };
  using Tick = curricula::LogTick;
  during(1.0, 1.5, [](Tick& t) { t.loads[curricula::kTongue].force_n = {0.0, 3.0, 4.0}; });  // 5 N
  during(1.6, 1.8, [](Tick& t) {
    t.loads[curricula::kTongue].force_n = {0.0, -5.0, 0.0};
  });  // a shiver later: the same
  during(3.0, 3.2, [](Tick& t) { t.state = curricula::LoggedState::limited; });
  during(4.0, 9.999, [](Tick& t) {
    t.intubation.place = curricula::LoggedPlace::larynx;
    t.intubation.past_cords_m = 0.002;
  });
  during(4.5, 5.0, [](Tick& t) { t.intubation.in_hand = curricula::LoggedInHand::catheter; });
  during(6.0, 9.999, [](Tick& t) { t.intubation.breaths_given = 1; });
  during(6.5, 9.999, [](Tick& t) { t.intubation.detector_yellow = true; });
  during(7.0, 7.5, [](Tick& t) { t.intubation.spo2 = 0.79; });
  during(7.2, 7.5, [](Tick& t) { t.intubation.heart_per_min = 99.0; });
  log.events.push_back({2000, curricula::LogEvent::Kind::shown, 1, 0});
  log.events.push_back({2750, curricula::LogEvent::Kind::answered, 1, 2});
  curricula::Scenario scenario;
  scenario.targets.tongue_force_n = 4.0;
  scenario.distractions.resize(1);
  scenario.distractions[0].kind = curricula::Distraction::Kind::question;
  scenario.distractions[0].right_answer = 2;
  curricula::Score score;
  score.pauses.push_back({8.0, 1.0, "unplugged"});
  score.intubation.emplace();
  curricula::Attempt attempt;
  attempt.start_s = 0.5;
  attempt.end_s = 9.5;
  attempt.view_at_s = 2.5;
  score.intubation->attempts.push_back(attempt);

  const std::vector<ReplayEvent> events = replay_events(log, scenario, score);
  const std::vector<Expected> expected = {{0.5, 9.5, Kind::attempt_begins}, {1.0, 1.8, Kind::over_target},
                                          {2.0, 2.0, Kind::distraction},    {2.5, 2.5, Kind::first_sight},
                                          {2.75, 2.75, Kind::distraction},  {3.0, 3.2, Kind::device_limit},
                                          {4.0, 4.0, Kind::cords_passed},   {5.001, 5.001, Kind::cords_passed},
                                          {6.0, 6.0, Kind::breath},         {6.5, 6.5, Kind::co2},
                                          {7.0, 7.0, Kind::alarm},          {7.2, 7.2, Kind::alarm},
                                          {8.0, 9.0, Kind::pause},          {9.5, 9.5, Kind::attempt_ends}};
  ASSERT_EQ(events.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(events[i].at_s, expected[i].at_s, 1e-9) << events[i].text;
    EXPECT_NEAR(events[i].to_s, expected[i].to_s, 1e-9) << events[i].text;
    EXPECT_EQ(events[i].kind, expected[i].kind) << events[i].text;
  }
  EXPECT_EQ(events[4].text, "question answered rightly");
  EXPECT_EQ(events[12].text, "pause: unplugged");
  score.pauses[0].fault = "communication_lost";
  EXPECT_EQ(replay_events(log, scenario, score)[12].text, "pause: communication lost") << "in words";

  EXPECT_EQ(next_event(events, 4.0), &events[7]);
  EXPECT_EQ(next_event(events, 5.5), &events[9]) << "a breath is no place to go to";
  EXPECT_EQ(next_event(events, 9.6), nullptr);
  EXPECT_EQ(previous_event(events, 4.1), &events[5]) << "and not the one that has just begun";
  EXPECT_EQ(previous_event(events, 0.5), nullptr);
}

TEST(ReplayCommand, OpensTheWindowOnlyWhereItCan) {
  const Sandbox box;
  const Outcome both = box.run({"replay", "x", "--window", "--verify"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_EQ(box.run({"replay", "x", "--at", "3"}).exit_code, 2) << "a second of what?";
  EXPECT_EQ(box.run({"replay", "x", "--window", "--at", "nan"}).exit_code, 2);
  const Outcome blind = box.run({"replay", "x", "--window"}, {"DISPLAY=", "WAYLAND_DISPLAY="});
  EXPECT_EQ(blind.exit_code, 1);
  ASSERT_EQ(blind.messages().size(), 1u) << blind.err;
}

}  // namespace
}  // namespace vallecula::gui::test
