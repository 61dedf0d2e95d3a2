// A device that fails within a trial: the scene stays, no force is shown, the clock stands, the return is smooth, and
// the log replays to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <thread>

#include "curricula/trial_log.h"
#include "gui/commands/headless_application.h"
#include "gui/session/device_choice.h"
#include "gui/session/log_conversion.h"
#include "gui/session/picture_watch.h"
#include "gui/session/replay.h"
#include "gui/session/trial_session.h"
#include "gui/session/user_settings.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;
using curricula::LoggedState;
using curricula::LogTick;

double size_of(const std::array<double, 3>& v) { return std::hypot(std::hypot(v[0], v[1]), v[2]); }
double apart(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return size_of({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

class TrialPause : public ::testing::Test {
 protected:
  TrialPause() { ::setenv("VALLECULA_HOME", box_.home().c_str(), 1); }

  /// The blade over the block's dorsum at heights `z` (m) by time, tongue side down; `remarks` before.
  std::string hand(const std::string& remarks, const std::vector<std::pair<double, double>>& time_and_z) {
    std::string csv = remarks;
    for (const auto& [time, z] : time_and_z)
      csv += std::to_string(time) + ",0,0.005," + std::to_string(z) + ",0,0.70710678118654752,-0.70710678118654752,0\n";
    write_text(box_ / "hand.csv", csv);
    return "scripted:" + (box_ / "hand.csv").string();
  }
  TrialSetup setup(const std::string& device, const std::string& out) {
    TrialSetup setup;
    setup.patient = patient_;
    setup.curriculum = curriculum_;
    setup.scenario = "plain";
    setup.device = device;
    setup.out = box_ / out;
    setup.realtime = false;
    return setup;
  }
  static void wait(const TrialSession& session) {
    for (int i = 0; i < 12000 && !session.finished(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_TRUE(session.finished());
  }
  TrialOutcome run(const TrialSetup& given) {
    TrialSession session(given);
    session.start();
    wait(session);
    return session.finish("ended");
  }
  /// What holds of every pause: zero force from its first tick on, the tool frozen, and no jump afterwards.
  static void expect_harmless(const curricula::TrialLog& log) {
    const double rate_n = log.header.settings.at("force_rate_n_s") * 0.001;
    for (std::size_t i = 1; i < log.ticks.size(); ++i) {
      const LogTick &t = log.ticks[i], &before = log.ticks[i - 1];
      if (!t.device_valid) {
        ASSERT_EQ(size_of(t.displayed_force_n), 0.0) << t.time_s;
        // The engine stops the tool in the pause's first tick; it stands from the next one on.
        if (!before.device_valid) {
          ASSERT_EQ(t.proxy_pose.position_m, before.proxy_pose.position_m) << t.time_s;
        }
      } else {
        ASSERT_LE(apart(t.displayed_force_n, before.displayed_force_n), rate_n * (1 + 1e-9)) << t.time_s;
      }
      ASSERT_LT(apart(t.proxy_pose.position_m, before.proxy_pose.position_m), 2e-4) << "0.2 m/s, at " << t.time_s;
    }
    EXPECT_EQ(log.ticks.back().state, LoggedState::tracking);
    EXPECT_TRUE(log.ticks.back().device_valid);
  }

  HeadlessApplication application_;
  Sandbox box_;
  fs::path patient_ = write_block_patient(box_.folder());
  fs::path curriculum_ = write_curriculum(box_.folder());
};

TEST_F(TrialPause, CommunicationLostInThePressGoesOnWithoutAJumpAndReplaysToTheBit) {
  const TrialOutcome outcome =
      run(setup(hand("# fault communication_lost 0.8 0.25\n",
                     {{0, 0.006}, {0.2, 0.002}, {0.6, -0.006}, {2.6, -0.006}, {3.2, 0.006}, {3.4, 0.006}}),
                "out"));
  const curricula::TrialLog log = curricula::read_trial_log(outcome.log);
  expect_harmless(log);
  const auto first = std::find_if(log.ticks.begin(), log.ticks.end(), [](const LogTick& t) { return !t.device_valid; });
  ASSERT_NE(first, log.ticks.end());
  EXPECT_NEAR(first->time_s, 0.8, 1e-9);
  double before_n = 0.0, after_n = 0.0, shown_after_n = 0.0;
  for (const LogTick& t : log.ticks) {
    const double tongue_n = size_of(t.loads[curricula::kTongue].force_n);
    if (t.time_s < 0.8) before_n = std::max(before_n, tongue_n);
    if (t.time_s > 1.0) after_n = std::max(after_n, tongue_n);
    if (t.time_s > 2.3 && t.time_s < 2.5) shown_after_n = std::max(shown_after_n, size_of(t.displayed_force_n));
  }
  EXPECT_GT(before_n, 0.3) << "it was in the press";
  EXPECT_LT(after_n, 1.15 * before_n) << "no blow when the hand takes hold again";
  EXPECT_GT(shown_after_n, 0.8 * before_n) << "the force is back";
  // 0.25 s away and half a second of holding still.
  EXPECT_NEAR(outcome.score.paused_s, 0.75, 0.003);
  EXPECT_EQ(outcome.score.time_over_force_limit_s, 0.0);
  ASSERT_EQ(outcome.score.pauses.size(), 1u);
  EXPECT_NEAR(outcome.score.pauses[0].at_s, 0.8, 1e-9);
  EXPECT_EQ(outcome.score.pauses[0].fault, "communication_lost");

  const Verification verified = verify_trial(log, recorded_scene(log, outcome.log, {}).description);
  EXPECT_EQ(verified.difference.field, "");
  EXPECT_EQ(verified.ticks, static_cast<std::int64_t>(log.ticks.size()));

  // The recorded hand does the same trial, pause and all.
  const curricula::TrialLog again =
      curricula::read_trial_log(run(setup("recorded:" + outcome.log.parent_path().string(), "again")).log);
  EXPECT_EQ(again.header.device_kind, "recorded");
  ASSERT_GE(again.ticks.size(), log.ticks.size());
  for (std::size_t i = 0; i < log.ticks.size(); ++i)
    ASSERT_EQ(first_difference(log.ticks[i], again.ticks[i]).field, "") << i;
}

// The paper's case: the device gives up at its maximum while the hand keeps pushing.
TEST_F(TrialPause, AtItsMaximumTheSceneStaysTheGhostShowsTheHandAndTheReturnIsSmooth) {
  const TrialOutcome outcome = run(
      setup(hand("# hand device_limit_n 0.3\n# hand limit_time_s 0.15\n# hand recovery_time_s 0.3\n", {{0, 0.006},
                                                                                                       {0.2, 0.002},
                                                                                                       {0.8, -0.010},
                                                                                                       {1.8, -0.010},
                                                                                                       {2.3, -0.001},
                                                                                                       {3.6, -0.001},
                                                                                                       {4.2, 0.006},
                                                                                                       {4.4, 0.006}}),
            "out"));
  const curricula::TrialLog log = curricula::read_trial_log(outcome.log);
  expect_harmless(log);
  bool limited = false;
  double ghost_m = 0.0, deepest_z = 1.0;
  for (const LogTick& t : log.ticks) {
    limited |= t.state == LoggedState::limited;
    if (t.step_used >= 0) deepest_z = std::min(deepest_z, t.proxy_pose.position_m[2]);
    if (!t.device_valid) ghost_m = std::max(ghost_m, apart(t.device_pose.position_m, t.proxy_pose.position_m));
    EXPECT_LE(size_of(t.displayed_force_n), 0.3 + 1e-9);
  }
  EXPECT_TRUE(limited);
  EXPECT_GT(ghost_m, 0.005) << "the hand pushed on";
  EXPECT_GT(deepest_z, -0.005) << "the tool did not follow it";
  EXPECT_GT(outcome.score.paused_s, 0.5);
  ASSERT_FALSE(outcome.score.pauses.empty());
  EXPECT_EQ(outcome.score.pauses[0].fault, "force_exceeded");
  EXPECT_GT(outcome.score.time_over_force_limit_s, 0.1) << "the time at the limit is the hand's own";
  // The block is at rest again when the blade is out.
  EXPECT_EQ(log.ticks.back().loads[curricula::kTongue].contacts, 0);
  const Verification verified = verify_trial(log, recorded_scene(log, outcome.log, {}).description);
  EXPECT_EQ(verified.difference.field, "");
}

// A device with axes of its own begins where the expert does, and its right is the operator's right.
TEST_F(TrialPause, ADeviceWithItsOwnAxesIsMappedIntoThePatient) {
  class Pen final : public device::HapticDevice {
   public:
    device::DeviceInfo info() const override {
      device::DeviceInfo info;
      info.kind = "pen";
      info.serial = "4711";
      info.peak_force_n = 3.3;
      info.continuous_force_n = 0.88;
      info.own_axes = true;
      return info;
    }
    device::DeviceReading read(double time_s) noexcept override {
      device::DeviceReading reading;
      reading.position_m = {0.05 + 0.01 * time_s, 0.02, -0.03};
      return reading;
    }
    void write(const std::array<double, 3>&) noexcept override {}
    device::DeviceFault fault() const noexcept override { return device::DeviceFault::none; }
    bool finished(double time_s) const noexcept override { return time_s >= 0.5; }
  };
  DeviceSettings settings = device_settings(Pen().info());
  settings.map.motion_scale = 2.0;
  keep_device_settings(Pen().info(), settings);
  TrialSetup mapped = setup("", "out");
  mapped.own_device = [] { return std::make_unique<Pen>(); };
  TrialSession session(mapped);
  const device::Keyframe start = starting_pose(session.package(), session.scenario());
  session.start();
  wait(session);
  const curricula::TrialLog log = curricula::read_trial_log(session.finish("ended").log);
  const auto& begin = log.ticks.front().device_pose;
  EXPECT_LT(apart(begin.position_m, start.position_m), 1e-12);
  const auto& end = log.ticks[500].device_pose.position_m;
  EXPECT_NEAR(apart(end, begin.position_m), 2.0 * 0.005, 1e-9);
  EXPECT_NEAR(end[0] - begin.position_m[0], -2.0 * 0.005, 1e-9) << "the operator's right is the patient's right";
  // Twice the way asks for half the force, and 3.3 N for 7.9 N; the limit is told in the patient's newtons.
  EXPECT_DOUBLE_EQ(log.header.settings.at("device_force_scale"), 3.3 / (7.9 * 2.0));
  EXPECT_EQ(log.header.settings.at("device_motion_scale"), 2.0);
  EXPECT_EQ(log.header.settings.at("device_continuous_force_n"), 0.88);
  EXPECT_NEAR(log.header.device_limit_n, 7.9, 1e-12);
}

class TrialPauseRealTime : public TrialPause {};

TEST_F(TrialPauseRealTime, AKeyTakesHoldAgainAndThePauseIsToldInPlainWords) {
  TrialSetup live =
      setup(hand("# fault unplugged 0.3 0.3\n", {{0, 0.006}, {0.25, 0.006}, {0.7, 0.030}, {60, 0.030}}), "out");
  live.realtime = true;
  TrialSession session(live);
  session.start();
  const auto wait_for = [&](const std::string& words) {
    for (int i = 0; i < 6000; ++i) {
      if (words.empty() ? session.pause().empty() : session.pause().find(words) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  };
  EXPECT_TRUE(wait_for("unplugged")) << session.pause();
  EXPECT_TRUE(wait_for("The device is back")) << session.pause();
  session.confirm();
  EXPECT_TRUE(wait_for(""));
  EXPECT_GT(session.paused_s(), 0.29);
  live.device = "recorded:" + session.finish("ended").log.string();
  live.out = box_ / "again";
  TrialSession again(live);
  again.start();
  std::string told;
  for (int i = 0; i < 6000 && told.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    told = again.pause();
  }
  EXPECT_NE(told.find("goes on by itself"), std::string::npos) << "nobody is sent to look for a cable: " << told;
  again.finish("ended");
}

TEST_F(TrialPauseRealTime, HeldByAPersonItStandsAndGoesOnWithoutAJump) {
  // Presses from 0.3 s on and stays there: held in the press.
  TrialSetup live = setup(hand("", {{0, 0.006}, {0.3, 0.006}, {0.6, -0.002}, {60, -0.002}}), "frozen");
  live.realtime = true;
  TrialSession session(live);
  session.start();
  const auto wait_for = [&](const std::function<bool()>& done) {
    for (int i = 0; i < 8000 && !done(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return done();
  };
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 700; }));
  EXPECT_FALSE(session.frozen());
  session.freeze(Holder::instructor, true);
  EXPECT_TRUE(session.frozen());
  ASSERT_TRUE(wait_for([&] { return session.pause().find("held") != std::string::npos; })) << session.pause();
  EXPECT_NE(session.pause().find("held by the instructor"), std::string::npos) << session.pause();
  const std::int64_t at = session.latest().ticks;
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > at + 200; }));
  EXPECT_EQ(session.latest().displayed_force_n, engine::Vec3(engine::Vec3::Zero()));
  session.confirm();  // nobody goes on while it is held
  EXPECT_NE(session.pause(), "");
  session.freeze(Holder::instructor, false);
  ASSERT_TRUE(wait_for([&] { return session.pause().find("let go") != std::string::npos || session.pause().empty(); }));
  session.confirm();
  ASSERT_TRUE(wait_for([&] { return session.pause().empty(); }));
  const std::int64_t again = session.latest().ticks;
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > again + 200; }));
  const curricula::TrialLog log = curricula::read_trial_log(session.finish("ended").log);
  ASSERT_EQ(log.footer.pause_faults, (std::vector<std::string>{"frozen"}));
  // As expect_harmless, but in real time a tick shows a step of some ticks before, the first none.
  const double rate_n = log.header.settings.at("force_rate_n_s") * 0.001;
  std::int64_t last_fed_before = -1;
  for (std::size_t i = 1; i < log.ticks.size(); ++i) {
    const LogTick &t = log.ticks[i], &before = log.ticks[i - 1];
    if (t.device_valid) {
      last_fed_before = std::max(last_fed_before, t.step_fed);
      ASSERT_LE(apart(t.displayed_force_n, before.displayed_force_n), rate_n * (1 + 1e-9)) << t.time_s;
    } else {
      ASSERT_EQ(size_of(t.displayed_force_n), 0.0) << t.time_s;
      if (before.step_used > last_fed_before) {
        ASSERT_EQ(t.proxy_pose.position_m, before.proxy_pose.position_m) << t.time_s;
      }
    }
    if (before.step_used >= 0) {
      ASSERT_LT(apart(t.proxy_pose.position_m, before.proxy_pose.position_m),
                2e-4 * static_cast<double>(std::max<std::int64_t>(1, t.step_used - before.step_used)))
          << t.time_s;
    }
  }
  EXPECT_TRUE(log.ticks.back().device_valid);
  EXPECT_GT(size_of(log.ticks.back().displayed_force_n), 0.05) << "the press is felt again";
}

