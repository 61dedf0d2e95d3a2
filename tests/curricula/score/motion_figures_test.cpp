#include "curricula/score/motion_figures.h"

#include <gtest/gtest.h>

#include "curricula/score/spectrum.h"
#include "tests/curricula/score/hand_made_intubation.h"

namespace vallecula::curricula {
namespace {

using namespace testing;

MotionFigures motion_of(const Change& change = {}) { return score_of(change).motion; }

/// Share of the way of a minimum-jerk reach, and its speed.
double reach(double t) { return t * t * t * (10.0 - 15.0 * t + 6.0 * t * t); }
double reach_speed(double t) { return 30.0 * t * t * (1.0 - t) * (1.0 - t); }

constexpr double kRate = 50.0;
/// A reach of 2 s, sampled in the middle of each 20 ms.
std::vector<double> one_reach() {
  std::vector<double> speed;
  for (int i = 0; i < 100; ++i) speed.push_back(reach_speed((i + 0.5) / 100.0));
  return speed;
}

// Reference values: the authors' published formula (Balasubramanian 2015: padding 4, 10 Hz, threshold 0.05) written
// down in Python with a direct Fourier sum in double precision, on the same samples.
TEST(SpectralArcLength, EqualsTheAuthorsFormula) {
  std::vector<double> speed = one_reach();
  EXPECT_NEAR(*spectral_arc_length(speed, kRate), -1.405829243890256, 1e-9);
  const std::vector<double> again = speed;
  speed.insert(speed.end(), 25, 0.0);
  speed.insert(speed.end(), again.begin(), again.end());
  EXPECT_NEAR(*spectral_arc_length(speed, kRate), -2.7464512558808103, 1e-9);
  std::vector<double> shaky = again;
  for (std::size_t i = 0; i < shaky.size(); ++i) shaky[i] += 0.8 * (1.0 + std::sin(2.0 * M_PI * 4.0 * i / kRate));
  EXPECT_NEAR(*spectral_arc_length(shaky, kRate), -2.303939572740016, 1e-9);
}

TEST(SpectralArcLength, OfNothingIsNothing) {
  EXPECT_FALSE(spectral_arc_length({}, kRate));
  EXPECT_FALSE(spectral_arc_length({1.0}, kRate));
  EXPECT_FALSE(spectral_arc_length(std::vector<double>(100, 0.0), kRate));
  EXPECT_FALSE(spectral_arc_length(std::vector<double>(100, NAN), kRate));
}

TEST(MotionFigures, AReachIsAsSmoothInTheLogAsOnPaper) {
  // The measure does not depend on how long a movement takes: 15 s here, 2 s in the reference.
  const MotionFigures m =
      motion_of([](LogTick& t) { t.device_pose.position_m[1] = 0.1 * reach(std::clamp((t.time_s - 5.0) / 15.0, 0.0, 1.0)); });
  EXPECT_NEAR(*m.smoothness, -1.4025053055360275, 1e-9) << "the reference's on 20 ms means of the same reach";
  EXPECT_NEAR(*m.smoothness, *spectral_arc_length(one_reach(), kRate), 0.005);
  EXPECT_LT(*m.tremor_m, 2e-6) << "a slow reach has no tremor";
}

TEST(MotionFigures, TremorIsThatOfASinusoid) {
  const auto shaken = [](double hertz) {
    return motion_of([hertz](LogTick& t) {
      t.device_pose.position_m[1] = 0.1 * reach(std::clamp((t.time_s - 5.0) / 15.0, 0.0, 1.0));
      t.device_pose.position_m[0] = 0.3e-3 * std::sin(2.0 * M_PI * hertz * t.time_s);
      t.device_pose.position_m[2] = 0.4e-3 * std::cos(2.0 * M_PI * hertz * t.time_s);
    });
  };
  const double rms = 0.5e-3 / std::sqrt(2.0);  // 0.3 and 0.4 mm together
  for (const double hertz : {5.0, 8.0, 11.0}) EXPECT_NEAR(*shaken(hertz).tremor_m, rms, 0.01 * rms) << hertz;
  for (const double hertz : {2.0, 16.0}) EXPECT_LT(*shaken(hertz).tremor_m, 0.03 * rms) << hertz;
  EXPECT_LT(*shaken(8.0).smoothness, -2.0) << "and it is not smooth";
}

TEST(MotionFigures, TheWayOfACircle) {
  const auto turns = [](LogTick& t) {
    if (!between(t, 5, 20)) return;
    const double angle = 2.0 * M_PI * t.time_s;
    t.proxy_pose.position_m = {5e-3 * std::cos(angle), kInMouth[1] + 5e-3 * std::sin(angle), kInMouth[2]};
  };
  const double way = 15.0 * 2.0 * M_PI * 5e-3;
  EXPECT_NEAR(motion_of(turns).tip_path_m, way, 0.005 * way);
  // What a device's last digit does from tick to tick is no way: 0.05 mm up and down would be 1500 mm.
  EXPECT_NEAR(motion_of([&](LogTick& t) {
                turns(t);
                t.proxy_pose.position_m[2] += t.tick % 2 == 0 ? 5e-5 : 0.0;
              }).tip_path_m,
              way, 0.005 * way);
}

TEST(MotionFigures, APauseIsNoMotionAndEndsAStretch) {
  // The hand is far off after the pause: that was not a stroke. 4 s before it, 10 s after.
  const MotionFigures m = motion_of([](LogTick& t) {
    if (between(t, 9, 10)) t.device_valid = false;
    t.device_pose.position_m[0] = t.time_s < 9.5 ? 0.0 : 0.2;
    t.device_pose.position_m[1] = 0.1 * reach(std::clamp((t.time_s - 10.0) / 10.0, 0.0, 1.0));
  });
  EXPECT_NEAR(*m.smoothness, -1.4024274697311536, 1e-9) << "the reference's for the 10 s after it";
  EXPECT_LT(*m.tremor_m, 2e-6);
}

TEST(MotionFigures, WithoutABladeInTheMouthThereIsNone) {
  const MotionFigures m = motion_of([](LogTick& t) { t.proxy_pose.position_m = kOutside; });
  EXPECT_EQ(m.tip_path_m, 0.0);
  EXPECT_FALSE(m.smoothness);
  EXPECT_FALSE(m.tremor_m);
}

}  // namespace
}  // namespace vallecula::curricula
