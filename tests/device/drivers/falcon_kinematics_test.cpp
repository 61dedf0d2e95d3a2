// The inverse against legs built link by link, the way back against the inverse, the derivative against differences,
// the torques against the work they do.
#include "device/drivers/falcon/falcon_kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vallecula::device::falcon {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

double dot3(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Every 4 mm of the cube in which it is meant to be used, but for the corners no leg reaches.
template <class Visit>
int over_workspace(Visit visit) {
  constexpr int kSteps = 25;
  int visited = 0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      for (int k = 0; k <= kSteps; ++k) {
        const auto at = [](int n) { return kWorkspace * (static_cast<double>(n) / kSteps - 0.5); };
        const Vector position{at(i), at(j), at(k)};
        if (!angles_by_position(position)) continue;
        visit(position);
        ++visited;
      }
    }
  }
  return visited;
}

/// The lengths as measured (DEVICE drawings' letters), typed anew: the code's own are not to be trusted here.
constexpr double a = 0.060, b = 0.1025, c = 0.01443, d = 0.01125, e = 0.01125, f = -0.025, r = 0.040, s = -0.02309;

/// The grip by walking along one leg, in quaternions: arm angle, parallelogram angle in the leg's plane, and to the
/// side.
Vector walk(int leg, double theta, double plane, double side) {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Rotation base = about_axis(z, (90.0 - 120.0 * leg + 15.0) * M_PI / 180.0);
  // In the leg's frame an angle grows from u to w: a turn about -v.
  const Rotation arm = multiply(base, about_axis(y, -theta));
  const Rotation shin = multiply(base, about_axis(y, -plane));
  const Rotation bars = multiply(shin, about_axis(z, M_PI / 2.0 - side));  // side is the angle from the v axis
  Vector place = add(rotate(base, {r, s, 0}), rotate(arm, scale(x, a)));
  place = add(place, rotate(shin, scale(x, e)));
  place = add(place, rotate(bars, scale(x, b)));
  place = add(place, rotate(shin, scale(x, d)));
  place = add(place, rotate(base, {-c, -f, 0}));
  return subtract(place, {0, 0, kMiddleZ});
}

TEST(FalconKinematics, InverseFindsTheAngleOfALegBuiltLinkByLink) {
  std::mt19937 random(7);
  int compared = 0;
  for (int n = 0; n < 30000; ++n) {
    const int leg = n % 3;
    const double theta = uniform(random, -0.7, 1.8), side = uniform(random, 1.0, 2.1);
    const double plane = theta + uniform(random, 0.15, 2.9);  // the knee outwards
    const auto angles = leg_angles(walk(leg, theta, plane, side));
    if (!angles) continue;  // the other two legs do not reach there
    ++compared;
    double off = (*angles)[leg] - theta;
    off -= 2.0 * M_PI * std::round(off / (2.0 * M_PI));
    EXPECT_NEAR(off, 0.0, 1e-12);
  }
  EXPECT_GT(compared, 5000);
}