TEST_F(TrialPauseRealTime, EachWhoHoldsItLetsGoForThemselvesAndAResetForNobody) {
  TrialSetup live = setup(hand("", {{0, 0.006}, {0.3, 0.006}, {0.6, 0.002}, {60, 0.002}}), "held");
  live.realtime = true;
  TrialSession session(live);
  session.start();
  const auto wait_for = [&](const std::function<bool()>& done) {
    for (int i = 0; i < 8000 && !done(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return done();
  };
  const auto stands = [&] { return session.pause().find("held") != std::string::npos; };
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 100; }));
  session.freeze(Holder::expert, true);
  session.freeze(Holder::instructor, true);
  session.freeze(Holder::expert, false);
  EXPECT_TRUE(session.frozen());
  EXPECT_FALSE(session.frozen_by(Holder::expert));
  ASSERT_TRUE(wait_for(stands)) << session.pause();
  session.freeze(Holder::expert, true);
  session.freeze(Holder::instructor, false);
  EXPECT_TRUE(session.frozen()) << "nor does the instructor let go for the expert";
  EXPECT_NE(session.pause().find("held by you"), std::string::npos) << session.pause();
  session.freeze(Holder::instructor, true);
  session.freeze(Holder::expert, false);
  session.reset();
  EXPECT_TRUE(session.frozen_by(Holder::instructor));
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 200 && stands(); })) << session.pause();
  session.freeze(Holder::instructor, false);
  ASSERT_TRUE(wait_for([&] { return !stands(); }));
  session.confirm();
  ASSERT_TRUE(wait_for([&] { return session.pause().empty(); })) << session.pause();
  const std::int64_t again = session.latest().ticks;
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > again + 200; }));
  const curricula::TrialLog log = curricula::read_trial_log(session.finish("ended").log);
  EXPECT_EQ(log.footer.pause_faults, (std::vector<std::string>{"frozen"}));
  EXPECT_FALSE(log.ticks.front().device_valid) << "held from its first tick on";
  EXPECT_TRUE(log.ticks.back().device_valid);
  for (std::size_t i = 1; i < log.ticks.size(); ++i) {
    const LogTick &t = log.ticks[i], &before = log.ticks[i - 1];
    if (before.step_used >= 0) {
      ASSERT_LT(apart(t.proxy_pose.position_m, before.proxy_pose.position_m),
                2e-4 * static_cast<double>(std::max<std::int64_t>(1, t.step_used - before.step_used)))
          << t.time_s;
    }
  }
}

