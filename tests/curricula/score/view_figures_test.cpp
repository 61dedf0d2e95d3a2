#include "curricula/score/view_figures.h"

#include <gtest/gtest.h>

#include "tests/curricula/score/hand_made_intubation.h"

namespace vallecula::curricula {
namespace {

using namespace testing;

ViewFigures view_of(const Change& change = {}) { return score_of(change).view; }

TEST(ViewFigures, OfASteadyView) {
  const ViewFigures v = view_of();  // blade in at 5 s, 80 % from 9 to 20 s
  EXPECT_NEAR(*v.mean_percent, 80.0, 1e-9);
  EXPECT_NEAR(v.in_sight_s, 11.0, 1e-9);
  EXPECT_NEAR(*v.time_to_stable_s, 4.0, 1e-9);
  EXPECT_NEAR(v.stable_at_s, 9.0, 1e-9);
}

TEST(ViewFigures, TheMeanIsOverTheTimeInWhichThereWasAView) {
  const ViewFigures v = view_of([](LogTick& t) {
    if (t.glottis_visible > 0 && t.time_s < 14.9995) t.glottis_visible = 0.4;
  });
  EXPECT_NEAR(*v.mean_percent, (40.0 * 6 + 80.0 * 5) / 11, 1e-9);
  const ViewFigures never = view_of([](LogTick& t) { t.glottis_visible = 0.0; });
  EXPECT_FALSE(never.mean_percent);
  EXPECT_FALSE(never.time_to_stable_s);
  EXPECT_EQ(never.stable_at_s, -1.0);
}

TEST(ViewFigures, StableIsTwoSecondsInOnePiece) {
  const auto lost_until = [](double from_s, double to_s) {
    return [=](LogTick& t) {
      if (between(t, from_s, to_s)) t.glottis_visible = std::min(t.glottis_visible, 0.2);  // 25 % are asked for
    };
  };
  EXPECT_NEAR(*view_of(lost_until(10.98, 12)).time_to_stable_s, 7.0, 1e-9) << "1.98 s are too short";
  EXPECT_NEAR(*view_of(lost_until(11, 12)).time_to_stable_s, 4.0, 1e-9);
  EXPECT_FALSE(view_of([&](LogTick& t) {
                 if (t.tick / 1000 % 2 == 0) t.glottis_visible = 0.0;
               }).time_to_stable_s);
}

TEST(ViewFigures, APauseStopsTheClock) {
  const ViewFigures v = view_of([](LogTick& t) {
    if (between(t, 6, 7) || between(t, 10, 12)) t.device_valid = false;
  });
  EXPECT_NEAR(*v.time_to_stable_s, 3.0, 1e-9);
  EXPECT_NEAR(v.in_sight_s, 9.0, 1e-9);
}

TEST(ViewFigures, CormackAndLehanesGradeAsFarAsALogCanKnow) {
  EXPECT_EQ(cormack_lehane(100.0), 1);
  EXPECT_EQ(cormack_lehane(50.1), 1);
  EXPECT_EQ(cormack_lehane(50.0), 2);
  EXPECT_EQ(cormack_lehane(0.8), 2);
  EXPECT_FALSE(cormack_lehane(0.0)) << "3 or 4: the log does not know the epiglottis";
}

}  // namespace
}  // namespace vallecula::curricula
