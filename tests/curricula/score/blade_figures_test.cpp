#include "curricula/score/blade_figures.h"

#include <gtest/gtest.h>

#include "tests/curricula/score/hand_made_intubation.h"

namespace vallecula::curricula {
namespace {

using namespace testing;

// The hand-made infant's landmarks: midline in the plane x = 0, gums' middle (0, 1.6, -10.4) mm, vallecula (0, 28.5,
// -41.5) mm: 41.1 mm from it.
constexpr double kY = 0.0285, kZ = -0.0415, kWay = 0.04111958;  // sqrt(26.9^2 + 31.1^2) mm
constexpr double kAxis[2] = {(0.0285 - 0.0016) / kWay, (-0.0415 + 0.0104) / kWay};

/// In at the right corner, from 7 s on `off` mm from the vallecula: to the left, and beyond it.
Change placed(double left_mm, double beyond_mm) {
  return [=](LogTick& t) {
    if (!between(t, 5, 20)) return;
    t.proxy_pose.position_m = {-9e-3, kInMouth[1], kInMouth[2]};
    if (t.time_s > 6.9995)
      t.proxy_pose.position_m = {1e-3 * left_mm, kY + 1e-3 * beyond_mm * kAxis[0], kZ + 1e-3 * beyond_mm * kAxis[1]};
  };
}
BladeFigures of(const Change& change) { return score_of(change).blade; }

TEST(BladeFigures, TipInTheVallecula) {
  const BladeFigures b = of(placed(4.0, 0.0));
  EXPECT_NEAR(*b.entry_left_m, -9e-3, 1e-9);
  EXPECT_NEAR(*b.to_vallecula_m, 4e-3, 1e-9);
  EXPECT_NEAR(b.to_vallecula_at_s, 7.0, 1e-9);
  EXPECT_NEAR(*b.left_m, 4e-3, 1e-9);
  EXPECT_TRUE(b.vallecula_reached);
  EXPECT_NEAR(b.vallecula_reached_at_s, 7.0, 1e-9);
  EXPECT_NEAR(b.past_vallecula_m, 0.0, 1e-7);
}

TEST(BladeFigures, TipBesideItAndBeyondIt) {
  const BladeFigures beside = of(placed(-7.0, 0.0));
  EXPECT_FALSE(beside.vallecula_reached) << "6.2 mm are near enough here";
  EXPECT_NEAR(*beside.left_m, -7e-3, 1e-9);
  const BladeFigures beyond = of(placed(0.0, 12.0));
  EXPECT_NEAR(beyond.past_vallecula_m, 12e-3, 1e-6);
  EXPECT_NEAR(beyond.past_vallecula_at_s, 7.0, 1e-9);
  EXPECT_FALSE(beyond.vallecula_reached);
}

TEST(BladeFigures, ATurnedPatientChangesNothing) {
  // The whole head turned by 90 degrees about x: the same figures.
  const auto turn = [](std::array<double, 3>& p) { p = {p[0], -p[2], p[1]}; };
  TrialLog log = log_of(placed(4.0, 0.0));
  for (auto& [name, at] : log.header.landmarks_m) turn(at);
  for (LogTick& t : log.ticks) turn(t.proxy_pose.position_m);
  const BladeFigures b = score_trial(log, scenario()).blade;
  EXPECT_NEAR(*b.left_m, 4e-3, 1e-9);
  EXPECT_NEAR(*b.entry_left_m, -9e-3, 1e-9);
}

TEST(BladeFigures, WithoutLandmarksOrBladeThereAreNone) {
  TrialLog log = log_of(placed(0.0, 0.0));
  log.header.landmarks_m.erase("vallecula");
  EXPECT_FALSE(score_trial(log, scenario()).blade.to_vallecula_m);
  EXPECT_FALSE(of([](LogTick& t) { t.proxy_pose.position_m = kOutside; }).entry_left_m);
}

}  // namespace
}  // namespace vallecula::curricula
