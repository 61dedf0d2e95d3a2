// An instructor's keys on the infant: how fast, what stays, and what breaths bring back.
#include <gtest/gtest.h>

#include "engine/physiology/infant.h"
#include "tests/engine/physiology/infants.h"

namespace vallecula::engine {
namespace {

using testing::Patient;
using testing::preterm;
using testing::term;

InfantInput driven(int saturation, int heart) {
  InfantInput input;
  input.drive_saturation = saturation;
  input.drive_heart = heart;
  return input;
}

TEST(Driven, SaturationFallsAtItsRateTrueAndDisplayed) {
  for (const InfantDescription& d : {preterm(1), preterm(7), term(3), term(2, Course::preoxygenated)}) {
    Patient p(d), beside(d);
    const double store = store_ml(p.infant.oxygen, p.state.oxygen);
    p.live(2.0, driven(-1, 0));
    beside.live(2.0);
    // On top of apnoea, which itself goes faster where the stores are smaller.
    EXPECT_NEAR(beside.signs.sao2 - p.signs.sao2, 2.0 * kDrivenSaturation, 0.015) << d.seed;
    EXPECT_NEAR(beside.signs.spo2 - p.signs.spo2, 2.0 * kDrivenSaturation, 0.055) << d.seed << " (shown once a second)";
    EXPECT_LT(store_ml(p.infant.oxygen, p.state.oxygen), store) << "oxygen that nobody lacks was taken from nowhere";
    // It is no mere number on the screen: without breaths it does not come back by itself.
    const double low = p.signs.sao2;
    p.live(20.0);
    EXPECT_LT(p.signs.sao2, low + 0.02);
    p.ventilate(60, Breath::mask);
    EXPECT_GT(p.signs.sao2, low + 0.07) << d.seed;
  }
}

TEST(Driven, SaturationRisesAndNeverLeavesWhatThereIs) {
  Patient p(term(1, Course::delivery_room));
  const double before = p.signs.sao2;
  p.live(4.0, driven(1, 0));
  EXPECT_GT(p.signs.sao2, before + 0.15);
  p.live(30.0, driven(1, 0));
  EXPECT_LE(p.signs.sao2, 1.0);
  EXPECT_GT(p.signs.sao2, 0.95);
  p.live(60.0, driven(-1, 0));
  EXPECT_GE(p.signs.sao2, 0.0);
  EXPECT_LT(p.signs.sao2, 0.10);
  EXPECT_EQ(p.signs.faults, 0u);
}

TEST(Driven, DownNeverLiftsWhatIsBelowTheLeastAlready) {
  Patient p(term(1));
  OxygenState state = p.state.oxygen;
  state.arterial = state.venous = 0.02;
  const OxygenState before = state;
  EXPECT_EQ(drive(p.infant.oxygen, state, -0.01, 150.0), 0.0);
  EXPECT_EQ(state.arterial, before.arterial);
  EXPECT_EQ(state.venous, before.venous);
  EXPECT_EQ(store_ml(p.infant.oxygen, state), store_ml(p.infant.oxygen, before));
  EXPECT_GT(drive(p.infant.oxygen, state, 0.01, 150.0), 0.0) << "up still does";
}

TEST(Driven, TheHeartGoesAtItsRateAndBreathsBringItBack) {
  for (const int way : {-1, 1}) {
    Patient p(preterm(2));
    const double before = p.signs.heart_per_min;
    p.live(2.0, driven(0, way));
    EXPECT_NEAR(p.signs.heart_per_min, before + way * 2.0 * kDrivenHeart, 4.0);
    p.ventilate(4, Breath::none);
    EXPECT_NEAR(p.signs.heart_per_min, before + way * 2.0 * kDrivenHeart, 8.0) << "it stays until something is done";
    p.ventilate(40, Breath::mask);
    EXPECT_NEAR(p.signs.heart_per_min, before, 5.0);
    p.live(30.0, driven(0, way));
    EXPECT_GE(p.signs.heart_per_min, 40.0);
    EXPECT_LE(p.signs.heart_per_min, 220.0);
  }
}

}  // namespace
}  // namespace vallecula::engine
