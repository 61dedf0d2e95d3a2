// What the infant does to what is done to it: breaths, a blade on the larynx, the CO2 detector; and what every tick
// keeps.
#include "engine/physiology/infant.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

#include "engine/physiology/draw.h"
#include "tests/engine/allocations.h"
#include "tests/engine/physiology/infants.h"

namespace vallecula::engine {
namespace {

using testing::Patient;
using testing::preterm;
using testing::quantile;
using testing::term;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

InfantInput load(double newton) {
  InfantInput input;
  input.blade_load_n = newton;
  return input;
}

/// After apnoea until the display shows less than 60 %.
Patient desaturated(const InfantDescription& d) {
  Patient p(d, 0.1);
  while (p.signs.spo2 >= 0.6) p.tick({});
  return p;
}

constexpr double kNever = 599.0;

/// Seconds of breaths until the true saturation is within 3 % of its start's again; kNever or more: not in ten minutes.
double recovery_s(Patient p, Breath breath, TubeTip tip, double per_min) {
  const double begin = p.time_s, enough = start(p.infant.oxygen).arterial - 0.03;
  while (p.signs.sao2 < enough && p.time_s < begin + 600) p.ventilate(1, breath, tip, per_min);
  return p.time_s - begin;
}

TEST(Infant, VentilationAtTheReferenceRateKeepsItAsItStarted) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    InfantDescription d = preterm(seed);
    d.added_oxygen = 0.0;
    Patient p(d, 0.1);
    const double sao2 = p.signs.sao2;
    p.ventilate(400, Breath::mask);
    EXPECT_NEAR(p.signs.sao2, sao2, 0.015) << seed;
    EXPECT_NEAR(p.signs.given_per_min, 40.0, 0.5);
  }
}

// CLINICAL: between attempts 30 to 60 s of ventilation.
TEST(Infant, AMinuteOfMaskVentilationBringsItBack) {
  std::vector<double> seconds;
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
    seconds.push_back(recovery_s(desaturated(preterm(seed)), Breath::mask, TubeTip::none, 40));
  EXPECT_GT(quantile(seconds, 0.5), 20.0);
  EXPECT_LT(quantile(seconds, 0.5), 50.0);
  EXPECT_LT(quantile(seconds, 0.9), 75.0);
}

TEST(Infant, BreathsAreCountedAndWhereTheyGoMatters) {
  const Patient p = desaturated(preterm(7));
  const double good = recovery_s(p, Breath::tube, TubeTip::trachea, 40);
  EXPECT_EQ(recovery_s(p, Breath::mask, TubeTip::none, 40), good);  // a good seal is assumed
  EXPECT_LT(recovery_s(p, Breath::tube, TubeTip::trachea, 60), good);
  EXPECT_GT(recovery_s(p, Breath::tube, TubeTip::trachea, 25), 1.2 * good);
  // Half of each breath is like half of the breaths.
  const double one_lung = recovery_s(p, Breath::tube, TubeTip::main_bronchus, 60);
  EXPECT_NEAR(one_lung, recovery_s(p, Breath::tube, TubeTip::trachea, 30), 6.0);
  InfantDescription pure = preterm(7);
  pure.added_oxygen = 0.79;
  EXPECT_LT(recovery_s(desaturated(pure), Breath::tube, TubeTip::trachea, 40), good);
  EXPECT_GE(recovery_s(p, Breath::tube, TubeTip::oesophagus, 40), kNever);
  EXPECT_GE(recovery_s(p, Breath::tube, TubeTip::none, 40), kNever);
}

TEST(Infant, ABreathSqueezedInBeforeTheLastIsOutIsNone) {
  Patient quick(preterm(2)), steady(preterm(2));
  quick.live(30);
  steady.live(30);
  InfantInput squeeze;
  squeeze.breath = Breath::mask;
  for (int k = 0; k < 10; ++k) quick.tick(squeeze);
  steady.tick(squeeze);
  EXPECT_EQ(quick.state.breaths_given, 1);
  EXPECT_EQ(quick.state.oxygen.alveolar_mmhg[0], steady.state.oxygen.alveolar_mmhg[0]);
}

