// Two devices, or one in turn, as the engine sees them.
#include "gui/session/hands_port.h"

#include <gtest/gtest.h>

#include <vector>

#include "device/drivers/scripted_device.h"

namespace vallecula::gui::test {
namespace {

using device::DeviceFault;
using device::DeviceReading;
using engine::Vec3;

/// A device that does what it is told.
class Puppet final : public device::HapticDevice {
 public:
  device::DeviceInfo info() const override {
    device::DeviceInfo info;
    info.kind = "puppet";
    info.peak_force_n = 7.9;
    info.actuated_dof = 3;
    return info;
  }
  DeviceReading read(double) noexcept override { return reading; }
  void write(const std::array<double, 3>& force_n) noexcept override { force = force_n; }
  DeviceFault fault() const noexcept override { return broken; }

  DeviceReading reading;
  DeviceFault broken = DeviceFault::none;
  std::array<double, 3> force{0, 0, 0};
};

device::GuardSettings settings() {
  device::GuardSettings settings = device::guard_for(Puppet().info());
  settings.limits.soft_start_s = 1e-3;
  return settings;
}

class HandsPortTest : public ::testing::Test {
 protected:
  /// One tick, with forces on both tools.
  engine::PortInput tick(HandsPort& port, const Vec3& on_blade = Vec3::Zero(), const Vec3& on_tube = Vec3::Zero()) {
    time_s_ += 0.001;
    const engine::PortInput input = port.read(time_s_);
    port.see_tool(input.pose);
    port.write(on_blade);
    port.write_second(on_tube);
    return input;
  }
  engine::PortInput ticks(HandsPort& port, int count, const Vec3& on_blade, const Vec3& on_tube) {
    engine::PortInput last;
    for (int i = 0; i < count; ++i) last = tick(port, on_blade, on_tube);
    return last;
  }
  static constexpr std::uint32_t kChange = 1, kOther = 2;
  const engine::Pose tube_{Vec3(0.1, 0, 0), engine::Quat::Identity()};
  Puppet blade_device_, tube_device_;
  device::GuardedDevice blade_{blade_device_, settings()}, second_{tube_device_, settings()};
  HandActions actions_;
  device::ActionPlan plan_;
  double time_s_ = 0.0;
};

TEST_F(HandsPortTest, EachDeviceMovesItsToolAndFeelsIt) {
  HandsPort port(blade_, second_, plan_, actions_);
  blade_device_.reading.position_m = {0.01, 0, 0};
  tube_device_.reading.position_m = {0, 0.02, 0};
  const engine::PortInput input = ticks(port, 200, Vec3(1, 0, 0), Vec3(0, 2, 0));
  EXPECT_EQ(input.pose.position, Vec3(0.01, 0, 0));
  EXPECT_EQ(input.second_pose.position, Vec3(0, 0.02, 0));
  EXPECT_TRUE(input.valid && input.second_valid);
  EXPECT_NEAR(blade_device_.force[0], 1.0, 1e-3);
  EXPECT_NEAR(tube_device_.force[1], 2.0, 1e-3);
  EXPECT_EQ(blade_device_.force[1], 0.0);
}

// In a pause the tissue moves the blade on, and the mouse is put there; what hung at it 3 cm away hangs there no more.
TEST_F(HandsPortTest, WhoTakesHoldAnewHasTheBladeWhereItIsAlsoAfterHandsWereChanged) {
  HandsPort port(blade_, tube_, kChange, plan_, actions_);
  blade_device_.reading.position_m = {0.01, 0, 0};
  tick(port);
  actions_.change_hand();  // the tube
  tick(port);
  blade_device_.reading.position_m = {0.04, 0, 0};
  tick(port);
  actions_.take_hold();
  const engine::PortInput tube = tick(port);
  EXPECT_NEAR(tube.second_pose.position.x(), 0.13, 1e-12) << "with the tube in the hand the blade is nobody's";
  EXPECT_NEAR(tube.pose.position.x(), 0.01, 1e-12);
  actions_.change_hand();  // and the blade again
  EXPECT_NEAR(tick(port).pose.position.x(), 0.01, 1e-12);
  blade_.freeze(true);
  const engine::Pose moved{Vec3(0.012, 0.003, -0.001), engine::Quat(0.8, 0, 0.6, 0)};
  const auto stands = [&] {
    time_s_ += 0.001;
    const engine::PortInput input = port.read(time_s_);
    port.see_tool(moved);
    port.write(Vec3::Zero());
    return input;
  };
  EXPECT_FALSE(stands().valid);
  actions_.change_hand();  // does nothing in a pause, and changes nothing of what follows
  stands();
  blade_device_.reading.position_m = {moved.position.x(), moved.position.y(), moved.position.z()};
  blade_device_.reading.rotation_wxyz = {0.8, 0, 0.6, 0};
  EXPECT_GT((stands().pose.position - moved.position).norm(), 0.01) << "it hangs at the device from where it was taken";
  actions_.take_hold();
  blade_.freeze(false);
  stands();
  blade_.confirm();
  engine::PortInput input = stands();
  for (int i = 0; i < 10 && !input.valid; ++i) input = stands();
  ASSERT_TRUE(input.valid);
  EXPECT_LT((input.pose.position - moved.position).norm(), 1e-12);
  EXPECT_LT(input.pose.rotation.angularDistance(moved.rotation), 1e-7);
  blade_device_.reading.position_m[0] += 0.002;
  EXPECT_NEAR(tick(port).pose.position.x(), moved.position.x() + 0.002, 1e-12) << "and goes with the hand from there";
}

TEST_F(HandsPortTest, EitherDevicesFaultPausesBothAndShowsNoForceOfIts) {
  HandsPort port(blade_, second_, plan_, actions_);
  ticks(port, 200, Vec3(1, 0, 0), Vec3(0, 2, 0));
  for (Puppet* broken : {&tube_device_, &blade_device_}) {
    broken->broken = DeviceFault::unplugged;
    engine::PortInput input = tick(port, Vec3(1, 0, 0), Vec3(0, 2, 0));
    EXPECT_FALSE(input.valid);
    EXPECT_FALSE(input.second_valid);
    EXPECT_EQ(broken->force, (std::array<double, 3>{0, 0, 0})) << "in the very tick";
    broken->broken = DeviceFault::none;
    input = tick(port);
    EXPECT_FALSE(input.valid || input.second_valid) << "it is back, and the hand has not confirmed";
    (broken == &tube_device_ ? second_ : blade_).confirm();
    tick(port);
    input = tick(port);
    EXPECT_TRUE(input.valid && input.second_valid);
  }
}

TEST_F(HandsPortTest, ActionsComeFromKeysAndPlanAboveTheDevicesButtons) {
  const device::ActionPlan plan({{0.005, engine::kActionSuction}, {0.010, 0}});
  HandsPort port(blade_, second_, plan, actions_);
  blade_device_.reading.buttons = 0x80000001u;  // what lies above the low 16 bits is no action
  actions_.hold(engine::kActionPress, true);
  EXPECT_EQ(tick(port).buttons, 1u | engine::kActionPress);
  time_s_ = 0.006;
  EXPECT_EQ(tick(port).buttons, 1u | engine::kActionPress | engine::kActionSuction);
  actions_.hold(engine::kActionPress, false);
  time_s_ = 0.011;
  EXPECT_EQ(tick(port).buttons, 1u);
}

TEST_F(HandsPortTest, APauseAsksForNothingThatGoesByTime) {
  HandsPort port(blade_, second_, plan_, actions_);
  actions_.hold(engine::kActionBreath, true);
  actions_.hold(engine::kActionCatheter, true);
  EXPECT_EQ(tick(port).buttons, engine::kActionBreath | engine::kActionCatheter);
  tube_device_.broken = DeviceFault::unplugged;
  EXPECT_EQ(tick(port).buttons, static_cast<std::uint32_t>(engine::kActionCatheter));
}

TEST_F(HandsPortTest, OneDeviceTakesTheToolsInTurnByKeyAndByButton) {
  HandsPort port(blade_, tube_, kChange, plan_, actions_);
  blade_device_.reading.position_m = {0.01, 0, 0};
  engine::PortInput input = ticks(port, 200, Vec3(1, 0, 0), Vec3(0, 2, 0));
  EXPECT_EQ(input.second_pose.position, tube_.position);
  EXPECT_NEAR(blade_device_.force[0], 1.0, 1e-3) << "the blade's force";
  EXPECT_EQ(blade_device_.force[1], 0.0);

  actions_.change_hand();
  input = tick(port, Vec3(1, 0, 0), Vec3(0, 2, 0));
  EXPECT_EQ(port.in_hand(), Tool::tube);
  EXPECT_LT((input.second_pose.position - tube_.position).norm(), 1e-12) << "no jump";
  blade_device_.reading.position_m = {0.01, 0.005, 0};
  input = ticks(port, 400, Vec3(1, 0, 0), Vec3(0, 2, 0));
  EXPECT_EQ(input.pose.position, Vec3(0.01, 0, 0)) << "the blade is held where it was left";
  EXPECT_LT((input.second_pose.position - (tube_.position + Vec3(0, 0.005, 0))).norm(), 1e-12);
  EXPECT_NEAR(blade_device_.force[1], 2.0, 1e-3) << "the tube's force";
  EXPECT_NEAR(blade_device_.force[0], 0.0, 1e-3);

  blade_device_.reading.buttons = kOther;
  tick(port);
  EXPECT_EQ(port.in_hand(), Tool::tube) << "another button";
  blade_device_.reading.buttons = kChange;
  tick(port);
  EXPECT_EQ(port.in_hand(), Tool::blade);
  tick(port);
  EXPECT_EQ(port.in_hand(), Tool::blade) << "held down it changes once";
}

TEST_F(HandsPortTest, ThePressThatEndsAPauseChangesNoHandAndNothingJumps) {
  HandsPort port(blade_, tube_, kChange, plan_, actions_);
  actions_.change_hand();
  tick(port);
  blade_device_.reading.position_m = {0, 0.004, 0};
  const engine::PortInput before = tick(port);
  blade_device_.broken = DeviceFault::unplugged;
  EXPECT_FALSE(tick(port).second_valid);
  blade_device_.broken = DeviceFault::none;
  tick(port);
  blade_device_.reading.buttons = kChange;
  engine::PortInput input = tick(port);
  EXPECT_TRUE(input.valid && input.second_valid);
  EXPECT_EQ(port.in_hand(), Tool::tube);
  EXPECT_LT((input.second_pose.position - before.second_pose.position).norm(), 1e-12);
  // A pose that is none is recorded, moves nothing for good and changes no hand.
  blade_device_.reading.buttons = 0;
  tick(port);
  const auto good = blade_device_.reading.position_m;
  blade_device_.reading.position_m[0] = std::nan("");
  actions_.change_hand();
  tick(port);
  blade_device_.reading.position_m = good;
  ticks(port, 3, Vec3::Zero(), Vec3::Zero());
  blade_.confirm();
  tick(port);
  input = tick(port);
  EXPECT_TRUE(input.valid);
  EXPECT_TRUE(input.second_pose.position.allFinite());
  EXPECT_LT((input.second_pose.position - before.second_pose.position).norm(), 1e-12);
}

device::Trajectory lead() {
  device::Keyframe from, to;
  from.position_m = {0.2, 0, 0};
  to.position_m = {0.2, 0.05, 0};
  to.time_s = 1.0;
  to.rotation_wxyz = {0.70710678118654752, 0.70710678118654752, 0, 0};
  return device::Trajectory({from, to});
}

TEST_F(HandsPortTest, ABladeThatNoHandHasComesBackToItsPlaceAfterAPauseFromWhereItIs) {
  HandsPort port(blade_, tube_, kChange, plan_, actions_);
  const Vec3 left(0.01, 0.02, 0.03), pushed = left + Vec3(0, 0.0045, 0);
  blade_device_.reading.position_m = {left.x(), left.y(), left.z()};
  tick(port);
  actions_.change_hand();
  EXPECT_EQ(tick(port).pose.position, left);
  EXPECT_EQ(port.in_hand(), Tool::tube);
  const auto seen_at = [&](const Vec3& at) {
    time_s_ += 0.001;
    const engine::PortInput input = port.read(time_s_);
    port.see_tool({at, engine::Quat::Identity()});
    port.write(Vec3::Zero());
    port.write_second(Vec3::Zero());
    return input;
  };
  blade_.freeze(true);
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(seen_at(pushed).valid);
  blade_.freeze(false);
  seen_at(pushed);
  blade_.confirm();
  const engine::PortInput first = seen_at(pushed);
  ASSERT_TRUE(first.valid);
  EXPECT_LT((first.pose.position - pushed).norm(), 1e-9) << "it hangs nowhere but where it is";
  Vec3 before = first.pose.position;
  for (int i = 1; i < 1000; ++i) {
    const Vec3 now = seen_at(pushed).pose.position;
    ASSERT_LT((now - before).norm(), 1e-5) << "nothing jumps";
    ASSERT_LE((now - left).norm(), (before - left).norm());
    before = now;
  }
  seen_at(left);
  EXPECT_EQ(seen_at(left).pose.position, left) << "where it was left";
}

TEST_F(HandsPortTest, ALedBladeIsTakenOverWithoutAJumpWhereverTheHandIs) {
  HandsPort port(blade_, plan_, actions_);
  port.lead_in(lead(), 100);
  engine::Pose before;
  for (int n = 0; n < 100; ++n) {
    blade_device_.reading.position_m = {0.001 * n, -0.002 * n, 0.3};  // nobody asks where the hand is
    EXPECT_TRUE(port.led_in());
    before = tick(port, Vec3(0, 0, 2)).pose;
    if (port.led_in()) {
      EXPECT_EQ(blade_device_.force, (std::array<double, 3>{0, 0, 0})) << "what the plan meets is not the hand's";
    }
    EXPECT_NEAR(before.position.x(), 0.2, 1e-12);
  }
  EXPECT_FALSE(port.led_in());
  EXPECT_NEAR(before.position.y(), 0.05, 1e-12);
  engine::PortInput at = tick(port);
  EXPECT_LT((at.pose.position - before.position).norm(), 1e-12);
  EXPECT_LT(at.pose.rotation.angularDistance(before.rotation), 1e-7);
  // From there it goes as the hand does, and turns as it does, about the axes of the world.
  blade_device_.reading.position_m[1] += 0.01;
  blade_device_.reading.rotation_wxyz = {0.99875026, 0, 0, 0.04997917};  // 0.1 rad about z
  at = tick(port);
  EXPECT_LT((at.pose.position - (before.position + Vec3(0, 0.01, 0))).norm(), 1e-9);
  const engine::Quat turned = engine::Quat(Eigen::AngleAxisd(0.1, Vec3::UnitZ())) * before.rotation;
  EXPECT_LT(at.pose.rotation.angularDistance(turned), 1e-6);
  tick(port, Vec3(0, 0, 2));
  ticks(port, 300, Vec3(0, 0, 2), Vec3::Zero());
  EXPECT_NEAR(blade_device_.force[2], 2.0, 1e-6);
}

TEST_F(HandsPortTest, APauseStopsTheWayInAndTheTubeWaitsInItsPlace) {
  HandsPort port(blade_, tube_, kChange, plan_, actions_);
  port.lead_in(lead(), 100);
  ticks(port, 40, Vec3::Zero(), Vec3::Zero());
  const engine::Pose there = tick(port).pose;
  blade_device_.broken = DeviceFault::unplugged;
  engine::PortInput paused = ticks(port, 500, Vec3::Zero(), Vec3::Zero());
  EXPECT_FALSE(paused.valid);
  EXPECT_FALSE(paused.second_valid);
  EXPECT_EQ(paused.pose.position, there.position);
  blade_device_.broken = DeviceFault::none;
  tick(port);
  blade_.confirm();
  actions_.change_hand();  // not while it is led
  const engine::PortInput last = ticks(port, 59, Vec3::Zero(), Vec3::Zero());
  EXPECT_FALSE(port.led_in());
  EXPECT_EQ(port.in_hand(), Tool::blade);
  EXPECT_EQ(last.second_pose.position, tube_.position);
  EXPECT_NEAR(last.pose.position.y(), 0.05, 1e-12);
}

TEST_F(HandsPortTest, AButtonHeldAtTheHandOverChangesNoHand) {
  HandsPort port(blade_, tube_, kChange, plan_, actions_);
  port.lead_in(lead(), 10);
  blade_device_.reading.buttons = kChange;
  ticks(port, 10, Vec3::Zero(), Vec3::Zero());
  ASSERT_FALSE(port.led_in());
  ticks(port, 5, Vec3::Zero(), Vec3::Zero());
  EXPECT_EQ(port.in_hand(), Tool::blade) << "pressed before the hand had anything";
  blade_device_.reading.buttons = 0;
  tick(port);
  blade_device_.reading.buttons = kChange;
  tick(port);
  EXPECT_EQ(port.in_hand(), Tool::tube) << "pressed anew";
}

TEST_F(HandsPortTest, WhatPlaysBackWaitsForWhoeverHoldsTheTrialAndGoesOnByItself) {
  // 40 mm along x in 4 s; a breath from the 1.5th second on.
  std::vector<device::Keyframe> way(2);
  way[1].time_s = 4.0;
  way[1].position_m = {0.04, 0, 0};
  device::ScriptedDevice script(device::Trajectory(way), device::HandSettings{});
  device::GuardedDevice scripted(script, settings());
  const device::ActionPlan breath({{1.5, engine::kActionBreath}});
  HandsPort port(scripted, second_, breath, actions_);
  ticks(port, 1000, Vec3::Zero(), Vec3::Zero());
  const double before = tick(port).pose.position.x();
  EXPECT_GT(before, 0.005);
  scripted.freeze(true);
  second_.freeze(true);
  EXPECT_FALSE(ticks(port, 2000, Vec3::Zero(), Vec3::Zero()).valid);
  scripted.freeze(false);
  second_.freeze(false);
  // The tube's hand is a person's: it holds still and so takes hold again, and the script waits for it as well.
  int until = 0;
  while (!tick(port).valid) ASSERT_LT(++until, 1000);
  EXPECT_GE(until, 400) << "half a second of holding still";
  EXPECT_NEAR(port.waited_s(), 2.0 + 1e-3 * until, 3e-3);
  const engine::PortInput on = tick(port);
  EXPECT_NEAR(on.pose.position.x(), before, 5e-5) << "from where it was";
  EXPECT_EQ(on.buttons & engine::kActionBreath, 0u) << "not at the clock's 1.5 s";
  EXPECT_NE(ticks(port, 600, Vec3::Zero(), Vec3::Zero()).buttons & engine::kActionBreath, 0u);
}

TEST_F(HandsPortTest, WithoutATubeKeysAndPlanAreHeardAsWell) {
  const device::ActionPlan plan({{0.003, engine::kActionExtend}, {0.006, 0}});
  HandsPort port(blade_, plan, actions_);
  actions_.hold(engine::kActionEyeLeft, true);
  blade_device_.reading.buttons = 0xff0001;
  EXPECT_EQ(tick(port).buttons, 1u | engine::kActionEyeLeft) << "a device's own high bits are nobody's action";
  ticks(port, 3, Vec3::Zero(), Vec3::Zero());
  EXPECT_EQ(tick(port).buttons, 1u | engine::kActionEyeLeft | engine::kActionExtend);
  blade_device_.broken = DeviceFault::unplugged;
  actions_.hold(engine::kInstructorHeartDown, true);
  EXPECT_EQ(tick(port).buttons & engine::kAllActions, static_cast<std::uint32_t>(engine::kActionEyeLeft))
      << "a pause leaves the eye, and nobody changes the infant in it";
  actions_.hold(engine::kActionAided, true);
  const std::uint32_t aided = tick(port).buttons;
  EXPECT_NE(aided & engine::kActionAided, 0u) << "it is in a pause that an expert is shown";
  EXPECT_EQ(aided & engine::kAllActions, static_cast<std::uint32_t>(engine::kActionEyeLeft));
}

}  // namespace
}  // namespace vallecula::gui::test
