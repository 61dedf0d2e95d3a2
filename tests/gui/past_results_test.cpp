// What somebody has done so far, as the records have it, and what the start page says of it.
#include "curricula/records/progress.h"
#include "gui/session/past_results.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "gui/commands/headless_application.h"
#include "gui/pages/module_words.h"
#include "gui/session/trial_record.h"
#include "gui/session/trial_session.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/busy_course.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

using curricula::Mode;
using curricula::PastResult;

class PastResultsTest : public ::testing::Test {
 protected:
  PastResultsTest() { ::setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  HeadlessApplication application_;
  Sandbox box_;
};

TEST_F(PastResultsTest, OldestFirstWithModeAndDevice) {
  {
    curricula::Records records(records_location());
    EXPECT_TRUE(curricula::Progress(records).results({}, 0).empty());
  }
  TrialSetup setup;
  setup.patient = write_block_patient(box_.folder());
  setup.curriculum = write_busy_course(box_.folder());
  setup.device = "scripted:" + write_press(box_.folder()).string();
  setup.realtime = false;
  for (const auto& [scenario, mode] : {std::pair{"busy", Mode::practice}, {"helped", Mode::assessment}}) {
    setup.scenario = scenario;
    setup.mode = mode;
    setup.out = box_ / scenario;
    TrialSession session(setup);
    session.start();
    for (int i = 0; i < 6000 && !session.finished(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const TrialOutcome outcome = session.finish("ended");
    EXPECT_EQ(outcome.replay_allowed, mode == Mode::practice);
    EXPECT_FALSE(outcome.by_person);
  }
  curricula::Records records(records_location());
  const PastResults results = curricula::Progress(records).results({}, 0);
  ASSERT_EQ(results.size(), 1u);
  const auto& past = results.at("busy-course");
  ASSERT_EQ(past.size(), 2u);
  EXPECT_EQ(past[0].scenario_id, "busy");
  EXPECT_EQ(past[0].mode, Mode::practice);
  EXPECT_EQ(past[1].scenario_id, "helped");
  EXPECT_EQ(past[1].mode, Mode::assessment);
  EXPECT_EQ(past[1].device_kind, "scripted");
  EXPECT_FALSE(past[1].passed) << "a block has no glottis to see";
}

TEST_F(PastResultsTest, TheBladesHandIsTheSameWithASecondDeviceForTheTube) {
  curricula::Curriculum course;
  course.scenarios.resize(2);
  course.scenarios[0].id = "view";
  course.scenarios[1].id = "tube";
  course.scenarios[1].intubation.emplace();
  const auto with = [&](const std::string& hands) {
    std::string kinds;
    for (const PastResult& result : with_hands({{"view", "touch", Mode::practice, true, 1},
                                                {"view", "mouse", Mode::practice, true, 1},
                                                {"tube", "touch", Mode::practice, true, 1},
                                                {"tube", "touch+mouse", Mode::practice, true, 1}},
                                               course, hands))
      kinds += result.device_kind + " ";
    return kinds;
  };
  EXPECT_EQ(with("touch+mouse"), "touch+mouse mouse touch touch+mouse ");
  EXPECT_EQ(with("touch"), "touch mouse touch touch+mouse ") << "one device in turn is another way to do it";
}

TEST_F(PastResultsTest, ModulesAreSpokenOfInAFewWords) {
  const curricula::Curriculum course = curricula::load_curriculum(write_busy_course(box_.folder()));
  const auto progress = [&](const std::vector<PastResult>& past) {
    return curricula::progress_of(course, past, "mouse");
  };
  const auto nothing = progress({});
  EXPECT_EQ(progress_line(course.modules[0], nothing[0]), "no trial yet, 0 of 2 scenarios done");
  EXPECT_EQ(why_closed(course, nothing, "busy"), "");
  EXPECT_EQ(why_closed(course, nothing, "later"), "Opens after First things is mastered.");
  const PastResult passed{"busy", "mouse", Mode::practice, true, 1}, failed{"busy", "mouse", Mode::practice, false, 1};
  EXPECT_EQ(progress_line(course.modules[0], progress({failed, passed})[0]),
            "1 of 2 trials passed within 2 attempts, 1 of 2 scenarios done");
  // One success of the published rule: -0.293, mastered at -2.240 (see cusum_test).
  EXPECT_EQ(progress_line(course.modules[1], progress({{"later", "mouse", Mode::assessment, true, 1}})[1]),
            "1 of 1 trials passed within 2 attempts, 1 of 1 scenarios done, cumulative sum -0.3 (mastered at -2.2)");
  EXPECT_TRUE(mastery_rule(course.modules[0]).endsWith("Source: assumed. Not validated."));
}

}  // namespace
}  // namespace vallecula::gui::test
