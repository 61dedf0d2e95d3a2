// What the window's thread waits for when a trial begins, begins anew or begins half way: nothing.
#include <gtest/gtest.h>

#include <QSqlDatabase>
#include <QSqlQuery>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <thread>

#include "curricula/export/xapi.h"
#include "curricula/records/people.h"
#include "curricula/records/progress.h"
#include "curricula/records/records.h"
#include "curricula/trial_log.h"
#include "device/drivers/mouse_device.h"
#include "gui/commands/headless_application.h"
#include "gui/session/expert_loop.h"
#include "gui/session/scripted_hands.h"
#include "gui/session/trial_session.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Another program in the middle of a transaction.
class OtherWriter {
 public:
  explicit OtherWriter(const fs::path& file) {
    QSqlDatabase db = QSqlDatabase::addDatabase("QSQLITE", "other");
    db.setDatabaseName(QString::fromStdString(file.string()));
    if (!db.open() || !QSqlQuery(db).exec("BEGIN EXCLUSIVE")) throw std::runtime_error("the records were not to be locked");
  }
  ~OtherWriter() {
    {
      QSqlDatabase db = QSqlDatabase::database("other");
      QSqlQuery(db).exec("COMMIT");
      db.close();
    }
    QSqlDatabase::removeDatabase("other");
  }
};

class TrialStart : public ::testing::Test {
 protected:
  TrialStart() { ::setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~TrialStart() override { ::unsetenv("VALLECULA_RECORDS"); }

  TrialSetup setup(const std::string& device) {
    TrialSetup setup;
    setup.patient = patient_;
    setup.curriculum = curriculum_;
    setup.scenario = "plain";
    setup.device = device;
    setup.out = box_ / "out";
    return setup;
  }
  template <class Done>
  static bool wait_for(Done done) {
    for (int i = 0; i < 15000 && !done(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return done();
  }

  HeadlessApplication application_;
  Sandbox box_;
  fs::path patient_ = write_block_patient(box_.folder());
  fs::path curriculum_ = write_curriculum(box_.folder());
};

TEST_F(TrialStart, LockedRecordsHoldUpTheTrialAndNotItsWindow) {
  TrialSession session(setup("mouse"));
  {
    const OtherWriter other(box_.home() / "records.sqlite");
    const auto begin = Clock::now();
    session.start();
    EXPECT_LT(ms_since(begin), 100.0);
    EXPECT_TRUE(session.starting());
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_TRUE(session.starting());
    EXPECT_EQ(session.latest().ticks, 0) << "no tick before the trial is known";
    EXPECT_FALSE(session.finished());
    const auto again = Clock::now();
    session.reset();
    EXPECT_LT(ms_since(again), 5000.0) << "the records are patient for ten seconds";
    EXPECT_EQ(session.latest().ticks, 0);
  }
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 100; })) << session.problem();
  EXPECT_FALSE(session.starting());
  EXPECT_EQ(session.problem(), "");
  session.finish("ended");
  EXPECT_EQ(curricula::Records(box_.home() / "records.sqlite").newest(5).size(), 1u)
      << "what had no tick before the reset left nothing";
  EXPECT_FALSE(fs::exists(box_ / "out" / "before-reset-1.vtrial"));
}

TEST_F(TrialStart, ATrialThatCannotBeRegisteredSaysSoAndLeavesNothing) {
  TrialSession session(setup("mouse"));
  write_text(box_.folder() / "no.sqlite", std::string(4096, 'x'));
  ::setenv("VALLECULA_RECORDS", (box_.folder() / "no.sqlite").c_str(), 1);
  session.start();
  ASSERT_TRUE(wait_for([&] { return session.finished(); }));
  EXPECT_NE(session.problem().find("records"), std::string::npos) << session.problem();
  EXPECT_EQ(session.latest().ticks, 0);
  EXPECT_THROW(session.finish("ended"), std::runtime_error);
  EXPECT_FALSE(fs::exists(box_ / "out" / "trial.vtrial.part"));
  EXPECT_FALSE(fs::exists(box_ / "out" / "trial.vtrial"));
}

