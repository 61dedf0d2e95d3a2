// The life of a trial inside one process: reset, abandon, finish.
#include "gui/session/trial_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <thread>

#include "curricula/records/people.h"
#include "curricula/records/records.h"
#include "curricula/trial_log.h"
#include "gui/commands/headless_application.h"
#include "gui/session/placed_tool.h"
#include "gui/session/replay.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/tool_file.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

class Session : public ::testing::Test {
 protected:
  Session() { ::setenv("VALLECULA_HOME", box_.home().c_str(), 1); }

  TrialSetup setup(bool realtime) {
    TrialSetup setup;
    setup.patient = patient_;
    setup.curriculum = curriculum_;
    setup.scenario = "plain";
    setup.device = "scripted:" + press_.string();
    setup.out = box_ / "out";
    setup.realtime = realtime;
    return setup;
  }
  static void wait(const TrialSession& session) {
    for (int i = 0; i < 6000 && !session.finished(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_TRUE(session.finished());
  }

  HeadlessApplication application_;
  Sandbox box_;
  fs::path patient_ = write_block_patient(box_.folder());
  fs::path press_ = write_press(box_.folder());
  fs::path curriculum_ = write_curriculum(box_.folder());
};

class SessionRealTime : public Session {};

TEST_F(Session, NeverStartedLeavesNothing) {
  { const TrialSession session(setup(false)); }
  EXPECT_FALSE(fs::exists(box_ / "out"));
}

TEST_F(Session, LoadsThePatientInMetres) {
  TrialSession session(setup(false));
  EXPECT_EQ(session.package().name, "block");
  EXPECT_EQ(session.scenario().id, "plain");
  ASSERT_EQ(session.scene().soft.nodes.size(), session.package().tongue.points.size());
  EXPECT_DOUBLE_EQ(session.scene().soft.nodes[0].x(), -0.010);
  EXPECT_EQ(session.device().info().kind, "scripted");
}

TEST_F(Session, StartTwiceAndFinishUnstartedAreRefused) {
  TrialSession session(setup(false));
  EXPECT_THROW(session.finish("ended"), std::logic_error);
  session.start();
  EXPECT_THROW(session.start(), std::logic_error);
  wait(session);
  session.finish("ended");
  EXPECT_THROW(session.finish("ended"), std::logic_error);
}

TEST_F(SessionRealTime, AFolderHasOneTrialAtATime) {
  TrialSession first(setup(true));
  first.start();
  {
    TrialSession second(setup(true));
    second.start();
    wait(second);
    EXPECT_NE(second.problem(), "");
    EXPECT_THROW(second.finish("ended"), std::runtime_error);
  }
  wait(first);
  const TrialOutcome outcome = first.finish("ended");
  EXPECT_TRUE(curricula::read_trial_log(outcome.log).footer.complete);
  EXPECT_TRUE(fs::exists(outcome.report));
  EXPECT_EQ(curricula::Records(box_.home() / "records.sqlite").newest(5).size(), 1u);
}

TEST_F(SessionRealTime, OnlyWhatAPersonsHandsDidIsAPersons) {
  long long anna = 0;
  {
    curricula::Records records(box_.home() / "records.sqlite");
    curricula::People(records).create_first_instructor("Doctor", "1234");
    anna = curricula::People(records).register_trainee("Anna", "2345");
  }
  for (const std::string& device : {std::string("mouse"), "scripted:" + press_.string()}) {
    TrialSetup hers = setup(true);
    hers.device = device;
    hers.trainee_id = anna;
    TrialSession session(hers);
    session.start();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    session.finish("ended");
    EXPECT_EQ(curricula::Records(box_.home() / "records.sqlite").newest(5).size(), device == "mouse" ? 0u : 1u)
        << "of those that are nobody's";
  }
}

TEST_F(Session, ThePeaksSoFarAreInTheEndTheScores) {
  TrialSession session(setup(false));
  session.start();
  wait(session);
  const PeaksSoFar peaks = session.peaks();
  const TrialOutcome outcome = session.finish("ended");
  EXPECT_GT(peaks.tongue_n, 0.1f);
  EXPECT_FLOAT_EQ(peaks.tongue_n, static_cast<float>(outcome.score.peak_tongue_force_n));
  EXPECT_FLOAT_EQ(peaks.gum_n, static_cast<float>(outcome.score.peak_gum_force_n));
}

TEST_F(Session, TheRecordNamesWhereTheTrialWillBe) {
  TrialSetup moved = setup(false);
  moved.final_out = box_ / "in place";
  TrialSession session(moved);
  session.start();
  wait(session);
  session.finish("ended");
  const auto rows = curricula::Records(box_.home() / "records.sqlite").newest(1);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].trial_path, (box_ / "in place" / "trial.vtrial").string());
}