/// The three legs meet in one grip: walking each of them by the angles of the inverse, with the passive angles found by
/// bisection on the grip's distance, ends at the same place.
TEST(FalconKinematics, TheThreeLegsClose) {
  std::mt19937 random(11);
  for (int n = 0; n < 300; ++n) {
    const Vector position{uniform(random, -0.04, 0.04), uniform(random, -0.04, 0.04), uniform(random, -0.04, 0.03)};
    const auto angles = leg_angles(position);
    ASSERT_TRUE(angles);
    for (int leg = 0; leg < 3; ++leg) {
      // The side angle from the offset along the leg's v axis, which grows with cos(side) alone; then the plane angle.
      const Rotation base = about_axis({0, 0, 1}, (90.0 - 120.0 * leg + 15.0) * M_PI / 180.0);
      const Vector v = rotate(base, {0, 1, 0});
      double low = 0.0, high = M_PI;
      for (int i = 0; i < 60; ++i) {
        const double side = 0.5 * (low + high);
        const double at = dot3(walk(leg, (*angles)[leg], (*angles)[leg] + 1.0, side), v);
        (at > dot3(position, v) ? low : high) = side;
      }
      const double side = 0.5 * (low + high);
      double best = 1.0;
      for (int turn = 0; turn < 4; ++turn) {  // golden section on the distance from four beginnings
        double from = (*angles)[leg] + 0.8 * turn, to = from + 0.8;
        for (int i = 0; i < 80; ++i) {
          const double m = from + 0.382 * (to - from), o = from + 0.618 * (to - from);
          const double dm = length(subtract(walk(leg, (*angles)[leg], m, side), position));
          const double d_o = length(subtract(walk(leg, (*angles)[leg], o, side), position));
          (dm < d_o ? to : from) = dm < d_o ? o : m;
        }
        best = std::min(best, length(subtract(walk(leg, (*angles)[leg], 0.5 * (from + to), side), position)));
      }
      EXPECT_LT(best, 1e-7) << "leg " << leg;  // golden section sees the root of its distance to half the digits
    }
  }
}

TEST(FalconKinematics, ThereAndBackOverTheWholeWorkspace) {
  double worst_from_middle = 0.0, worst_from_near = 0.0;
  int failed = 0;
  const int visited = over_workspace([&](const Vector& position) {
    const Angles angles = *leg_angles(position);
    const auto back = position_of(angles);
    failed += !back.has_value();
    if (!back) return;
    worst_from_middle = std::max(worst_from_middle, length(subtract(*back, position)));
    const auto tracked = position_of(angles, add(position, {0.002, -0.001, 0.0015}));
    failed += !tracked.has_value();
    if (tracked) worst_from_near = std::max(worst_from_near, length(subtract(*tracked, position)));
  });
  EXPECT_EQ(failed, 0);
  EXPECT_GT(visited, 26 * 26 * 26 * 9 / 10);
  EXPECT_LT(worst_from_middle, 1e-9);
  EXPECT_LT(worst_from_near, 1e-9);
  std::printf("there and back: %d places, worst %.1e m from the middle, %.1e m from near\n", visited, worst_from_middle,
              worst_from_near);
}

TEST(FalconKinematics, DerivativeIsThatOfTheInverse) {
  double worst = 0.0;
  over_workspace([&](const Vector& position) {
    const Matrix rows = *angles_by_position(position);
    constexpr double kStep = 1e-6;
    double largest = 0.0;
    for (const Vector& row : rows) largest = std::max(largest, length(row));
    if (largest > 200.0) return;  // next to a stretched leg differences say nothing
    for (int axis = 0; axis < 3; ++axis) {
      Vector more = position, less = position;
      more[axis] += kStep;
      less[axis] -= kStep;
      const auto high = leg_angles(more), low = leg_angles(less);
      if (!high || !low) continue;
      for (int leg = 0; leg < 3; ++leg)
        worst = std::max(worst, std::abs(((*high)[leg] - (*low)[leg]) / (2.0 * kStep) - rows[leg][axis]));
    }
  });
  EXPECT_LT(worst, 1e-3);  // of some 17 rad/m; the difference's own error: step^2 times the third derivative (1e9)
}

/// Virtual work: what the motors do along the change of their angles is what the force does along any way of the grip.
TEST(FalconKinematics, TorquesDoTheForcesWork) {
  std::mt19937 random(3);
  for (int n = 0; n < 2000; ++n) {
    const Vector position{uniform(random, -0.04, 0.04), uniform(random, -0.04, 0.04), uniform(random, -0.04, 0.03)};
    const Vector force{uniform(random, -8, 8), uniform(random, -8, 8), uniform(random, -8, 8)};
    const Vector way{uniform(random, -1e-5, 1e-5), uniform(random, -1e-5, 1e-5), uniform(random, -1e-5, 1e-5)};
    const auto torques = leg_torques(position, force);
    ASSERT_TRUE(torques);
    const Angles before = *leg_angles(subtract(position, way)), after = *leg_angles(add(position, way));
    EXPECT_NEAR(dot3(*torques, subtract(after, before)), 2.0 * dot3(force, way), 1e-8);  // of 1e-4 J
  }
}

