// The log that one can send: what the program did, and nobody's name.
#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <thread>

#include "curricula/scenario.h"
#include "device/trajectory.h"
#include "gui/session/failure_kind.h"
#include "gui/session/program_log.h"
#include "pipeline/package/patient_package.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

TEST(ProgramLog, HidesNamesByThemselvesAndPathsWhole) {
  program_log::hide(std::string("Al"));
  program_log::hide(std::string("Zoë Tern"));
  program_log::hide(fs::path("/data/Roe Jim.patient"));
  using program_log::without_identity;
  EXPECT_EQ(without_identity("Al began a trial, Almost"), "[...] began a trial, Almost");
  EXPECT_EQ(without_identity("signed in: Zoë Tern"), "signed in: [...]");
  EXPECT_EQ(without_identity("/data/Roe Jim.patient/face.vtp: its hash is another"), "[...]: its hash is another");
  EXPECT_EQ(without_identity("Roe Jim.patient is no package"), "[...] is no package");
  EXPECT_EQ(without_identity("cannot read '/mnt/Doe Janet 1987/I 1': gone"), "cannot read '[...]': gone");
  EXPECT_EQ(without_identity("see ~/papers/x"), "see [...]");
  EXPECT_EQ(without_identity("read: /data/Miller, Anna (2)/ct; and more: no"), "read: [...]: no");
  EXPECT_EQ(without_identity("opened file:///home/x/Miller Anna/ct"), "opened [...]");
  EXPECT_EQ(without_identity("Miller, Anna.patient: the patient package is another"), "[...]: the patient package is another");
  EXPECT_EQ(without_identity("cannot read 'Doe Jim.patient', 'Roe.patient'"), "cannot read '[...]', '[...]'");
  EXPECT_EQ(without_identity("506 N/m at 24/min and/or a lift"), "506 N/m at 24/min and/or a lift") << "units stay";
}

TEST(ProgramLog, KeepsTheNewestLinesAndSavesThemWithTheirHead) {
  const Sandbox box;
  ASSERT_TRUE(program_log::begin(box / "logs"));
  program_log::note("page home");
  for (int i = 0; i < 400; ++i) program_log::note("line " + std::to_string(i) + std::string(1000, '.'));
  program_log::end();  // its lines are written then
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(box / "logs")) bytes += entry.file_size();
  EXPECT_LT(bytes, 3u * 257 * 1024);
  program_log::save(box / "sent.txt", {"Vallecula", "kept in /home/somebody/logs"});
  const std::string sent = text_of(box / "sent.txt");
  EXPECT_EQ(sent.find("Vallecula\nkept in [...]\n"), 0u) << sent.substr(0, 80);
  EXPECT_NE(sent.find("line 399."), std::string::npos);
  EXPECT_LT(sent.find("line 398."), sent.find("line 399.")) << "in their order, over the files' ends";
  EXPECT_THROW(program_log::save(box / "nowhere" / "sent.txt", {}), std::runtime_error);
}

TEST(ProgramLog, WhereNothingCanBeWrittenTheProgramGoesOn) {
  const Sandbox box;
  write_text(box / "taken", "a file, no folder");
  EXPECT_FALSE(program_log::begin(box / "taken" / "logs"));
  program_log::note("kept nowhere");
  program_log::save(box / "sent.txt", {"the head alone"});
  EXPECT_EQ(text_of(box / "sent.txt"), "the head alone\n\n") << "and no file that lies where the program was started";
}

TEST(ProgramLog, IsSavedWhileItIsWrittenAndClosed) {
  const Sandbox box;
  ASSERT_TRUE(program_log::begin(box / "logs"));
  std::thread writer([] {
    for (int i = 0; i < 500; ++i) program_log::note("line " + std::to_string(i));
  });
  std::thread sender([&] {
    for (int i = 0; i < 5; ++i) program_log::save(box / "sent.txt", {"head"});
  });
  program_log::end();
  writer.join();
  sender.join();
  EXPECT_EQ(text_of(box / "sent.txt").find("head\n"), 0u);
}

TEST(ProgramLog, AFailureIsKeptByItsKindAlone) {
  EXPECT_EQ(failure_kind(pipeline::PackageError("Miller Anna.patient: gone")), "the patient's package");
  EXPECT_EQ(failure_kind(device::DeviceError("the Falcon of Miller")), "the device");
  EXPECT_EQ(failure_kind(curricula::CurriculumError("Miller.yaml: line 3")), "the course");
  EXPECT_EQ(failure_kind(std::runtime_error("Miller")), "another cause");
}

}  // namespace
}  // namespace vallecula::gui::test
