#include "device/trajectory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

namespace fs = std::filesystem;

class TrajectoryFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ("vallecula-trajectory-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& text) {
    const fs::path file = folder_ / "t.csv";
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  std::string error_of(const std::string& text) {
    try {
      Trajectory(read_trajectory_csv(write(text)));
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "accepted";
  }
  fs::path folder_;
};

std::vector<Keyframe> random_keyframes(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-0.1, 0.1), gap(0.01, 1.0), unit(-1.0, 1.0);
  std::vector<Keyframe> keyframes;
  double time_s = place(random);
  for (int i = 0; i < count; ++i) {
    const Rotation q = normalised({unit(random), unit(random), unit(random), unit(random)});
    keyframes.push_back({time_s, {place(random), place(random), place(random)}, q});
    time_s += gap(random);
  }
  return keyframes;
}

TEST(Trajectory, PassesThroughEveryKeyframe) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto keyframes = random_keyframes(seed, 12);
    const Trajectory trajectory(keyframes);
    for (const Keyframe& k : keyframes) {
      const Keyframe at = trajectory.at(k.time_s);
      EXPECT_LT(length(subtract(at.position_m, k.position_m)), 1e-15);
      EXPECT_LT(angle_between(at.rotation_wxyz, k.rotation_wxyz), 1e-7);
    }
  }
}

TEST(Trajectory, NeverLeavesTheBoxOfTwoNeighboursAndMovesWithoutJumps) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto keyframes = random_keyframes(seed, 8);
    const Trajectory trajectory(keyframes);
    for (std::size_t i = 0; i + 1 < keyframes.size(); ++i) {
      const Keyframe &a = keyframes[i], &b = keyframes[i + 1];
      const double h = (b.time_s - a.time_s) / 500;
      for (int s = 1; s <= 500; ++s) {
        const Keyframe p = trajectory.at(a.time_s + s * h);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          EXPECT_GE(p.position_m[axis], std::min(a.position_m[axis], b.position_m[axis]) - 1e-12);
          EXPECT_LE(p.position_m[axis], std::max(a.position_m[axis], b.position_m[axis]) + 1e-12);
        }
        EXPECT_NEAR(dot(p.rotation_wxyz, p.rotation_wxyz), 1.0, 1e-12);
      }
    }
    // Velocity is continuous at inner keyframes: one-sided differences agree to the first order of their step.
    for (std::size_t i = 1; i + 1 < keyframes.size(); ++i) {
      const double t = keyframes[i].time_s, h = 1e-6;
      const Vector left = scale(subtract(trajectory.at(t).position_m, trajectory.at(t - h).position_m), 1 / h);
      const Vector right = scale(subtract(trajectory.at(t + h).position_m, trajectory.at(t).position_m), 1 / h);
      EXPECT_LT(length(subtract(left, right)), 0.02);  // accelerations reach 6 * 0.2 m / (0.01 s)^2 = 12000 m/s^2
    }
  }
}

TEST(Trajectory, RestsAtBothEnds) {
  const Trajectory trajectory(random_keyframes(3, 4));
  for (const double t : {-1e9, trajectory.start_s() - 1.0}) {
    EXPECT_EQ(trajectory.at(t).position_m, trajectory.keyframes().front().position_m);
  }
  EXPECT_EQ(trajectory.at(trajectory.end_s() + 1.0).position_m, trajectory.keyframes().back().position_m);
  EXPECT_EQ(trajectory.at(std::numeric_limits<double>::quiet_NaN()).position_m,
            trajectory.keyframes().front().position_m);
  const double h = 1e-6;
  EXPECT_LT(length(subtract(trajectory.at(trajectory.start_s() + h).position_m,
                            trajectory.at(trajectory.start_s()).position_m)) /
                h,
            0.02);
}

