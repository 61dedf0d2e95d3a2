// A log finds its patient again and names nobody.
#include "gui/session/log_paths.h"

#include <gtest/gtest.h>

#include "curricula/trial_log.h"
#include "gui/commands/headless_application.h"
#include "gui/session/trial_session.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

TEST(LogPaths, AreSeenFromTheLogsFolder) {
  EXPECT_EQ(path_for_log("/srv/course/term.patient", "/srv/course/out"), "../term.patient");
  EXPECT_EQ(path_for_log("/srv/course/out/term.patient/", "/srv/course/out/"), "term.patient");
  EXPECT_EQ(path_for_log("/home/jane.doe/patients/a.patient", "/home/jane.doe/trials/1"), "../../patients/a.patient");
}

TEST(LogPaths, HoldNobodysFolders) {
  EXPECT_EQ(path_for_log("/home/jane.doe/a.patient", "/srv/results"), "a.patient");
  EXPECT_EQ(path_for_log("/home/jane.doe/a.patient", "/home/john/results"), "a.patient");
  EXPECT_EQ(path_for_log("/media/jane.doe/a.patient", "/media/john/results"), "a.patient");
  const fs::path home = fs::path(::getenv("HOME") != nullptr ? ::getenv("HOME") : "/root");
  EXPECT_EQ(path_for_log(home / "a.patient", home.parent_path() / "neighbour" / "results"), "a.patient");
}

TEST(LogPaths, APackageIsFoundWhereItWasBesideOrAboveTheTrial) {
  const Sandbox box;
  fs::create_directories(box / "deep/er/trial");
  const auto put = [&](const std::string& folder) {
    fs::create_directories(box / folder);
    write_text(box / folder / "patient.yaml", "");
  };
  EXPECT_EQ(package_of_log("../../p.patient", box / "deep/er/trial"), fs::path());
  put("p.patient");
  EXPECT_TRUE(fs::equivalent(package_of_log("p.patient", box / "deep/er/trial"), box / "p.patient"));
  put("deep/p.patient");
  EXPECT_TRUE(fs::equivalent(package_of_log("../../p.patient", box / "deep/er/trial"), box / "deep/p.patient"));
  EXPECT_TRUE(fs::equivalent(package_of_log((box / "p.patient").string(), box / "deep"), box / "p.patient"))
      << "as older logs say it";
}

/// The demo plays in a folder that gets its name only when all is whole.
TEST(LogPaths, ATrialThatIsMovedInPlaceNamesNoTemporaryFolderAndVerifiesThere) {
  const Sandbox box;
  ::setenv("VALLECULA_HOME", box.home().c_str(), 1);
  const fs::path aside = box / "results.part-123";
  fs::create_directory(aside);
  TrialSetup setup;
  setup.patient = write_block_patient(aside);
  setup.curriculum = write_curriculum(box.folder());
  setup.scenario = "plain";
  setup.device = "scripted:" + write_press(box.folder()).string();
  setup.realtime = false;
  {
    const HeadlessApplication application;
    for (const char* name : {"", "novice"}) {
      setup.out = aside / name;
      setup.final_out = box / "results" / name;
      TrialSession session(setup);
      session.start();
      while (!session.finished()) {
      }
      session.finish("ended");
    }
  }
  fs::rename(aside, box / "results");
  for (const char* name : {"results", "results/novice"}) {
    const curricula::LogHeader header = curricula::read_trial_log(box / name).header;
    const std::string all = text_of(box / name / "trial.vtrial");
    for (const std::string& word : {std::string("part-123"), box.folder().string(), box.folder().filename().string()})
      EXPECT_EQ(all.find(word), std::string::npos) << word << " in " << name;
    EXPECT_FALSE(fs::path(header.package_path).is_absolute());
    const Outcome verified = box.run({"replay", (box / name).string(), "--verify"});
    EXPECT_EQ(verified.exit_code, 0) << verified.err;
  }
}

}  // namespace
}  // namespace vallecula::gui::test
