// The next trial's patient, read before it is asked for.
#include "gui/pages/ready_patient.h"

#include <gtest/gtest.h>

#include <thread>

#include "curricula/scenario.h"
#include "engine/scene_data.h"
#include "gui/session/scene_from_package.h"
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

TEST_F(ReadyPatientTest, ItsSceneIsMadeOnceAndAnewOfWhatIsAnother) {
  const curricula::Scenario written =
      curricula::load_curriculum(test::write_curriculum(box_.folder())).scenarios.front();
  const pipeline::PatientPackage patient = pipeline::read_package(folder_);
  int made = 0;
  const auto scene_of = [&](const pipeline::PatientPackage& package, const curricula::Scenario& scenario) {
    made = 0;
    return ready_.scene(scene_from_package(package, scenario), [&made](const std::string&, double) { ++made; });
  };
  EXPECT_EQ(ready_.kept_scene(), nullptr);
  const auto first = scene_of(patient, written);
  EXPECT_EQ(made, 3);
  EXPECT_EQ(ready_.kept_scene(), first);
  auto softer = written;  // as a variation draws it
  softer.tongue_young_pa = 5000.0;
  const auto second = scene_of(patient, softer);
  EXPECT_EQ(made, 0) << "the same patient and blade";
  EXPECT_EQ(second->description.soft.materials[0].young_pa, 5000.0);
  EXPECT_EQ(&second->tree, &first->tree);
  auto other_blade = softer;
  other_blade.blade = written.blade == "miller-0" ? "miller-1" : "miller-0";
  EXPECT_NE(&scene_of(patient, other_blade)->tool, &first->tool);
  EXPECT_EQ(made, 1);
  auto other_patient = patient;
  other_patient.tongue.points.back()[2] += 0.01;
  EXPECT_NE(&scene_of(other_patient, other_blade)->tree, &first->tree);
  EXPECT_EQ(made, 2);
  scene_of(patient, written);
  EXPECT_EQ(made, 3) << "one scene is kept, the last";
  ready_.stop();
  EXPECT_THROW(scene_of(other_patient, written), std::runtime_error);
}

}  // namespace
}  // namespace vallecula::gui::window_test