TEST_F(TrialPauseRealTime, EveryPauseIsKeptByWhoHeldIt) {
  TrialSetup live = setup(hand("", {{0, 0.006}, {60, 0.006}}), "who");
  live.realtime = true;
  TrialSession session(live);
  session.start();
  const auto wait_for = [&](const std::function<bool()>& done) {
    for (int i = 0; i < 8000 && !done(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return done();
  };
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 100; }));
  const auto held_by = [&](Holder holder) {
    const double before_s = session.paused_s();
    session.freeze(holder, true);
    ASSERT_TRUE(wait_for([&] { return session.paused_s() > before_s + 0.02; }));
    session.freeze(holder, false);
    ASSERT_TRUE(wait_for([&] { return session.pause().find("held") == std::string::npos; }));
    session.confirm();
    ASSERT_TRUE(wait_for([&] { return session.pause().empty(); })) << session.pause();
    const std::int64_t again = session.latest().ticks;
    ASSERT_TRUE(wait_for([&] { return session.latest().ticks > again + 50; }));
  };
  for (const Holder holder : {Holder::reader, Holder::expert, Holder::instructor, Holder::reader}) held_by(holder);
  const TrialOutcome outcome = session.finish("ended");
  std::vector<std::string> faults;
  for (const curricula::Pause& pause : outcome.score.pauses) faults.push_back(pause.fault);
  EXPECT_EQ(faults, (std::vector<std::string>{"list_of_keys", "expert_shown", "frozen", "list_of_keys"}));
}

