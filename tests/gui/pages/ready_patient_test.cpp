// The next trial's patient, read before it is asked for.
#include "gui/pages/ready_patient.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

class ReadyPatientTest : public ::testing::Test {
 protected:
  ReadyPatientTest() : folder_(test::write_block_patient(box_.folder())) {}
  test::Sandbox box_;
  fs::path folder_;
  ReadyPatient ready_;
};

TEST_F(ReadyPatientTest, IsReadOnceAndAnewOnceItsFilesAreOthers) {
  EXPECT_FALSE(ready_.has(folder_));
  const auto first = ready_.look(folder_);
  EXPECT_TRUE(ready_.has(folder_));
  EXPECT_EQ(ready_.look(folder_), first);
  EXPECT_EQ(first->package.name, pipeline::read_package(folder_).name);
  fs::last_write_time(folder_ / "patient.yaml", fs::last_write_time(folder_ / "patient.yaml") + std::chrono::seconds(2));
  EXPECT_FALSE(ready_.has(folder_));
  EXPECT_NE(ready_.look(folder_), first);
  test::write_text(folder_ / "face.vtp", "damaged");
  EXPECT_THROW(ready_.look(folder_), pipeline::PackageError) << "what was good once is no excuse";
  EXPECT_FALSE(ready_.has(folder_));
}

TEST_F(ReadyPatientTest, IsWaitedForAndLeft) {
  std::atomic<bool> began{false}, go_on{false};
  std::shared_ptr<PatientLook> made;
  std::thread maker([&] {
    made = ready_.look(folder_, [&](const std::string&, double) {
      began = true;
      while (!go_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  });
  while (!began) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  struct Left {};
  EXPECT_THROW(ready_.look(folder_, [](const std::string&, double) { throw Left(); }), Left) << "who waits may leave";
  go_on = true;
  EXPECT_NE(ready_.look(folder_), nullptr);
  maker.join();
  EXPECT_EQ(ready_.look(folder_), made) << "made once for both";
  ready_.stop();
  test::write_text(folder_ / "more.txt", "another state");
  EXPECT_THROW(ready_.look(folder_), std::runtime_error);
}

}  // namespace
}  // namespace vallecula::gui::window_test
