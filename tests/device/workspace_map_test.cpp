#include "device/workspace_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

class Draw {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vector vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Rotation rotation() { return normalised({number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)}); }

 private:
  std::mt19937 random_{11};
};

// A few sums and products of unit size: a thousand roundings.
constexpr double kRounding = 1e-12;

TEST(FromAxes, IsTheRotationThatTurnsTheAxes) {
  Draw draw;
  for (int i = 0; i < 2000; ++i) {
    const Rotation q = draw.rotation();
    const Vector x = rotate(q, {1, 0, 0}), y = rotate(q, {0, 1, 0}), z = rotate(q, {0, 0, 1});
    // The angle is an arc of a cosine near 1: half the digits.
    EXPECT_LT(angle_between(from_axes(x, y, z), q), 1e-7);
    EXPECT_LT(length(subtract(cross(x, y), z)), kRounding);
  }
  for (const Rotation& half : {Rotation{0, 1, 0, 0}, Rotation{0, 0, 1, 0}, Rotation{0, 0, 0, 1}})
    EXPECT_LT(angle_between(from_axes(rotate(half, {1, 0, 0}), rotate(half, {0, 1, 0}), rotate(half, {0, 0, 1})), half),
              1e-7);
}

TEST(WorkspaceMap, RightUpAndTowardsTheViewer) {
  WorkspaceMap map({});
  const Vector right{-1, 0, 0}, up{0, -0.8, 0.6};
  map.set_view_axes(right, up);
  map.centre({}, {0.1, 0.2, 0.3}, {1, 0, 0, 0});
  const auto moved = [&](const Vector& by) {
    DeviceReading reading;
    reading.position_m = by;
    return subtract(map.to_patient(reading).position_m, {0.1, 0.2, 0.3});
  };
  EXPECT_LT(length(subtract(moved({0.01, 0, 0}), scale(right, 0.01))), kRounding);
  EXPECT_LT(length(subtract(moved({0, 0.01, 0}), scale(up, 0.01))), kRounding);
  EXPECT_LT(length(subtract(moved({0, 0, 0.01}), scale(cross(right, up), 0.01))), kRounding);
}

TEST(WorkspaceMap, CentredThereTheToolIsThereAndMovesWithTheHand) {
  Draw draw;
  for (int i = 0; i < 500; ++i) {
    const MapSettings settings{draw.number(0.2, 3.0), draw.number(-3.0, 3.0), i % 2 == 0};
    WorkspaceMap map(settings);
    const Rotation view = draw.rotation();
    map.set_view_axes(rotate(view, {1, 0, 0}), rotate(view, {0, 1, 0}));
    DeviceReading from;
    from.position_m = draw.vector(0.1);
    from.rotation_wxyz = draw.rotation();
    const Vector tip = draw.vector(0.3);
    const Rotation pose = draw.rotation();
    map.centre(from, tip, pose);
    const DeviceReading there = map.to_patient(from);
    EXPECT_LT(length(subtract(there.position_m, tip)), kRounding);
    EXPECT_LT(angle_between(there.rotation_wxyz, pose), 1e-7);

    // Any other pose: lengths are scaled, angles kept, and the way back by centring there gives the device's own.
    DeviceReading to = from;
    to.position_m = draw.vector(0.1);
    to.rotation_wxyz = draw.rotation();
    const DeviceReading tool = map.to_patient(to);
    EXPECT_NEAR(length(subtract(tool.position_m, tip)),
                settings.motion_scale * length(subtract(to.position_m, from.position_m)), kRounding);
    EXPECT_NEAR(angle_between(tool.rotation_wxyz, there.rotation_wxyz),
                angle_between(to.rotation_wxyz, from.rotation_wxyz), 1e-7);
    map.centre(to, tool.position_m, tool.rotation_wxyz);  // round trip: the map is the same one
    const DeviceReading again = map.to_patient(from);
    EXPECT_LT(length(subtract(again.position_m, tip)), kRounding);
    EXPECT_LT(angle_between(again.rotation_wxyz, pose), 1e-7);
  }
}

TEST(WorkspaceMap, PowerIsTheSameOnBothSides) {
  Draw draw;
  for (int i = 0; i < 500; ++i) {
    WorkspaceMap map({draw.number(0.2, 3.0), draw.number(-3.0, 3.0), i % 2 == 0});
    const Rotation view = draw.rotation();
    map.set_view_axes(rotate(view, {1, 0, 0}), rotate(view, {0, 1, 0}));
    DeviceReading a, b;
    a.position_m = draw.vector(0.1);
    b.position_m = draw.vector(0.1);
    const Vector force = draw.vector(8.0), shown = map.force_to_device(force);
    const Vector hand = subtract(b.position_m, a.position_m),
                 tool = subtract(map.to_patient(b).position_m, map.to_patient(a).position_m);
    const double put_in = force[0] * tool[0] + force[1] * tool[1] + force[2] * tool[2];
    EXPECT_NEAR(shown[0] * hand[0] + shown[1] * hand[1] + shown[2] * hand[2], put_in, kRounding);
  }
}

TEST(WorkspaceMap, LeftHandedMirrorsButtonsAndSideButNotMotion) {
  MapSettings right;
  right.turned_rad = 0.5;
  MapSettings left = right;
  left.left_handed = true;
  WorkspaceMap of_right(right), of_left(left);
  DeviceReading reading;
  for (const auto& [pressed, exchanged] : {std::pair{1u, 2u}, {2u, 1u}, {3u, 3u}, {4u, 4u}, {0u, 0u}, {9u, 10u}}) {
    reading.buttons = pressed;
    EXPECT_EQ(of_right.to_patient(reading).buttons, pressed);
    EXPECT_EQ(of_left.to_patient(reading).buttons, exchanged);
  }
  // The same way of the hand, seen in a mirror through the person's middle.
  for (const Vector way : {Vector{0.02, 0.01, 0}, Vector{0, 0.01, 0.03}, Vector{0.01, 0, -0.02}}) {
    reading.position_m = way;
    const Vector one = of_right.to_patient(reading).position_m;
    reading.position_m = {-way[0], way[1], way[2]};
    const Vector other = of_left.to_patient(reading).position_m;
    EXPECT_LT(length(subtract(other, {-one[0], one[1], one[2]})), kRounding);
  }
  EXPECT_LT(of_left.to_patient({{0.01, 0, 0}}).position_m[0], 0.0) << "right is the patient's right for either hand";
  EXPECT_LT(of_right.to_patient({{0.01, 0, 0}}).position_m[0], 0.0);
}

TEST(WorkspaceMap, RefusesWhatIsNoMap) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const MapSettings bad : {MapSettings{0, 0, false}, MapSettings{-1, 0, false}, MapSettings{nan, 0, false},
                                MapSettings{100, 0, false}, MapSettings{1, 7, false}, MapSettings{1, nan, false}})
    EXPECT_THROW(WorkspaceMap{bad}, std::invalid_argument);
}

}  // namespace
}  // namespace vallecula::device