TEST_F(SessionRealTime, ResetBeginsAnewWithTissueAtRestAndAFreshLog) {
  TrialSession session(setup(true));
  session.start();
  while (session.latest().ticks < 600 && !session.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  ASSERT_GE(session.latest().ticks, 600) << "in the press";
  session.reset();
  EXPECT_LT(session.latest().ticks, 300);
  wait(session);
  session.finish("ended");
  const curricula::TrialLog log = curricula::read_trial_log(box_ / "out");
  EXPECT_TRUE(log.footer.complete);
  ASSERT_GE(log.ticks.size(), 1200u);
  EXPECT_LT(log.ticks.size(), 1500u) << "the ticks before the reset are not in it";
  EXPECT_EQ(log.ticks.front().tick, 0);
  EXPECT_EQ(log.ticks.front().loads[curricula::kTongue].contacts, 0);
  // What was done before the reset is neither undone nor forgotten.
  const curricula::TrialLog before = curricula::read_trial_log(box_ / "out" / "before-reset-1.vtrial");
  EXPECT_EQ(before.footer.ended, "reset");
  EXPECT_GE(before.ticks.size(), 600u);
  EXPECT_EQ(curricula::Records(box_.home() / "records.sqlite").newest(10).size(), 2u);
}

// An attempt before a reset keeps the tool it was done with when a later trial takes the folder over.
TEST_F(Session, WhatWasBeforeAResetReplaysWithItsOwnTool) {
  {
    TrialSetup own = setup(false);
    own.tool = std::make_shared<engine::TriangleMesh>(laryngoscope(0.102, 0.11));
    TrialSession session(own);
    session.start();
    wait(session);
    session.reset();
    wait(session);
    session.finish("ended");
  }
  const fs::path log_file = box_ / "out" / "before-reset-1.vtrial";
  const curricula::TrialLog log = curricula::read_trial_log(log_file);
  ASSERT_FALSE(log.header.tool_sha256.empty());
  const auto another = std::make_shared<const engine::TriangleMesh>(laryngoscope(0.080, 0.09));
  for (const auto& later : {another, std::shared_ptr<const engine::TriangleMesh>()}) {
    TrialSetup next = setup(false);
    next.tool = later;
    TrialSession session(next);
    session.start();
    wait(session);
    session.finish("ended");
    EXPECT_EQ(fs::exists(box_ / "out" / "tool.ply"), later != nullptr);
    const Verification verified = verify_trial(log, recorded_scene(log, log_file, {}).description);
    EXPECT_EQ(verified.difference.field, "");
    EXPECT_EQ(verified.ticks, static_cast<std::int64_t>(log.ticks.size()));
  }
  // A log that has no tool of its own takes the one beside it, which must be the recorded one.
  fs::rename(box_ / "out" / "before-reset-1.tool.ply", box_ / "out" / "tool.ply");
  EXPECT_TRUE(tool_of_trial(log.header, log_file));
  fs::remove(box_ / "out" / "tool.ply");
  EXPECT_THROW(tool_of_trial(log.header, log_file), std::runtime_error);
}

/// A hand over the block's dorsum that sends poses of no numbers for 20 ms.
class BrokenDevice final : public device::HapticDevice {
 public:
  device::DeviceInfo info() const override {
    device::DeviceInfo info;
    info.kind = "broken";
    info.peak_force_n = 7.9;
    return info;
  }
  device::DeviceReading read(double time_s) noexcept override {
    device::DeviceReading reading;
    reading.valid = true;
    reading.position_m = {0.0, 0.0, 0.006};
    if (time_s >= 0.3 && time_s < 0.32) reading.position_m[1] = std::numeric_limits<double>::quiet_NaN();
    return reading;
  }
  void write(const std::array<double, 3>& force_n) noexcept override {
    for (const double f : force_n) finite_ &= std::isfinite(f);
  }
  device::DeviceFault fault() const noexcept override { return device::DeviceFault::none; }
  bool finished(double time_s) const noexcept override { return time_s > 1.4; }
  ~BrokenDevice() override { EXPECT_TRUE(finite_); }

 private:
  bool finite_ = true;
};

// A pose of no numbers: zero force, a named fault with the 50 ticks that led to it, and the session goes on; after a reset the
// next one is caught as well.
TEST_F(Session, AFaultIsNamedAndItsTicksAreKept) {
  TrialSetup broken = setup(false);
  broken.own_device = [] { return std::make_unique<BrokenDevice>(); };
  TrialSession session(broken);
  session.start();
  wait(session);
  EXPECT_NE(session.fault().find("no position and rotation"), std::string::npos) << session.fault();
  session.reset();
  wait(session);
  EXPECT_NE(session.fault(), "");
  const TrialOutcome outcome = session.finish("ended");
  EXPECT_NE(outcome.fault.find("at 0.300 s the device sent a pose that is no position and rotation"), std::string::npos) << outcome.fault;
  EXPECT_NE(outcome.fault.find(" in fault.csv"), std::string::npos) << outcome.fault;
  EXPECT_EQ(outcome.fault.find('/'), std::string::npos) << "no folder: " << outcome.fault;
  const std::string csv = text_of(box_ / "out" / "fault.csv");
  EXPECT_EQ(csv, text_of(box_ / "out" / "before-reset-1.fault.csv"));
  EXPECT_EQ(csv.rfind("tick,time_s,faults,state,", 0), 0u);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 51);
  EXPECT_NE(csv.find("\n251,0.251000,,tracking,1,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\n300,0.300000,device_pose,lost,1,"), std::string::npos) << csv;
  const curricula::TrialLog log = curricula::read_trial_log(outcome.log);
  EXPECT_FALSE(log.ticks[500].device_valid) << "paused until the hand has held still at the tool";
  EXPECT_EQ(log.ticks.back().faults, 0u) << "it went on";
  EXPECT_EQ(log.ticks[310].displayed_force_n, (std::array<double, 3>{0, 0, 0}));
}

