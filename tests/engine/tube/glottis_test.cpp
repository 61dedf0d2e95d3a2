// The cords: breathing, closing on touch, laryngospasm, and the gap they leave.
#include "engine/tube/glottis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>

#include "tests/engine/allocations.h"

namespace vallecula::engine {
namespace {

constexpr double kTick = 0.001;

struct Cords {
  Glottis glottis;
  GlottisState state;
  double time_s = 0.0;

  explicit Cords(const Glottis& g = {}) : glottis(checked(g)), state(start(glottis)) {}
  void tick(bool touched, bool breathing = false, double per_min = 60.0) {
    GlottisInput input;
    input.touched = touched;
    input.breathing = breathing;
    input.breath_phase = std::fmod(time_s * per_min / 60.0, 1.0);
    step(glottis, state, input, kTick);
    time_s += kTick;
  }
  /// Seconds until the opening is, or is no more, zero; 1000: not within that.
  double until_closed(bool closed, bool touched) {
    const double begin = time_s;
    while ((state.opening == 0.0) != closed && time_s < begin + 1000) tick(touched);
    return time_s - begin;
  }
};

TEST(Glottis, BreathingOpensItWideOnceABreath) {
  for (const double per_min : {45.0, 60.0}) {
    Cords c;
    int widest = 0;
    double before = 0.0, last = 0.0;
    for (int k = 0; k < 60000; ++k) {
      c.tick(false, true, per_min);
      widest += before < last && last >= c.state.opening && last > 0.95;
      before = last;
      last = c.state.opening;
      if (k > 2000) {
        ASSERT_GE(last, 0.44);
        ASSERT_LE(last, 1.0);
      }
    }
    EXPECT_NEAR(widest, per_min, 1);
  }
}

TEST(Glottis, InApnoeaAndUnderARelaxantItStandsPartlyOpen) {
  Glottis g;
  g.relaxed = true;
  Cords apnoea, relaxed(g);
  for (int k = 0; k < 5000; ++k) {
    apnoea.tick(false);
    relaxed.tick(k > 1000, true);
    ASSERT_GT(relaxed.state.opening, 0.3);
  }
  EXPECT_NEAR(apnoea.state.opening, 0.55, 1e-12);
  EXPECT_EQ(relaxed.state.opening, apnoea.state.opening);
}

TEST(Glottis, ATouchClosesItForATimeAndATubeLeftThereDoesNotHoldItClosed) {
  Cords c;
  EXPECT_LT(c.until_closed(true, true), 0.1);
  const double closed = c.until_closed(false, true);  // still touched
  EXPECT_GT(closed, 0.5);
  EXPECT_LT(closed, 1.5);
  for (int k = 0; k < 10000; ++k) c.tick(true);
  EXPECT_NEAR(c.state.opening, 0.55, 1e-9);
  c.tick(false);
  EXPECT_LT(c.until_closed(true, true), 0.1);  // touched anew
}

TEST(Glottis, TheTimesOfClosuresAreSeededWithTheMedianTold) {
  int longer = 0;
  double first = 0.0, last = 0.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Glottis g;
    g.seed = seed;
    Cords c(g);
    c.tick(true);
    last = c.state.closed_s;
    if (seed == 1) first = last;
    longer += last > g.closure_s;
  }
  EXPECT_NE(first, last);
  EXPECT_NEAR(longer, 100, 25);  // 3.5 standard deviations of a fair coin's 200 throws
}

TEST(Glottis, LaryngospasmHoldsItShutAsLongAsItIsTold) {
  Glottis g;
  g.spasm_s = 12.0;
  Cords touched(g);
  touched.until_closed(true, true);
  EXPECT_TRUE(touched.state.spasm);
  EXPECT_NEAR(touched.until_closed(false, false), 12.0, 0.1);
  EXPECT_FALSE(touched.state.spasm);
  g.spasm_from_start = true;
  Cords begun(g);
  EXPECT_EQ(begun.state.opening, 0.0);
  EXPECT_NEAR(begun.until_closed(false, false), 12.0, 0.01);
}

// Of the newborn glottis' area 69.2 % (standard deviation 4.6) lie behind the vocal processes, and its area is 7.5 mm^2
// (2.5) at a length of 5.4 mm (Sato 2015): larynges of the dead, whose cords nothing moves.
TEST(Glottis, TheGapIsAsLongAndWideAsANewbornsIs) {
  Glottis g;
  g.length_m = 0.0054;
  const double opening = Cords(g).state.opening;
  EXPECT_NEAR(1e6 * area(g, opening), 7.5, 2.5);
  double behind = 0.0, all = 0.0;
  constexpr int kSlices = 1000;
  for (int k = 0; k < kSlices; ++k) {
    const double at = g.length_m * (k + 0.5) / kSlices;
    const double slice = 2.0 * half_width(g, opening, at) * g.length_m / kSlices;
    all += slice;
    behind += at > g.front_share * g.length_m ? slice : 0.0;
  }
  EXPECT_NEAR(all, area(g, opening), 1e-3 * all);
  EXPECT_NEAR(behind / all, 0.692, 2 * 0.046);
  EXPECT_EQ(half_width(g, opening, -0.001), 0.0);
  EXPECT_EQ(half_width(g, opening, 0.006), 0.0);
  EXPECT_EQ(half_width(g, 0.0, 0.003), 0.0);
}

TEST(Glottis, TheSameTouchesGiveTheSameBitsAndATickAllocatesNothing) {
  Cords a, b;
  const long before = testing::allocations;
  for (int k = 0; k < 60000; ++k) {
    const bool touched = k / 3700 % 2 == 1, breathing = k / 9000 % 2 == 0;
    a.tick(touched, breathing);
    b.tick(touched, breathing);
    ASSERT_EQ(std::memcmp(&a.state.opening, &b.state.opening, sizeof(double)), 0);
    ASSERT_EQ(a.state.draw.state, b.state.draw.state);
  }
  EXPECT_EQ(testing::allocations - before, 0);
}

TEST(Glottis, WhatIsNotANumberIsNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Cords c;
  GlottisInput input;
  input.breathing = true;
  input.breath_phase = kNan;
  step(c.glottis, c.state, input, kTick);
  EXPECT_EQ(c.state.faults, kGlottisFaultInput);
  EXPECT_TRUE(std::isfinite(c.state.opening));
  step(c.glottis, c.state, {}, kNan);
  EXPECT_EQ(c.state.faults, kGlottisFaultInput);
  c.state.opening = kNan;
  c.tick(false);
  EXPECT_EQ(c.state.faults, kGlottisFaultState);
  c.tick(false);
  EXPECT_EQ(c.state.faults, kGlottisFaultNone);
  EXPECT_NEAR(c.state.opening, 0.55, 1e-9);
}

TEST(Glottis, WhatCannotBeIsRefused) {
  const auto refused = [](const std::function<void(Glottis&)>& spoil) {
    Glottis g;
    spoil(g);
    EXPECT_THROW(checked(g), std::invalid_argument);
  };
  EXPECT_NO_THROW(checked(Glottis{}));
  refused([](Glottis& g) { g.length_m = 0; });
  refused([](Glottis& g) { g.length_m = std::numeric_limits<double>::quiet_NaN(); });
  refused([](Glottis& g) { g.front_share = 1.2; });
  refused([](Glottis& g) { g.widest_half_slope = -1; });
  refused([](Glottis& g) { g.closure_s = -1; });
  refused([](Glottis& g) { g.spasm_s = 1e9; });
  refused([](Glottis& g) { g.spasm_from_start = true; });
  refused([](Glottis& g) {
    g.relaxed = true;
    g.spasm_s = 10;
  });
}

// An instructor's key: closed while it is held, open again as after any closure; relaxed cords are not theirs to close.
TEST(Glottis, HeldClosedFromOutsideAsInALaryngospasm) {
  for (const bool relaxed : {false, true}) {
    Glottis g;
    g.relaxed = relaxed;
    Cords cords(g);
    GlottisInput held;
    held.held_closed = true;
    const double before = cords.state.opening;
    for (int n = 0; n < 300; ++n) step(g, cords.state, held, kTick);
    EXPECT_EQ(cords.state.opening, relaxed ? before : 0.0);
    EXPECT_EQ(cords.state.spasm, !relaxed);
    for (int n = 0; n < 3000; ++n) step(g, cords.state, held, kTick);
    EXPECT_EQ(cords.state.spasm, !relaxed) << "it does not tire";
    for (int n = 0; n < 600; ++n) cords.tick(false);
    EXPECT_FALSE(cords.state.spasm);
    EXPECT_GT(cords.state.opening, 0.4);
  }
}

}  // namespace
}  // namespace vallecula::engine
