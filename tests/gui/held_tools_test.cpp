// One hand, two tools: nothing jumps when the hand changes, and what is moved is moved as the hand moves.
#include "gui/session/held_tools.h"

#include <gtest/gtest.h>

namespace vallecula::gui::test {
namespace {

using engine::Pose;
using engine::Quat;
using engine::Vec3;

Pose pose(const Vec3& at, double angle, const Vec3& axis) {
  return {at, Quat(Eigen::AngleAxisd(angle, axis.normalized()))};
}
double apart(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() + a.rotation.angularDistance(b.rotation);
}

const Pose kTube = pose({0.1, -0.2, 0.05}, 1.1, {1, 2, 3});

TEST(HeldTools, AtFirstTheBladeIsWhereTheDeviceIsToTheBit) {
  HeldTools tools(kTube);
  const Pose device = pose({0.01, 0.02, 0.03}, 0.7, {0, 1, 1});
  tools.follow(device);
  EXPECT_EQ(tools.in_hand(), Tool::blade);
  EXPECT_EQ(tools.blade().position, device.position);
  EXPECT_EQ(tools.blade().rotation.coeffs(), device.rotation.coeffs());
  EXPECT_EQ(apart(tools.tube(), kTube), 0.0);
}

TEST(HeldTools, NothingJumpsAtAChangeAndTheOtherStaysWhereItWasLeft) {
  HeldTools tools(kTube);
  const Pose left = pose({0.01, 0.02, 0.03}, 0.7, {0, 1, 1});
  tools.follow(left);
  tools.change(left);
  EXPECT_EQ(tools.in_hand(), Tool::tube);
  EXPECT_LT(apart(tools.tube(), kTube), 1e-12);
  tools.follow(left);
  EXPECT_LT(apart(tools.tube(), kTube), 1e-9) << "the hand has not moved";
  // Moved by 5 mm and turned by 0.3 rad about an axis of the world: so is the tube, where it is.
  const Quat turn(Eigen::AngleAxisd(0.3, Vec3(1, 0, 1).normalized()));
  const Pose moved{left.position + Vec3(0.003, 0, 0.004), turn * left.rotation};
  tools.follow(moved);
  EXPECT_LT((tools.tube().position - (kTube.position + Vec3(0.003, 0, 0.004))).norm(), 1e-12);
  EXPECT_LT(tools.tube().rotation.angularDistance(turn * kTube.rotation), 1e-9);
  EXPECT_EQ(apart(tools.blade(), left), 0.0) << "the blade is held where it was left";
  // And back: the blade goes on from where it was, though the device is elsewhere.
  const Pose tube = tools.tube();
  tools.change(moved);
  tools.follow(moved);
  EXPECT_LT(apart(tools.blade(), left), 1e-9);
  tools.follow({moved.position + Vec3(0, 0.002, 0), moved.rotation});
  EXPECT_LT((tools.blade().position - (left.position + Vec3(0, 0.002, 0))).norm(), 1e-12);
  EXPECT_EQ(apart(tools.tube(), tube), 0.0);
}

TEST(HeldTools, TheDevicesPlaceForAToolIsTheInverse) {
  HeldTools tools(kTube);
  const Pose left = pose({0.01, 0.02, 0.03}, 0.7, {0, 1, 1}), other = pose({-0.02, 0.01, 0}, -1.3, {2, 1, 0});
  EXPECT_EQ(apart(tools.device_for(other), other), 0.0) << "as long as the tool is the device itself";
  tools.follow(left);
  tools.change(left);
  tools.follow(other);
  EXPECT_LT(apart(tools.device_for(tools.tube()), other), 1e-9);
}

TEST(HeldTools, AThousandChangesDoNotWearTheRotationsDown) {
  HeldTools tools(kTube);
  Pose device = pose({0, 0, 0}, 0.1, {1, 0, 0});
  for (int i = 0; i < 1000; ++i) {
    device = pose({1e-4 * i, 0, 0}, 0.01 * i, {1, 1, 0});
    tools.follow(device);
    tools.change(device);
  }
  EXPECT_NEAR(tools.tube().rotation.norm(), 1.0, 1e-12);
  EXPECT_NEAR(tools.blade().rotation.norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace vallecula::gui::test