TEST(FalconKinematics, TheMiddleIsSymmetric) {
  const Angles middle = *leg_angles({0, 0, 0});
  EXPECT_NEAR(middle[0], middle[1], 1e-12);
  EXPECT_NEAR(middle[0], middle[2], 1e-12);
  const Angles pulled = *leg_angles({0, 0, 0.01});
  for (int leg = 0; leg < 3; ++leg) EXPECT_GT(pulled[leg], middle[leg]);  // towards the person: larger angles
  const auto zero = position_of({leg_angle(0), leg_angle(0), leg_angle(0)});
  ASSERT_TRUE(zero);
  EXPECT_NEAR((*zero)[0], 0.0, 1e-9);
  EXPECT_NEAR((*zero)[1], 0.0, 1e-9);
  EXPECT_LT(std::abs((*zero)[2]), 0.015);  // encoders at zero: near the middle
}

TEST(FalconKinematics, MotorsAreScaledTogether) {
  std::mt19937 random(5);
  int scaled = 0;
  for (int n = 0; n < 20000; ++n) {
    const double size = std::pow(10.0, uniform(random, -3, 2));
    const Vector torques{uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
    const auto commands = motor_commands(torques);
    const double wanted = std::max({std::abs(torques[0]), std::abs(torques[1]), std::abs(torques[2])}) / kTorquePerUnit;
    const double share = std::min(1.0, kMostMotor / wanted);
    scaled += share < 1.0;
    for (int leg = 0; leg < 3; ++leg) {
      EXPECT_LE(std::abs(commands[leg]), kMostMotor);
      EXPECT_NEAR(commands[leg], -torques[leg] / kTorquePerUnit * share, 0.5 + 1e-9);  // rounded to a unit
    }
  }
  EXPECT_GT(scaled, 1000);
}

TEST(FalconKinematics, WhatIsNotANumberGivesNoForce) {
  const std::array<std::int16_t, 3> none{0, 0, 0};
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vector torques{0.1, 0.1, 0.1}, place{0, 0, 0};
      torques[axis] = place[axis] = bad;
      EXPECT_EQ(motor_commands(torques), none);
      EXPECT_FALSE(leg_angles(place));
      EXPECT_FALSE(angles_by_position(place));
      EXPECT_FALSE(leg_torques(place, {1, 0, 0}));
      EXPECT_FALSE(position_of({bad, 0.5, 0.5}));
      EXPECT_FALSE(position_of({0.5, 0.5, 0.5}, place));
    }
  }
  EXPECT_EQ(motor_commands({1e300, 0, 0})[0], -kMostMotor);
  EXPECT_FALSE(leg_angles({0, 0, 0.2}));
}

/// No three counts an encoder can tell make the way back hang or return a place that has not these angles.
TEST(FalconKinematics, AnyEncodersEndInTheirPlaceOrInNone) {
  std::mt19937 random(13);
  int found = 0;
  for (int n = 0; n < 100000; ++n) {
    const int reach = n % 2 == 0 ? 1600 : 32767;
    Angles angles{};
    for (double& angle : angles)
      angle = leg_angle(static_cast<std::int16_t>(std::uniform_int_distribution<int>(-reach, reach)(random)));
    const auto position = position_of(angles);
    if (!position) continue;
    ++found;
    const Angles again = *leg_angles(*position);
    for (int leg = 0; leg < 3; ++leg) EXPECT_NEAR(again[leg], angles[leg], 1e-9);
  }
  EXPECT_GT(found, 10000);
}

}  // namespace
}  // namespace vallecula::device::falcon