TEST_F(TrialStart, AtTheValleculaTheHandTakesOverWithoutAJumpAndItCountsNeitherWay) {
  TrialSession session(setup("mouse"));
  session.start();
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 50; }));
  session.reset_at_vallecula();
  EXPECT_TRUE(session.led_in());
  auto& mouse = dynamic_cast<device::MouseDevice&>(session.device());
  mouse.move(0.004, 0.0);  // while it is led, nobody hears
  ASSERT_TRUE(wait_for([&] { return !session.led_in(); }));
  const auto at = session.latest().ticks;
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > at + 100; }));
  mouse.move(0.0, 0.003);
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > at + 400; }));
  const TrialOutcome outcome = session.finish("ended");
  EXPECT_TRUE(outcome.score.at_vallecula);
  EXPECT_FALSE(outcome.score.counts());
  const curricula::TrialLog log = curricula::read_trial_log(outcome.log);
  const auto led = static_cast<std::size_t>(log.header.settings.at(curricula::kLeadInTicks));
  EXPECT_EQ(led, static_cast<std::size_t>(1000 * kLeadInS + 0.5));
  const device::Keyframe there = way_to_vallecula(session.package()).at(kLeadInS);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(log.ticks[led - 1].device_pose.position_m[a], there.position_m[a], 1e-12);
  double farthest = 0.0;
  for (std::size_t i = 1; i < log.ticks.size(); ++i)
    for (int a = 0; a < 3; ++a)
      farthest = std::max(farthest, std::abs(log.ticks[i].device_pose.position_m[a] -
                                             log.ticks[i - 1].device_pose.position_m[a]));
  EXPECT_LT(farthest, 2.6e-4) << "the mouse's own fastest is a quarter of a metre a second";
  const auto& end = log.ticks.back().device_pose.position_m;
  const double went = std::hypot(std::hypot(end[0] - there.position_m[0], end[1] - there.position_m[1]),
                                 end[2] - there.position_m[2]);
  EXPECT_GT(went, 0.001) << "and from there the hand has it";
  EXPECT_LT(went, 0.006);
  const auto rows = curricula::Records(box_.home() / "records.sqlite").newest(5);
  ASSERT_EQ(rows.size(), 2u);
  for (const auto& row : rows) {
    ASSERT_EQ(row.score.set_aside.size(), 1u);
    const bool led = row.score.set_aside[0].find("Begun at the vallecula") == 0;
    const bool no_attempt = row.score.set_aside[0].find("Neither blade nor tube entered the mouth: no attempt") == 0;
    EXPECT_NE(led, no_attempt) << "the one before the reset began nothing";
  }
  EXPECT_NE(rows[0].score.set_aside, rows[1].score.set_aside);
}

TEST_F(TrialStart, AStartThatIsResetOrEndedBeforeTheMouthIsNoAttemptOfAnybodys) {
  curricula::Records records(box_.home() / "records.sqlite");
  curricula::People people(records);
  people.create_first_instructor("Boss", "4321");
  const long long kiwi = people.register_trainee("Kiwi", "1234");
  TrialSetup practice = setup("mouse");
  practice.trainee_id = kiwi;
  TrialSession session(practice);
  session.start();
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 50; }));
  session.reset();
  ASSERT_TRUE(wait_for([&] { return session.latest().ticks > 50; }));
  const TrialOutcome outcome = session.finish(curricula::kEndedByTrainee);
  EXPECT_TRUE(outcome.score.no_attempt);
  const curricula::Who who = people.sign_in(kiwi, "1234");
  curricula::Progress progress(records);
  const auto curves = progress.curves(who, kiwi);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].trials, 0);
  EXPECT_EQ(curves[0].set_aside, 2);
  EXPECT_TRUE(progress.results(who, kiwi).empty()) << "no module's gate sees them";
  const auto trials = progress.trials(who, kiwi, 5);
  ASSERT_EQ(trials.size(), 2u);
  for (const auto& row : trials)
    for (const auto& statement : curricula::statements_of(row, {"https://example.invalid"}))
      EXPECT_EQ(statement.json.find("verbs/failed"), std::string::npos);

  TrialSetup assessed = practice;
  assessed.mode = curricula::Mode::assessment;
  assessed.out = box_ / "assessed";
  TrialSession counts(assessed);
  counts.start();
  ASSERT_TRUE(wait_for([&] { return counts.latest().ticks > 50; }));
  EXPECT_TRUE(counts.finish(curricula::kEndedByTrainee).score.counts()) << "what was begun as an assessment counts";
}

TEST_F(TrialStart, TheExpertsLoopIsComputedAsideAndStopsAtOnce) {
  TrialSession session(setup("mouse"));
  ExpertLoop loop(session);
  EXPECT_GT(loop.duration_s(), 5.0);
  EXPECT_LE(loop.duration_s(), kLoopS + 0.1);
  ASSERT_TRUE(wait_for([&] { return loop.computed_s() > 0.5 || loop.finished(); })) << loop.remark();
  const engine::Snapshot *first = loop.frame(0.0), *later = loop.frame(0.45);
  ASSERT_TRUE(first != nullptr && later != nullptr);
  EXPECT_NEAR(later->time_s - first->time_s, 0.45, 0.05);
  EXPECT_EQ(loop.frame(loop.duration_s()), first) << "it begins anew";
  EXPECT_EQ(first->soft_points.size(), 3 * session.scene().soft.nodes.size());
  const engine::Snapshot kept = *first;
  auto other = std::make_unique<ExpertLoop>(session);
  const auto begin = Clock::now();
  other.reset();
  EXPECT_LT(ms_since(begin), 2000.0) << "not the whole of its 16 s";
  EXPECT_EQ(loop.frame(0.0)->step, kept.step);
  EXPECT_EQ(loop.remark(), "");
}

}  // namespace
}  // namespace vallecula::gui::test
