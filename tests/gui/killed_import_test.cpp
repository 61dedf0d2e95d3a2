// An import that is killed, at whatever moment, leaves a whole package or none, and the next one clears what is left.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>

#include "pipeline/package/patient_package.h"
#include "tests/gui/program.h"

namespace vallecula::gui {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::Sandbox;

TEST(KilledImport, LeavesAWholePackageOrNone) {
  const Sandbox box;
  ASSERT_EQ(box.run({"manikin", "--out", (box / "ct").string(), "--weight", "0.6", "--spacing", "0.6", "--slice", "1"})
                .exit_code,
            0);
  fs::create_directory(box / "temporary");
  const std::vector<std::string> environment{"TMPDIR=" + (box / "temporary").string()};
  const auto package = box / "a.patient";
  const std::vector<std::string> arguments{"import", (box / "ct").string(), "--out", package.string(), "--replace", "--tets", "1000"};
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(box.run(arguments, environment).exit_code, 0);
  const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fs::remove_all(package);

  std::mt19937 random(2);
  // Each signal at any moment and near the end, at least.
  const int kills = std::getenv("VALLECULA_SLOW") != nullptr ? 60 : 6;
  const std::array<int, 3> ends{SIGKILL, SIGTERM, SIGINT};
  for (int k = 0; k < kills; ++k) {
    const bool was_there = fs::exists(package);
    const pid_t process = box.start(arguments, environment);
    // Every other one near the end, where the package is written.
    const double share = random() % 1000 / 1000.0;
    ::usleep(static_cast<useconds_t>(1e6 * whole * (k % 2 == 0 ? share : 0.85 + 0.2 * share)));
    ::kill(process, ends[k % 3]);
    const Outcome outcome = box.wait(process);
    if (fs::exists(package)) {
      EXPECT_NO_THROW(pipeline::read_package(package)) << "kill " << k;
    } else {
      EXPECT_FALSE(was_there) << "kill " << k << ": what was there is not lost";
      EXPECT_NE(outcome.exit_code, 0);
    }
    EXPECT_TRUE(fs::is_empty(box / "temporary")) << "kill " << k;
  }
  ASSERT_EQ(box.run(arguments, environment).exit_code, 0);
  EXPECT_NO_THROW(pipeline::read_package(package));
  for (const auto& entry : fs::directory_iterator(box.folder()))
    EXPECT_NE(entry.path().filename().string()[0], '.') << "left aside: " << entry.path().filename();
}

TEST(KilledImport, APackageIsReplacedOnlyWhenAsked) {
  const Sandbox box;
  fs::create_directory(box / "a.patient");
  std::ofstream(box / "a.patient" / "patient.yaml") << "someone's";
  const Outcome outcome = box.run({"import", (box / "ct").string(), "--out", (box / "a.patient").string()});
  EXPECT_EQ(outcome.exit_code, 1);
  ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
  EXPECT_NE(outcome.messages()[0].find("--replace"), std::string::npos);
  EXPECT_EQ(box.run({"import", "ct", "--out", "b.patient", "--tets", "999"}).exit_code, 2);
  EXPECT_EQ(box.run({"import", "ct", "--out", "b.patient", "--tets", "100001"}).exit_code, 2);
}

}  // namespace
}  // namespace vallecula::gui
