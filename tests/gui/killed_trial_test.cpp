// A trial whose program is killed is found by the next one and kept, on whichever database.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "curricula/records/records.h"
#include "curricula/trial_log.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

class KilledTrial : public ::testing::Test {
 protected:
  std::vector<std::string> trial(const std::string& out, bool realtime) const {
    std::vector<std::string> arguments = {"trial",
                                          "--patient",
                                          patient_.string(),
                                          "--scenario",
                                          curriculum_.string() + ":plain",
                                          "--device",
                                          "scripted:" + press_.string(),
                                          "--headless",
                                          "--out",
                                          (box_ / out).string()};
    if (!realtime) arguments.push_back("--asap");
    return arguments;
  }
  Sandbox box_;
  fs::path patient_ = write_block_patient(box_.folder());
  fs::path press_ = write_press(box_.folder());
  fs::path curriculum_ = write_curriculum(box_.folder());
};

TEST_F(KilledTrial, IsKeptAsInterruptedByTheNextStart) {
  const fs::path part = box_ / "killed" / "trial.vtrial.part";
  const pid_t process = box_.start(trial("killed", true));
  // A block of 256 ticks and a bit: some 140 kB. The script lasts 1.2 s.
  std::error_code error;
  for (int i = 0; i < 6000 && (!fs::exists(part) || fs::file_size(part, error) < 150'000); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ::kill(process, SIGKILL);
  ASSERT_EQ(box_.wait(process).exit_code, -1) << "it was over before it was killed";
  ASSERT_TRUE(fs::exists(part));

  const Outcome next = box_.run(trial("next", false));
  ASSERT_EQ(next.exit_code, 0) << next.err;
  EXPECT_NE(next.err.find("kept as interrupted"), std::string::npos) << next.err;
  EXPECT_FALSE(fs::exists(part));
  const curricula::TrialLog log = curricula::read_trial_log(box_ / "killed");
  EXPECT_EQ(log.footer.ended, "interrupted");
  EXPECT_GE(log.ticks.size(), 256u);
  for (const char* name : {"score.json", "force.png", "report.html"})
    EXPECT_TRUE(fs::exists(box_ / "killed" / name)) << name << ": as a finished trial has it";
  const Outcome verified = box_.run({"replay", (box_ / "killed").string(), "--verify"});
  EXPECT_NE(verified.err.find(std::to_string(log.ticks.size()) + " ticks are bit-identical"), std::string::npos)
      << verified.err;

  const auto rows = curricula::Records(box_.home() / "records.sqlite").newest(5);
  ASSERT_EQ(rows.size(), 2u);
  const auto& killed = rows[0].score.complete ? rows[1] : rows[0];
  EXPECT_EQ(killed.trial_path, (box_ / "killed" / "trial.vtrial").string());
  EXPECT_FALSE(killed.score.complete);
  EXPECT_EQ(killed.score.ticks, static_cast<long long>(log.ticks.size()));
  EXPECT_EQ(killed.log_sha256.size(), 64u);
  EXPECT_EQ(killed.station.size(), 32u);
  EXPECT_EQ(rows[0].station, rows[1].station);
  EXPECT_EQ(box_.run(trial("third", false)).err.find("interrupted"), std::string::npos) << "told once";
}

TEST_F(KilledTrial, TheRecordsAreWhereTheSettingSays) {
  const fs::path elsewhere = box_ / "lab" / "records.sqlite";
  ASSERT_EQ(box_.run(trial("out", false), {"VALLECULA_RECORDS=" + elsewhere.string()}).exit_code, 0);
  EXPECT_EQ(curricula::Records(elsewhere).newest(5).size(), 1u);
  EXPECT_FALSE(fs::exists(box_.home() / "records.sqlite"));
  const Outcome down = box_.run(trial("out", false), {"VALLECULA_RECORDS=postgresql://anna:secret@127.0.0.1:1/lab"});
  EXPECT_EQ(down.exit_code, 1);
  EXPECT_NE(down.err.find("check that the server runs"), std::string::npos) << down.err;
  EXPECT_EQ(down.err.find("secret"), std::string::npos) << down.err;
  EXPECT_EQ(down.err.find("anna"), std::string::npos) << down.err;
}

}  // namespace
}  // namespace vallecula::gui::test