TEST(Trajectory, RotationTurnsAtConstantSpeedAlongTheShorterArc) {
  const Rotation to = about_axis({0, 0, 1}, 1.0), negated{-to[0], -to[1], -to[2], -to[3]};
  for (const Rotation& target : {to, negated}) {  // both name the same rotation
    const Trajectory trajectory({{0, {0, 0, 0}, {1, 0, 0, 0}}, {2, {0, 0, 0}, target}});
    for (const double t : {0.1, 0.5, 1.0, 1.7}) {
      EXPECT_NEAR(angle_between({1, 0, 0, 0}, trajectory.at(t).rotation_wxyz), 0.5 * t, 1e-9);
    }
  }
}

TEST(Trajectory, RefusesWhatCannotBeFollowed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Keyframes = std::vector<Keyframe>;
  const Keyframe good, later{1.0, {0, 0, 0}, {1, 0, 0, 0}};
  for (const Keyframes& bad : {Keyframes{}, Keyframes{{nan, {0, 0, 0}, {1, 0, 0, 0}}},
                               Keyframes{{0, {0, nan, 0}, {1, 0, 0, 0}}}, Keyframes{good, good}, Keyframes{later, good},
                               Keyframes{{0, {0, 0, 0}, {0, 0, 0, 0}}}, Keyframes{{0, {0, 0, 0}, {nan, 0, 0, 0}}}}) {
    EXPECT_THROW(Trajectory{bad}, DeviceError);
  }
  EXPECT_NO_THROW(Trajectory(Keyframes{good, later}));
}

TEST_F(TrajectoryFile, ReadsBothForms) {
  const auto four = read_trajectory_csv(write("t,x,y,z\n# a comment\n\n0,0.001,-2e-3,+.003\r\n 0.5 , 1,2 ,3\n"));
  ASSERT_EQ(four.size(), 2u);
  EXPECT_EQ(four[0].position_m, (Vector{0.001, -2e-3, 0.003}));
  EXPECT_EQ(four[1].time_s, 0.5);
  EXPECT_EQ(four[1].rotation_wxyz, (Rotation{1, 0, 0, 0}));
  const auto eight = read_trajectory_csv(write("0,0,0,0,0.6,0.8,0,0"));
  ASSERT_EQ(eight.size(), 1u);
  EXPECT_EQ(eight[0].rotation_wxyz, (Rotation{0.6, 0.8, 0, 0}));
}

TEST_F(TrajectoryFile, NamesFileLineAndFault) {
  const struct {
    const char *text, *line, *says;
  } cases[] = {
      {"", "t.csv", "no rows"},
      {"t,x,y,z\n", "t.csv", "no rows"},
      {"0,0,0\n", "line 1", "3 columns"},
      {"0,0,0,0\n1,0,0,0,1,0,0,0\n", "line 2", "the lines before have 4"},
      {"0,0,0,0\n1,0,zero,0\n", "line 2", "'zero'"},
      {"0,0,0,0\n1,0,nan,0\n", "line 2", "finite"},
      {"0,0,0,0\n1,0,inf,0\n", "line 2", "finite"},
      {"0,0,0,0\n1,0,,0\n", "line 2", "''"},
      {"0,0,0,0\n0,0,0,0\n", "line 2", "not later"},
      {"0,0,0,0\n\n\n-1,0,0,0\n", "line 4", "not later"},
      {"0,0,0,0,2,0,0,0\n", "line 1", "unit quaternion"},
      {"0,0,0,0;1\n", "line 1", "'0;1'"},
      {"0,0,0,0\nt,x,y,z\n", "line 2", "'t'"},
  };
  for (const auto& c : cases) {
    const std::string error = error_of(c.text);
    EXPECT_NE(error.find(c.line), std::string::npos) << error;
    EXPECT_NE(error.find(c.says), std::string::npos) << error;
    EXPECT_NE(error.find("t.csv"), std::string::npos) << error;
  }
  EXPECT_THROW(read_trajectory_csv(folder_ / "missing.csv"), DeviceError);
  EXPECT_THROW(read_trajectory_csv(folder_), DeviceError);
}

}  // namespace
}  // namespace vallecula::device