TEST(Infant, ThroughClosedCordsTheMaskBringsNothing) {
  Patient open(preterm(2), 0.1), shut(preterm(2), 0.1);
  InfantInput in;
  for (int k = 0; k < 900; ++k) {
    in.breath = k % 15 == 0 ? Breath::mask : Breath::none;
    in.glottis_opening = 0.55;
    open.tick(in);
    in.glottis_opening = 0.0;
    shut.tick(in);
  }
  EXPECT_GT(open.signs.spo2, 0.9);
  EXPECT_LT(shut.signs.spo2, open.signs.spo2 - 0.15);
  EXPECT_NEAR(shut.signs.since_breath_s, 90.0, 0.2);
  EXPECT_LT(open.signs.since_breath_s, 1.6);
  EXPECT_EQ(shut.state.breaths_given, 60);
}

TEST(Infant, TheDisplayGoesOnFallingWhenVentilationBeginsAnew) {
  int falling = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Patient p = desaturated(preterm(seed));
    const double shown = p.signs.spo2, begin = p.time_s;
    double lowest = shown;
    while (p.time_s < begin + 20) {
      p.ventilate(1, Breath::mask);
      lowest = std::min(lowest, p.signs.spo2);
    }
    falling += lowest < shown - 0.005;
  }
  EXPECT_GE(falling, 45);  // where the lag is 5 s and the fall slow, whole percents hide it
}

TEST(Infant, ABreathingInfantKeepsItselfAndASedatedOneCannot) {
  InfantInput tries;
  tries.breathing = true;
  Patient awake(term(4), 0.1), sedated(preterm(4), 0.1);
  awake.live(120, tries);
  sedated.live(120, tries);
  EXPECT_GT(awake.signs.spo2, 0.95);
  EXPECT_LT(awake.signs.since_breath_s, 2.0);
  EXPECT_LT(sedated.signs.spo2, 0.6);
  EXPECT_EQ(sedated.signs.breath_phase, 0.0);
}

// CLINICAL: bradycardia is late (hypoxic) or early (vagal, on blade contact).
TEST(Infant, ThePressedLarynxSlowsTheHeartLongBeforeHypoxiaDoes) {
  int slow = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Patient pressed(term(seed), 0.1), left(term(seed), 0.1);
    pressed.live(10, load(5.0));
    left.live(10);
    EXPECT_EQ(left.signs.heart_per_min, left.infant.heart.resting_per_min);
    EXPECT_LT(pressed.signs.heart_per_min, left.signs.heart_per_min - 10);
    EXPECT_GT(pressed.signs.spo2, 0.9);
    slow += pressed.signs.heart_per_min < 100;
    pressed.live(20);  // let go
    EXPECT_NEAR(pressed.signs.heart_per_min, pressed.infant.heart.resting_per_min, 3.0);
    while (left.signs.heart_per_min > 100 && left.time_s < 600) left.tick({});
    EXPECT_GT(left.time_s, 45.0);
    EXPECT_LT(left.time_s, 300.0);
    EXPECT_LT(left.signs.sao2, 0.6);
  }
  EXPECT_GT(slow, 20);  // not all: each has a sensitivity of its own
  EXPECT_LT(slow, 95);
}

TEST(Infant, TheTubesPushCountsAsTheBladesAndAtropineHoldsBoth) {
  InfantInput tube;
  tube.tube_load_n = 5.0;
  Patient blade(term(6), 0.1), other(term(6), 0.1), medicated(preterm(6), 0.1);
  const double resting = medicated.signs.heart_per_min;
  blade.live(10, load(5.0));
  other.live(10, tube);
  medicated.live(10, load(5.0));
  EXPECT_EQ(blade.signs.heart_per_min, other.signs.heart_per_min);
  EXPECT_GT(medicated.signs.heart_per_min, 0.9 * resting);
}

