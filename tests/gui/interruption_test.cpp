// Long work that is interrupted says so and leaves nothing behind.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

/// Waits until the started program has said `stage` (progress is a line a stage where stderr is no terminal).
bool reaches(const Sandbox& box, const std::string& stage) {
  for (int i = 0; i < 12000; ++i) {
    if (text_of(box / "stderr").find("%  " + stage) != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

class Interruption : public ::testing::Test {
 protected:
  Interruption() { fs::create_directory(box_ / "tmp"); }

  /// Starts the work, waits for `stage`, sends `signal`: one message, exit 1, and the folder as it was before.
  void expect_clean_end(const std::vector<std::string>& arguments, const std::string& stage, int signal) {
    const std::vector<std::string> before = box_.names("");
    const pid_t process = box_.start(arguments, {"TMPDIR=" + (box_ / "tmp").string()});
    const bool reached = reaches(box_, stage);
    ::kill(process, signal);
    const auto sent = std::chrono::steady_clock::now();
    const Outcome outcome = box_.wait(process);
    const double waited_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - sent).count();
    ASSERT_TRUE(reached) << stage << ": " << outcome.err;
    EXPECT_EQ(outcome.exit_code, 1) << stage << ": " << outcome.err;
    ASSERT_EQ(outcome.messages().size(), 1u) << stage << ": " << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted; nothing was written"), std::string::npos) << outcome.err;
    EXPECT_EQ(box_.names(""), before) << stage;
    EXPECT_EQ(box_.names("tmp"), std::vector<std::string>()) << stage;
    EXPECT_LT(waited_s, 20.0) << stage << ": the longest stretch without a report is a few seconds";
  }

  Sandbox box_;
};

TEST_F(Interruption, AManikinLeavesNothing) {
  const std::vector<std::string> arguments = {"manikin", "--out", (box_ / "ct").string(), "--weight", "0.8"};
  expect_clean_end(arguments, "scanning", SIGINT);
  expect_clean_end(arguments, "writing the series", SIGTERM);
}

TEST_F(Interruption, AnImportLeavesNothing) {
  ASSERT_EQ(box_.run({"manikin", "--out", (box_ / "ct").string(), "--weight", "0.6", "--spacing", "0.6", "--slice", "1"})
                .exit_code,
            0);
  const std::vector<std::string> arguments = {"import", (box_ / "ct").string(), "--out", (box_ / "a.patient").string(),
                                              "--tets", "1000"};
  expect_clean_end(arguments, "read", SIGTERM);
  expect_clean_end(arguments, "segment: airway", SIGINT);
  expect_clean_end(arguments, "surfaces: face", SIGINT);
  expect_clean_end(arguments, "tetrahedra", SIGTERM);
  const Outcome again = box_.run(arguments);
  EXPECT_EQ(again.exit_code, 0) << "and it can be done again";
  EXPECT_NE(again.out.find("\nWithin limits ("), std::string::npos) << again.out;
  EXPECT_LT(again.out.find("tongue volume"), again.out.find("\nFor information (")) << again.out;
}

}  // namespace
}  // namespace vallecula::gui::test