TEST_F(TrialPauseRealTime, AHandThatSeesNothingIsHeldAndTheTrialWaits) {
  using namespace std::chrono;
  const auto wait_for = [&](const std::function<bool()>& done) {
    for (int i = 0; i < 20000 && !done(); ++i) std::this_thread::sleep_for(milliseconds(1));
    return done();
  };
  for (const curricula::Mode mode : {curricula::Mode::practice, curricula::Mode::assessment}) {
    TrialSetup live = setup("mouse", mode == curricula::Mode::practice ? "unseen" : "unseen-assessed");
    live.mode = mode;
    live.realtime = true;
    TrialSession session(live);
    session.start();
    ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 2500; }));
    EXPECT_FALSE(session.frozen()) << "what nobody draws is not watched";
    const auto last_picture = steady_clock::now();
    session.picture_shown();
    ASSERT_TRUE(wait_for([&] { return session.frozen_by(Holder::picture); }));
    EXPECT_GE(steady_clock::now() - last_picture, PictureWatch::kLongest);
    ASSERT_TRUE(wait_for([&] { return session.paused_s() > 0.1; }));
    EXPECT_NE(session.pause().find("No picture comes to the screen"), std::string::npos) << session.pause();
    const auto clock_s = [&] { return 1e-3 * static_cast<double>(session.latest().ticks) - session.paused_s(); };
    const double stood_s = clock_s(), before_s = session.paused_s();
    ASSERT_TRUE(wait_for([&] { return session.paused_s() > before_s + 1.0; }));
    EXPECT_NEAR(clock_s(), stood_s, 0.3) << "the trial's clock stands, but for what is not on record yet";
    EXPECT_EQ(session.latest().displayed_force_n, engine::Vec3(engine::Vec3::Zero()));
    session.confirm();
    EXPECT_FALSE(session.pause().empty()) << "nobody goes on without a picture";
    session.picture_shown();
    session.freeze(Holder::picture, false);
    ASSERT_TRUE(wait_for([&] { return session.pause().find("The picture is back") == 0 || session.pause().empty(); }));
    session.confirm();
    ASSERT_TRUE(wait_for([&] { return session.pause().empty(); })) << session.pause();
    EXPECT_FALSE(session.frozen());
    const TrialOutcome outcome = session.finish("ended");
    ASSERT_EQ(outcome.score.pauses.size(), 1u);
    EXPECT_EQ(outcome.score.pauses[0].fault, "no_picture");
    EXPECT_GE(outcome.score.pauses[0].for_s, 1.0);
  }
  TrialSetup scripted = setup(hand("", {{0, 0.006}, {60, 0.006}}), "scripted");
  scripted.realtime = true;
  TrialSession session(scripted);
  session.start();
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 100; }));
  session.picture_shown();
  const std::int64_t at = session.latest().ticks;
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > at + 3000; }));
  EXPECT_FALSE(session.frozen()) << "a script needs no eyes";
}

