// The import wizard left before it is done: nothing stays behind.
#include <iostream>
#include <random>

#include "tests/gui/window_import.h"

namespace vallecula::gui::window_test {
namespace {

TEST_F(WindowImport, CancelledAtAnyMomentItLeavesNothing) {
  const unsigned seed = std::random_device()();
  std::cout << "moments drawn with seed " << seed << std::endl;
  std::mt19937 draw(seed);
  open(series());
  ASSERT_FALSE(HasFatalFailure());
  for (int i = 0; i < 4; ++i) {
    const double until = std::uniform_real_distribution<double>(0.02, 0.95)(draw);
    share_ = 0.0;
    button(wizard().source_page(), "&Read and find the structures")->click();
    ASSERT_TRUE(wait_for([&] { return share_ >= until || wizard().step() == "check"; }, 180000));
    if (wizard().step() == "check") {  // it was over before the moment came: leave from there
      button(check(), "L&eave")->click();
      button(window_->start_page(), "New patient from a CT ...")->click();
      wizard().source_page().look_at(series());
      ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }));
      continue;
    }
    wizard().work().cancel();
    ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 60000));
    EXPECT_EQ(wizard().step(), "source") << until;
    EXPECT_EQ(wizard().work().import(), nullptr) << "the scan is let go";
    EXPECT_EQ(left_behind(), std::vector<std::string>{}) << until;
  }
}

TEST_F(WindowImport, CancelledWhileBuildingTheCheckIsThereAgain) {
  segment(series());
  ASSERT_FALSE(HasFatalFailure());
  share_ = 0.0;
  button(check(), "&Build the patient")->click();
  ASSERT_TRUE(wait_for([&] { return share_ > 0.2; }, 60000));
  wizard().work().cancel();
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 60000));
  EXPECT_EQ(wizard().step(), "check");
  EXPECT_NE(check().scene().labels(), nullptr);
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

TEST_F(WindowImport, ClosedInTheMiddleOfTheWorkItEndsCleanly) {
  open(series());
  ASSERT_FALSE(HasFatalFailure());
  share_ = 0.0;
  button(wizard().source_page(), "&Read and find the structures")->click();
  ASSERT_TRUE(wait_for([&] { return share_ > 0.3; }, 60000));
  picture("2-segment");
  window_->close();
  window_.reset();
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

}  // namespace
}  // namespace vallecula::gui::window_test
