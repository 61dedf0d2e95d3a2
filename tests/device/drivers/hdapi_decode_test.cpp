// HDAPI's numbers, against the vendor's tables and plain geometry.
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

#include "device/drivers/hdapi/hd_decode.h"

namespace vallecula::device::hdapi {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(HdapiDecode, EveryErrorIsAFaultWithAName) {
  const std::pair<unsigned int, DeviceFault> kTable[] = {
      {0x200, DeviceFault::motor_warm},         {0x201, DeviceFault::force_exceeded},
      {0x202, DeviceFault::force_exceeded},     {0x203, DeviceFault::force_exceeded},
      {0x300, DeviceFault::communication_lost}, {0x302, DeviceFault::communication_lost},
      {0x304, DeviceFault::servo_late},         {0x204, DeviceFault::driver_error},
      {0x104, DeviceFault::driver_error},       {0x501, DeviceFault::driver_error},
      {0x600, DeviceFault::driver_error}};
  std::set<std::string> names;
  for (const auto& [code, fault] : kTable) {
    EXPECT_EQ(fault_of(code), fault) << std::hex << code;
    names.insert(name_of(code));
    EXPECT_FALSE(mend_of(code).empty());
  }
  EXPECT_EQ(names.size(), std::size(kTable));
  EXPECT_EQ(name_of(0x302), "HD_COMM_ERROR");
  EXPECT_EQ(fault_of(0), DeviceFault::none);
  for (unsigned int code = 1; code < 0x1000; ++code) ASSERT_NE(fault_of(code), DeviceFault::none) << std::hex << code;
  EXPECT_EQ(name_of(0x999), "error 0x999");
}

TEST(HdapiDecode, OnlyOkIsCalibrated) {
  EXPECT_EQ(calibration_of(0x5000), Calibration::good);
  EXPECT_EQ(calibration_of(0x5001), Calibration::needs_update);
  EXPECT_EQ(calibration_of(0x5002), Calibration::needs_hand);
  EXPECT_EQ(calibration_of(0), Calibration::needs_hand);
  EXPECT_EQ(calibration_of(0x5003), Calibration::needs_hand);
}

/// The columns of the transform are where the quaternion carries the axes to.
TEST(HdapiDecode, EveryRotationComesBack) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<Rotation> turns = {{1, 0, 0, 0},         {0, 1, 0, 0},    {0, 0, 1, 0},       {0, 0, 0, 1},
                                 {0.5, 0.5, 0.5, 0.5}, {1e-9, 1, 0, 0}, {1e-9, 0, -1, 1e-9}};
  for (int i = 0; i < 2000; ++i) turns.push_back({normal(random), normal(random), normal(random), normal(random)});
  for (const Rotation& turn : turns) {
    const Rotation q = normalised(turn);
    const Vector x = rotate(q, {1, 0, 0}), y = rotate(q, {0, 1, 0}), z = rotate(q, {0, 0, 1});
    const double m[16] = {x[0], x[1], x[2], 0, y[0], y[1], y[2], 0, z[0], z[1], z[2], 0, 12.0, -7.0, 30.0, 1};
    const auto pose = pose_of(m, {2.0, 3.0, -10.0});
    ASSERT_TRUE(pose.has_value());
    EXPECT_NEAR(std::abs(dot(pose->rotation, q)), 1.0, 1e-12);
    EXPECT_LT(length(subtract(rotate(pose->rotation, {1, 2, 3}), rotate(q, {1, 2, 3}))), 1e-12);
    EXPECT_LT(length(subtract(pose->position_m, {0.010, -0.010, 0.040})), 1e-15);
  }
}

TEST(HdapiDecode, WhatIsNoRotationIsRefused) {
  const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  ASSERT_TRUE(pose_of(identity, {0, 0, 0}).has_value());
  for (int i = 0; i < 16; ++i) {
    for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
      double m[16];
      std::copy(identity, identity + 16, m);
      m[i] = bad;
      EXPECT_FALSE(pose_of(m, {0, 0, 0}).has_value()) << i;
    }
  }
  const double zero[16] = {};
  const double mirrored[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};
  const double stretched[16] = {1, 0, 0, 0, 0, 1.05, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const double sheared[16] = {1, 0, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_FALSE(pose_of(zero, {0, 0, 0}).has_value());
  EXPECT_FALSE(pose_of(mirrored, {0, 0, 0}).has_value());
  EXPECT_FALSE(pose_of(stretched, {0, 0, 0}).has_value());
  EXPECT_FALSE(pose_of(sheared, {0, 0, 0}).has_value());
}

TEST(HdapiDecode, TheHottestMotorCounts) {
  const double t[] = {0.2, 0.7, 0.1}, strange[] = {-3.0, kNan, 5.0}, nothing[] = {kNan, kNan, kNan};
  EXPECT_EQ(warmth_of(t, 3), 0.7);
  EXPECT_EQ(warmth_of(t, 1), 0.2);
  EXPECT_EQ(warmth_of(strange, 3), 1.0);
  EXPECT_LT(warmth_of(nothing, 3), 0.0);
}

TEST(HdapiDecode, ALoopThatStandsStillIsLateAndThenLost) {
  for (const double fine : {-1.0, 0.0, 0.001, 0.0499}) EXPECT_EQ(fault_of_standing(fine), DeviceFault::none) << fine;
  for (const double late : {0.0501, 0.4999}) EXPECT_EQ(fault_of_standing(late), DeviceFault::servo_late) << late;
  for (const double lost : {0.5001, 1e9}) EXPECT_EQ(fault_of_standing(lost), DeviceFault::communication_lost) << lost;
}

TEST(HdapiDecode, TheForceNeverExceedsThePeakAndKeepsItsDirection) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 10.0);
  for (int i = 0; i < 10000; ++i) {
    const Vector asked{normal(random), normal(random), normal(random)};
    const Vector shown = shortened_or_zero(asked, 7.9);
    ASSERT_LE(length(shown), 7.9);
    ASSERT_NEAR(shown[0] * asked[1], shown[1] * asked[0], 1e-9);
    ASSERT_NEAR(shown[1] * asked[2], shown[2] * asked[1], 1e-9);
    ASSERT_GE(shown[0] * asked[0], 0.0);
    ASSERT_EQ(shown == asked, length(asked) <= 7.9);
  }
  EXPECT_EQ(shortened_or_zero({1.7e308, 1.7e308, 0}, 7.9), (Vector{0, 0, 0}));  // its length is no number
  EXPECT_EQ(shortened_or_zero({kNan, 0, 0}, 7.9), (Vector{0, 0, 0}));
  EXPECT_EQ(shortened_or_zero({1, 0, 0}, 0.0), (Vector{0, 0, 0}));
  EXPECT_EQ(shortened_or_zero({1, 0, 0}, kNan), (Vector{0, 0, 0}));
}

}  // namespace
}  // namespace vallecula::device::hdapi