TEST_F(TrialPause, ADeviceThatIsAwayForTenMinutesEndsTheTrialAndAPersonWhoHoldsItDoesNot) {
  if (std::getenv("VALLECULA_SLOW") == nullptr) GTEST_SKIP() << "twenty minutes of ticks; VALLECULA_SLOW=1 runs it";
  const std::vector<std::pair<double, double>> still{{0, 0.030}, {900, 0.030}};
  EXPECT_EQ(curricula::read_trial_log(run(setup(hand("# fault unplugged 0.1 800\n", still), "away")).log).footer.ended,
            "the device did not come back");
  TrialSession session(setup(hand("", still), "long"));
  session.freeze(Holder::instructor, true);
  session.start();
  for (int i = 0; i < 30000 && !session.finished() && session.paused_s() < 610.0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_GE(session.paused_s(), 610.0);
  EXPECT_FALSE(session.finished());
  EXPECT_EQ(curricula::read_trial_log(session.finish("ended").log).footer.ended, "ended");
}

TEST_F(TrialPause, AnAssessmentIsNeitherHeldNorBegunHalfWay) {
  TrialSetup tested = setup(hand("", {{0, 0.006}, {1, 0.006}}), "tested");
  tested.mode = curricula::Mode::assessment;
  TrialSession session(tested);
  EXPECT_THROW(session.freeze(Holder::instructor, true), std::runtime_error);
  EXPECT_FALSE(session.frozen());
  EXPECT_THROW(session.reset_at_vallecula(), std::runtime_error);
}

TEST_F(TrialPause, SettingsAreKeptPerDeviceAndNonsenseIsNone) {
  device::DeviceInfo one, other;
  one.kind = other.kind = "pen";
  one.serial = "A/1";
  other.serial = "A/2";
  one.own_axes = other.own_axes = true;
  one.peak_force_n = other.peak_force_n = 7.9;
  DeviceSettings settings;
  settings.map = {0.5, -0.25, true};
  settings.force_scale = 0.5;
  settings.clutch_button = 4;
  keep_device_settings(one, settings);
  const device::GuardSettings guard = guard_settings(one);
  EXPECT_EQ(guard.map.motion_scale, 0.5);
  EXPECT_EQ(guard.map.turned_rad, -0.25);
  EXPECT_TRUE(guard.map.left_handed);
  EXPECT_EQ(guard.limits.force_scale, 0.5);
  EXPECT_EQ(guard.clutch_button, 4u);
  EXPECT_EQ(clutch_button_in_hand(one), 3);
  EXPECT_EQ(clutch_button_in_hand(other), 2);
  EXPECT_EQ(guard_settings(other).map.motion_scale, 1.0);
  // What was chosen stays below what buzzes: here half the way and so a quarter of the model's stiffness.
  one.max_stiffness_n_m = 60.0;
  EXPECT_DOUBLE_EQ(guard_settings(one).limits.force_scale, 60.0 / (0.25 * 1200.0));
  one.max_stiffness_n_m = 1020.0;
  EXPECT_EQ(guard_settings(one).limits.force_scale, 0.5);
  EXPECT_EQ(device::kStiffestModelNM, engine::HapticSettings().coupling_stiffness_n_m);
  settings.clutch_button = 2;
  keep_device_settings(one, settings);
  EXPECT_EQ(clutch_button_in_hand(one), 1) << "left-handed, the first two are exchanged";
  one.own_axes = false;
  EXPECT_EQ(clutch_button_in_hand(one), 0);
  EXPECT_EQ(guard_settings(one).limits.force_scale, 1.0) << "a script is nobody's device";
  settings.map = {1e9, std::nan(""), false};
  settings.force_scale = -3.0;
  keep_device_settings(other, settings);
  EXPECT_EQ(guard_settings(other).map.motion_scale, 1.0);
  EXPECT_EQ(guard_settings(other).map.turned_rad, 0.0);
  EXPECT_EQ(guard_settings(other).limits.force_scale, 1.0);
  EXPECT_EQ(mouse_gain(), 1.0);
  keep_mouse_gain(2.5);
  EXPECT_EQ(mouse_gain(), 2.5);
  keep_mouse_gain(1e9);
  EXPECT_EQ(mouse_gain(), kMostMouseGain);
}

}  // namespace
}  // namespace vallecula::gui::test