// CLINICAL: a rising heart rate is the first sign of success.
TEST(Infant, TheHeartRisesBeforeTheDisplay) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Patient p(term(seed), 0.1);
    while (p.signs.heart_per_min > 70 && p.time_s < 600) p.tick({});
    const double heart = p.signs.heart_per_min;
    double lowest = p.signs.spo2, heart_s = 0, display_s = 0;
    const double begin = p.time_s;
    InfantInput in;
    in.tip = TubeTip::trachea;
    for (int k = 0; (heart_s == 0 || display_s == 0) && k < 1200; ++k) {
      in.breath = k % 15 == 0 ? Breath::tube : Breath::none;
      p.tick(in);
      lowest = std::min(lowest, p.signs.spo2);
      if (heart_s == 0 && p.signs.heart_per_min > heart + 10) heart_s = p.time_s - begin;
      if (display_s == 0 && p.signs.spo2 > lowest + 0.025) display_s = p.time_s - begin;
    }
    ASSERT_GT(heart_s, 0);
    ASSERT_GT(display_s, 0);
    EXPECT_LT(heart_s, display_s) << seed;
  }
}

// CLINICAL: the detector changes colour within 5 or 6 breaths.
TEST(Infant, TheDetectorTurnsYellowByTheSixthBreathInTheAirwayOnly) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const TubeTip tip : {TubeTip::trachea, TubeTip::main_bronchus}) {
      Patient p(preterm(seed), 0.1);
      p.ventilate(4, Breath::tube, tip);
      EXPECT_EQ(p.signs.detector, DetectorColour::purple);
      p.ventilate(2, Breath::tube, tip);
      EXPECT_EQ(p.signs.detector, DetectorColour::yellow);
      p.ventilate(1, Breath::tube, TubeTip::oesophagus);  // it slipped out
      EXPECT_EQ(p.signs.detector, DetectorColour::purple);
    }
    for (const TubeTip tip : {TubeTip::oesophagus, TubeTip::none}) {
      Patient p(preterm(seed), 0.1);
      p.ventilate(20, Breath::tube, tip);
      EXPECT_EQ(p.signs.detector, DetectorColour::purple);
    }
    Patient mask(preterm(seed), 0.1);
    mask.ventilate(20, Breath::mask);
    EXPECT_EQ(mask.signs.detector, DetectorColour::purple);  // it sits on the tube
  }
}

TEST(Infant, WithoutOutputOfTheHeartTheDetectorIsFalselyPurple) {
  Patient p(term(3), 0.1);
  while (p.signs.heart_per_min > 45 && p.time_s < 600) p.tick({});
  ASSERT_LE(p.signs.heart_per_min, 45);
  Patient lost = p;
  lost.ventilate(2, Breath::tube, TubeTip::trachea, 60);
  EXPECT_EQ(lost.signs.detector, DetectorColour::purple);
  EXPECT_LT(lost.signs.heart_per_min, 60);
  // Once the heart is back it turns, a breath or more later than it would have.
  int breaths = 0;
  while (p.signs.detector == DetectorColour::purple && breaths < 100) {
    p.ventilate(1, Breath::tube, TubeTip::trachea);
    ++breaths;
  }
  EXPECT_GT(breaths, 6);
  EXPECT_LT(breaths, 40);
  EXPECT_GE(p.signs.heart_per_min, 60);
}

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

// The seeds' own tools against the C library.
TEST(Draw, TheExponentialIsTheLibrarys) {
  for (double x = -16.0; x <= 16.0; x += 0.37) EXPECT_NEAR(portable_exp(x) / std::exp(x), 1.0, 1e-12) << x;
}

TEST(Draw, TheQuantileIsTheNormals) {
  for (double p = 0.01; p < 1.0; p += 0.01)
    EXPECT_NEAR(0.5 * std::erfc(-normal_quantile(p) / std::sqrt(2.0)), p, 2e-4) << p;
}

TEST(Draw, NeighbouringSeedsLieEvenly) {
  for (int dimension = 0; dimension < 4; ++dimension) {
    int below[4] = {};
    for (std::uint64_t seed = 1; seed <= 100; ++seed) ++below[static_cast<int>(4 * even_uniform(seed, dimension))];
    for (const int quarter : below) EXPECT_NEAR(quarter, 25, 2);
  }
}

}  // namespace
}  // namespace vallecula::engine