TEST_F(Session, WithoutAFaultThereIsNoFaultFile) {
  TrialSession session(setup(false));
  session.start();
  wait(session);
  EXPECT_EQ(session.finish("ended").fault, "");
  EXPECT_FALSE(fs::exists(box_ / "out" / "fault.csv"));
}

TEST_F(SessionRealTime, AbandonedItKeepsAnIncompleteLogAndNoScore) {
  {
    TrialSession session(setup(true));
    session.start();
    for (int i = 0; i < 3000 && session.latest().ticks < 300; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const curricula::TrialLog log = curricula::read_trial_log(box_ / "out");
  EXPECT_FALSE(log.footer.complete);
  EXPECT_GE(log.ticks.size(), 200u);
  EXPECT_FALSE(fs::exists(box_ / "out" / "score.json"));
}

TEST_F(SessionRealTime, EndedByThePersonSaysSo) {
  TrialSession session(setup(true));
  session.start();
  for (int i = 0; i < 3000 && session.latest().ticks < 100; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const TrialOutcome outcome = session.finish("ended by the trainee");
  const curricula::TrialLog log = curricula::read_trial_log(outcome.log);
  EXPECT_TRUE(log.footer.complete);
  EXPECT_EQ(log.footer.ended, "ended by the trainee");
  for (const fs::path& file : {outcome.log, outcome.score_json, outcome.report, outcome.force_plot}) {
    EXPECT_TRUE(fs::exists(file)) << file;
  }
}

}  // namespace
}  // namespace vallecula::gui::test
