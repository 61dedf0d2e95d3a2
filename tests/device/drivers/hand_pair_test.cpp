// The file of two scripted hands.
#include "device/drivers/hand_pair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace vallecula::device::test {
namespace {

namespace fs = std::filesystem;

class HandPairFile : public ::testing::Test {
 protected:
  ~HandPairFile() override {
    std::error_code ignored;
    fs::remove(file_, ignored);
  }
  const fs::path& write(const std::string& text) {
    std::ofstream(file_) << text;
    return file_;
  }
  std::string refused(const std::string& text) {
    try {
      read_hand_pair(write(text));
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "";
  }
  const fs::path file_ = fs::path(::testing::TempDir()) /
                         (std::string("pair-") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv");
};

const std::string kHeader = "t,x,y,z,qw,qx,qy,qz,x2,y2,z2,qw2,qx2,qy2,qz2,actions\n";

TEST_F(HandPairFile, HoldsBothHandsTheirFaultsAndWhatTheyAskFor) {
  const HandPair pair = read_hand_pair(write("# hand stiffness_n_m 500\n# fault unplugged 1 2\n# second-fault motor_warm 3 4\n" +
                                             kHeader + "0,1,2,3,1,0,0,0,4,5,6,0,1,0,0,\n" +
                                             "0.5,1,2,3,1,0,0,0,4,5,7,0,1,0,0,breath+press\n" +
                                             "2,1,2,4,1,0,0,0,4,5,8,0,1,0,0,breath+press\n" +
                                             "3,1,2,5,1,0,0,0,4,5,9,0,1,0,0,-\n"));
  ASSERT_EQ(pair.blade.keyframes.size(), 4u);
  ASSERT_EQ(pair.tube.keyframes.size(), 4u);
  EXPECT_EQ(pair.blade.keyframes[3].position_m[2], 5.0);
  EXPECT_EQ(pair.tube.keyframes[3].position_m[2], 9.0);
  EXPECT_EQ(pair.tube.keyframes[1].rotation_wxyz[1], 1.0);
  EXPECT_EQ(pair.blade.hand.stiffness_n_m, 500.0);
  EXPECT_EQ(pair.tube.hand.stiffness_n_m, 500.0);
  ASSERT_EQ(pair.blade.faults.size(), 1u);
  EXPECT_EQ(pair.blade.faults[0].fault, DeviceFault::unplugged);
  ASSERT_EQ(pair.tube.faults.size(), 1u);
  EXPECT_EQ(pair.tube.faults[0].fault, DeviceFault::motor_warm);
  EXPECT_EQ(pair.tube.faults[0].from_s, 3.0);
  const std::uint32_t both = actions_of("breath") | actions_of("press");
  EXPECT_EQ(pair.actions.at(-1), 0u);
  EXPECT_EQ(pair.actions.at(0.499), 0u);
  EXPECT_EQ(pair.actions.at(0.5), both);
  EXPECT_EQ(pair.actions.at(2.9), both);
  EXPECT_EQ(pair.actions.at(3.0), 0u);
  EXPECT_EQ(pair.actions.changes().size(), 3u) << "rows that change nothing are none";
}

TEST_F(HandPairFile, IsToldFromOneHandsFile) {
  EXPECT_TRUE(is_hand_pair(write("# remark\n\n" + kHeader)));
  EXPECT_FALSE(is_hand_pair(write("t,x,y,z,qw,qx,qy,qz\n0,1,2,3,1,0,0,0\n")));
  EXPECT_FALSE(is_hand_pair(write("")));
  EXPECT_FALSE(is_hand_pair(file_.string() + ".none"));
}

TEST_F(HandPairFile, SaysWhatIsWrongAndWhere) {
  const std::string good = "0,1,2,3,1,0,0,0,4,5,6,0,1,0,0,\n";
  EXPECT_NE(refused(kHeader + good + "1,1,2,3,1,0,0,0,4,5,6,0,1,0,0,dance\n").find("line 3: there is no action 'dance'"),
            std::string::npos);
  EXPECT_NE(refused(kHeader + "0,1,2,3,1,0,0,0\n").find("line 2: 8 columns"), std::string::npos);
  EXPECT_NE(refused(good + "1,1,2,3,1,0,0,0,4,x,6,0,1,0,0,\n").find("(second hand), line 2: column 3 is 'x'"),
            std::string::npos);
  EXPECT_NE(refused(good + "1,y,2,3,1,0,0,0,4,5,6,0,1,0,0,\n").find("line 2: column 2 is 'y'"), std::string::npos);
  EXPECT_NE(refused(good + good).find("not later"), std::string::npos);
  EXPECT_NE(refused("# second-fault rain 1 2\n" + good).find("line 1: expected # fault KIND"), std::string::npos);
  EXPECT_NE(refused("").find("no rows"), std::string::npos);
  EXPECT_THROW(read_hand_pair(file_.string() + ".none"), DeviceError);
}

TEST(ActionPlan, RefusesTimesThatDoNotIncrease) {
  EXPECT_NO_THROW(ActionPlan({{0.0, 1}, {0.5, 0}}));
  EXPECT_THROW(ActionPlan({{0.5, 1}, {0.5, 0}}), DeviceError);
  EXPECT_THROW(ActionPlan({{std::nan(""), 1}}), DeviceError);
  EXPECT_EQ(ActionPlan().at(3.0), 0u);
}

TEST(ActionPlan, EveryWordIsABitOfItsOwn) {
  std::uint32_t all = 0;
  for (const char* word : {"breath", "suction", "press", "stylet-out", "catheter", "eye-right", "eye-left", "eye-up",
                           "eye-down", "extend"}) {
    const std::uint32_t bit = actions_of(word);
    EXPECT_EQ(bit & (bit - 1), 0u) << word;
    EXPECT_EQ(all & bit, 0u) << word;
    all |= bit;
  }
  EXPECT_EQ(actions_of("breath+suction+press+stylet-out+catheter+eye-right+eye-left+eye-up+eye-down+extend"), all);
  EXPECT_EQ(actions_of("-"), 0u);
  EXPECT_THROW(actions_of("breath,press"), DeviceError);
  EXPECT_THROW(actions_of("breath+"), DeviceError);
}

}  // namespace
}  // namespace vallecula::device::test
