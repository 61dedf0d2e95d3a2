// What every tick of the infant keeps: its bits, its bounds, its time; and which descriptions are refused.
#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "engine/physiology/draw.h"
#include "tests/engine/allocations.h"
#include "tests/engine/physiology/infants.h"

namespace vallecula::engine {
namespace {

using testing::load;
using testing::Patient;
using testing::preterm;
using testing::term;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
static_assert(std::is_trivially_copyable_v<InfantState>, "the state is plain numbers");

TEST(Infant, TheSameInputsGiveTheSameBits) {
  Patient a(term(9)), b(term(9));
  for (int k = 0; k < 120000; ++k) {
    InfantInput in = load(k % 40000 > 20000 ? 3.0 : 0.0);
    in.breath = k % 2000 == 0 && k > 60000 ? Breath::mask : Breath::none;
    a.tick(in);
    b.tick(in);
    ASSERT_EQ(std::memcmp(&a.signs.sao2, &b.signs.sao2, sizeof(double)), 0) << k;
    ASSERT_EQ(std::memcmp(&a.signs.heart_per_min, &b.signs.heart_per_min, sizeof(double)), 0) << k;
    ASSERT_EQ(a.signs.spo2, b.signs.spo2);
  }
  EXPECT_LT(a.signs.sao2, 1.0);
}

// Inner steps are what they are: a tick's length moves nothing but their rounding.
TEST(Infant, ItsLifeDoesNotDependOnTheTick) {
  Patient fine(preterm(8), 0.001), coarse(preterm(8), 0.05);
  fine.live(50);
  coarse.live(50);
  EXPECT_NEAR(fine.signs.sao2, coarse.signs.sao2, 1e-3);
  EXPECT_EQ(fine.signs.spo2, coarse.signs.spo2);
}

TEST(Infant, WhatIsNotANumberIsTakenAsNoneAndNamed) {
  Patient p(preterm(1)), quiet(preterm(1));
  InfantInput bad = load(kNan);
  bad.tube_load_n = std::numeric_limits<double>::infinity();
  bad.glottis_opening = kNan;
  p.live(2, bad);
  quiet.live(2);
  EXPECT_EQ(p.signs.faults, kInfantFaultInput);
  EXPECT_EQ(p.signs.sao2, quiet.signs.sao2);
  EXPECT_EQ(p.signs.heart_per_min, quiet.signs.heart_per_min);
  const InfantSigns signs = step(p.infant, p.state, {}, kNan);
  EXPECT_EQ(signs.faults, kInfantFaultInput);
  EXPECT_EQ(signs.sao2, quiet.signs.sao2);
}

TEST(Infant, AStateThatIsNotANumberStartsAnewAndIsNamed) {
  Patient p(preterm(1)), fresh(preterm(1));
  p.live(30);
  p.state.oxygen.venous = kNan;
  p.tick({});
  EXPECT_EQ(p.signs.faults, kInfantFaultState);
  EXPECT_EQ(p.signs.sao2, fresh.signs.sao2);
  p.tick({});
  EXPECT_EQ(p.signs.faults, kInfantFaultNone);
}

TEST(Infant, HugeInputsLeaveItWithinWhatLives) {
  Draw draw{77};
  Patient p(term(1));
  for (int k = 0; k < 200000; ++k) {
    InfantInput in = load(draw.between(-1e300, 1e300));
    in.tube_load_n = draw.between(-1e300, 1e300);
    in.glottis_opening = draw.between(-1e6, 1e6);
    in.breathing = draw.uniform() < 0.5;
    in.breath = static_cast<Breath>(draw.bits() % 3);
    in.tip = static_cast<TubeTip>(draw.bits() % 4);
    p.tick_s = draw.between(-1.0, 1.0);
    p.tick(in);
    ASSERT_GE(p.signs.sao2, 0.0);
    ASSERT_LE(p.signs.sao2, 1.0);
    ASSERT_GE(p.signs.heart_per_min, 39.9);
    ASSERT_LE(p.signs.heart_per_min, 220.0);
    ASSERT_EQ(p.signs.faults & kInfantFaultState, 0u);
  }
}

TEST(Infant, ContradictionsAreRefused) {
  const auto refused = [](InfantDescription d, const std::string& word) {
    try {
      build_infant(d);
      ADD_FAILURE() << word;
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
    }
  };
  InfantDescription d = preterm();
  d.weight_kg = 0;
  refused(d, "weight");
  d.weight_kg = kNan;
  refused(d, "weight");
  d = preterm();
  d.gestation_weeks = 50;
  refused(d, "gestation");
  d = preterm();
  d.gestation_weeks = 36;
  refused(d, "up to 32 weeks");
  d = preterm();
  d.added_oxygen = 0.9;
  refused(d, "oxygen");
  d = preterm();
  d.premedicated = false;
  refused(d, "premedicated");
  d = term();
  d.gestation_weeks = 30;
  refused(d, "term course");
  d = term(1, Course::delivery_room);
  d.premedicated = true;
  refused(d, "delivery room");
  d = term(1, static_cast<Course>(9));
  refused(d, "course");
}

TEST(Infant, ATickAllocatesNothing) {
  Patient p(preterm(1));
  const long before = testing::allocations;
  ASSERT_GT(before, 0);
  p.live(5, load(1.0));
  p.ventilate(5, Breath::tube, TubeTip::trachea);
  EXPECT_EQ(testing::allocations - before, 0);
}

TEST(InfantRealTime, ATickTakesLessThanTwoMicroseconds) {
  Patient p(term(1));
  p.live(1);
  constexpr int kTicks = 200000;
  const auto begin = std::chrono::steady_clock::now();
  for (int k = 0; k < kTicks; ++k) p.tick(load(1.0));
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took.count() / kTicks, 2.0);
}

}  // namespace
}  // namespace vallecula::engine
